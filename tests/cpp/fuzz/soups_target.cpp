// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Booleans of two small operands: a result that passes verification or names what does not, or an error with a reason.
#include <algorithm>

#include "base/error.h"
#include "boolean/boolean.h"
#include "mesh/quality/surface_verification.h"
#include "meshes.h"

namespace mq {
namespace {

mesh::TriangleMesh operand(fuzz::Bytes& bytes) {
    const int kind = bytes.number(0, 15);
    if (kind < 2) {
        return fuzz::raw_mesh(bytes, kind == 0 ? fuzz::Numbers::Any : fuzz::Numbers::Safe);
    }
    mesh::TriangleMesh mesh = fuzz::closed_mesh(bytes);
    fuzz::place(mesh, bytes);
    if (kind > 10) {
        fuzz::damage(mesh, bytes);
    }
    return mesh;
}

bool all_single(const mesh::TriangleMesh& mesh) {
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_single);
}

void check(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, boolean::Operation operation,
           const boolean::BooleanOptions& options) {
    const boolean::BooleanResult result = boolean::boolean({&a, &b}, operation, options);
    fuzz::require(result.triangle_source.size() == result.mesh.triangles.size(), "every triangle has a source or none");
    const bool from_single = all_single(a) && all_single(b);
    fuzz::require(!from_single || all_single(result.mesh), "coordinates are single-precision numbers");
    const mesh::Verification verification = mesh::verify(result.mesh.vertices, result.mesh.triangles);
    fuzz::require(verification.passed() || !result.notes.empty(),
                  ("a result with faults says so: " + verification.summary()).c_str());
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const auto [from, index] = result.triangle_source[t];
        if (from >= 0) {
            const mesh::TriangleMesh& own = from == 0 ? a : b;
            fuzz::require(index >= 0 && static_cast<std::size_t>(index) < own.triangles.size(),
                          "a source is a triangle of an operand");
        }
    }
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    fuzz::Bytes bytes(data, size);
    const auto operation = static_cast<boolean::Operation>(bytes.number(0, 3));
    boolean::BooleanOptions options;
    if (bytes.number(0, 3) == 0) {
        options.resolution = bytes.number(8, 255);
    }
    const mesh::TriangleMesh a = operand(bytes);
    const mesh::TriangleMesh b = operand(bytes);
    try {
        check(a, b, operation, options);
    } catch (const Error&) {
        // An operand was refused, or surfaces bound no volume: with a sentence.
    }
    return 0;
}

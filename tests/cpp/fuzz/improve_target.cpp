// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Improving any mesh keeps its connections, and every triangle that stays bad is listed.
#include <set>

#include "base/error.h"
#include "improve/improve.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/triangle_quality.h"
#include "meshes.h"

namespace mq {
namespace {

void check(const mesh::TriangleMesh& given, const improve::ImproveOptions& options) {
    const improve::Result result = improve::improve(given, options);
    const mesh::MeshReport before = mesh::measure(given);
    const mesh::MeshReport after = mesh::measure(result.mesh);
    fuzz::require(!before.closed || after.closed, "what was closed stays closed");
    // A fin on edges of more than two triangles may shrink to nothing, and with it all of the border.
    fuzz::require(!before.manifold || after.closed == before.closed, "what has a border keeps it");
    fuzz::require(!before.manifold || after.manifold, "what was manifold stays so");
    fuzz::require(!before.oriented || after.oriented, "what was oriented stays so");
    fuzz::require(!before.manifold || after.components == before.components, "components stay");
    for (const Vec3& p : result.mesh.vertices) {
        fuzz::require(is_single(p), "coordinates are single-precision numbers");
    }
    std::set<std::int32_t> exempt;
    for (const auto& [t, reason] : result.exempt) {
        fuzz::require(t >= 0 && static_cast<std::size_t>(t) < result.mesh.triangles.size(),
                      "an exempt triangle is there");
        exempt.insert(t);
    }
    constexpr double kAngleRounding = 1e-6;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        const mesh::Triangle& v = result.mesh.triangles[t];
        const double angle =
            mesh::min_angle_of({result.mesh.vertices[v[0]], result.mesh.vertices[v[1]], result.mesh.vertices[v[2]]});
        fuzz::require(angle >= options.min_angle - kAngleRounding || exempt.count(static_cast<std::int32_t>(t)) > 0,
                      "triangles below the angle are listed");
    }
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    fuzz::Bytes bytes(data, size);
    improve::ImproveOptions options;
    options.min_angle = bytes.part(0.1, 34.0);
    options.feature_angle = bytes.part(1.0, 180.0);
    options.tolerance = bytes.number(0, 3) == 0 ? bytes.part(0.001, 4.0) : 0.0;
    const int kind = bytes.number(0, 3);
    mesh::TriangleMesh mesh;
    if (kind > 1) {
        mesh = fuzz::closed_mesh(bytes);
        fuzz::place(mesh, bytes);
        fuzz::damage(mesh, bytes);
    } else {
        mesh = fuzz::raw_mesh(bytes, kind == 0 ? fuzz::Numbers::Any : fuzz::Numbers::Safe);
    }
    try {
        check(mesh, options);
    } catch (const InvalidInput&) {
        // The mesh was refused with a sentence.
    }
    return 0;
}

// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Curved meshes as documents may hold them as lists: measured, cut into flat triangles and written, or refused.
#include "base/error.h"
#include "bytes.h"
#include "curve/output/curved_mesh.h"
#include "curve/output/shape_distortion.h"
#include "curve/output/tessellation.h"
#include "mesh/io/io_formats.h"
#include "mesh/quality/mesh_report.h"

namespace mq {
namespace {

using curve::CurvedMesh;

/// An index that is mostly in range.
std::int32_t index(fuzz::Bytes& bytes, std::size_t count) {
    constexpr int kStray = 253;  // of 256
    const int said = bytes.take<std::uint8_t>();
    return said >= kStray || count == 0 ? bytes.take<std::int32_t>() : said % static_cast<std::int32_t>(count);
}

/// So many elements; one time in sixteen the last one is not whole.
void add_elements(fuzz::Bytes& bytes, const CurvedMesh& mesh, int width, std::vector<std::int32_t>& nodes,
                  std::vector<std::int32_t>& entity) {
    constexpr int kMostElements = 3;
    constexpr std::size_t kEntities = 4;
    for (int e = bytes.number(0, kMostElements); e > 0; --e) {
        entity.push_back(index(bytes, kEntities));
        for (int i = bytes.number(0, 15) == 0 ? 1 : 0; i < width; ++i) {
            nodes.push_back(index(bytes, mesh.nodes.size()));
        }
    }
}

void add_qualities(fuzz::Bytes& bytes, std::size_t count, std::vector<double>& quality) {
    const int kind = bytes.number(0, 15);
    const std::size_t given = kind == 0 ? 0 : kind == 1 ? count + 1 : count;
    for (std::size_t i = 0; i < given; ++i) {
        quality.push_back(bytes.real());
    }
}

CurvedMesh curved_mesh(fuzz::Bytes& bytes) {
    constexpr int kMostNodes = 40;
    CurvedMesh mesh;
    mesh.order = bytes.number(0, 31) == 0 ? bytes.take<std::int32_t>() : bytes.number(1, elements::kMaxOrder);
    for (int i = bytes.number(0, kMostNodes); i > 0; --i) {
        mesh.nodes.push_back(bytes.point());
        mesh.node_entity.push_back({index(bytes, 4), index(bytes, 4)});
    }
    if (mesh.order >= 1 && mesh.order <= elements::kMaxOrder) {
        add_elements(bytes, mesh, mesh.nodes_per_edge(), mesh.edges, mesh.edge_entity);
        add_elements(bytes, mesh, mesh.nodes_per_triangle(), mesh.triangles, mesh.triangle_face);
        add_elements(bytes, mesh, mesh.nodes_per_tetrahedron(), mesh.tetrahedra, mesh.tetrahedron_volume);
    }
    add_qualities(bytes, mesh.triangle_face.size(), mesh.triangle_quality);
    add_qualities(bytes, mesh.tetrahedron_volume.size(), mesh.tetrahedron_quality);
    return mesh;
}

void check(const CurvedMesh& mesh, double deviation) {
    fuzz::require(curve::tetrahedra_behind(mesh).size() == mesh.triangle_face.size(), "every triangle is looked at");
    fuzz::require(!mesh::text_of(mesh::to_msh, curve::exported(mesh)).empty() &&
                      !mesh::text_of(mesh::to_vtu, curve::exported(mesh)).empty(),
                  "both formats are written");
    constexpr double kDistortionRounding = 1e-6;
    for (const double eta : curve::tetrahedron_distortions(mesh)) {
        fuzz::require(eta >= 1.0 - kDistortionRounding, "distortions of tetrahedra are at least 1");
    }
    if (!mesh.triangle_quality.empty()) {
        for (const double eta : curve::triangle_distortions(mesh)) {
            fuzz::require(eta >= 1.0 - kDistortionRounding, "distortions of triangles are at least 1");
        }
    }
    constexpr std::size_t kMostTriangles = 2'000;
    const curve::Tessellation flat = curve::tessellate(mesh, deviation, nullptr, kMostTriangles);
    mesh::measure(flat.mesh);
    fuzz::require(flat.element.size() == flat.mesh.triangles.size(), "flat triangles belong to curved ones");
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    fuzz::Bytes bytes(data, size);
    const double deviation = bytes.number(0, 1) > 0 ? bytes.part(0.0, 1.0) : 0.0;
    const curve::CurvedMesh mesh = curved_mesh(bytes);
    try {
        curve::require_sound(mesh);
        check(mesh, deviation);
    } catch (const InvalidInput&) {
        // The mesh was refused with a sentence.
    }
    return 0;
}

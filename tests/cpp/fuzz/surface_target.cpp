// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Meshes as anybody may give them as arrays: measured, verified and written, or refused.
#include <cmath>
#include <vector>

#include "base/error.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/io/io.h"
#include "mesh/io/io_formats.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/surface_verification.h"
#include "mesh/quality/triangle_quality.h"
#include "mesh/vertex_clustering.h"
#include "mesh/weld_vertices.h"
#include "meshes.h"

namespace mq {
namespace {

using mesh::TriangleMesh;

void write_all(const TriangleMesh& mesh) {
    const mesh::ExportMesh whole = mesh::exported(mesh);
    const std::string texts[] = {mesh::text_of(mesh::to_stl, whole),
                                 mesh::text_of(mesh::to_ply, whole),
                                 mesh::text_of(mesh::to_obj, whole),
                                 mesh::text_of(mesh::to_off, whole),
                                 mesh::text_of(mesh::to_msh, whole),
                                 mesh::text_of(mesh::to_vtu, whole),
                                 mesh::to_bms(mesh)};
    for (const std::string& text : texts) {
        fuzz::require(!text.empty(), "every format is written");
    }
    fuzz::require(texts[0].size() == 84 + 50 * mesh.triangles.size(), "an STL file has 50 bytes a triangle");
}

void check_shapes(const TriangleMesh& mesh) {
    constexpr double kShapeRounding = 1e-9;
    for (const mesh::Triangle& t : mesh.triangles) {
        const std::array<Vec3, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
        const mesh::TriangleShape shape = mesh::shape_of(corners);
        fuzz::require(shape.min_angle >= 0.0 && shape.min_angle <= 60.0 + kShapeRounding,
                      "a smallest angle has 0 to 60");
        fuzz::require(shape.max_angle >= shape.min_angle && shape.max_angle <= 180.0 + kShapeRounding,
                      "a largest angle has at most 180 degrees");
        fuzz::require(shape.aspect >= 1.0 && shape.distortion >= 1.0 - kShapeRounding, "ratios are at least 1");
    }
}

/// What only coordinates that predicates are exact for promise.
void check_exactly(const TriangleMesh& mesh, const mesh::MeshReport& report) {
    std::vector<mesh::ContactPair> expected;
    for (std::size_t a = 0; a < mesh.triangles.size(); ++a) {
        for (std::size_t b = a + 1; b < mesh.triangles.size(); ++b) {
            const mesh::Contact contact = mesh::contact(mesh.vertices, mesh.triangles[a], mesh.triangles[b]);
            if (contact != mesh::Contact::None) {
                expected.push_back({static_cast<int>(a), static_cast<int>(b), contact});
            }
        }
    }
    const auto found = mesh::self_intersections(mesh.vertices, mesh.triangles);
    fuzz::require(found.size() == expected.size(), "all contacts are found, and no other");
    for (std::size_t i = 0; i < found.size(); ++i) {
        fuzz::require(
            found[i].a == expected[i].a && found[i].b == expected[i].b && found[i].contact == expected[i].contact,
            "contacts are those of the pairs");
    }
    const mesh::Verification verification = mesh::verify(mesh.vertices, mesh.triangles);
    const auto count = [&](mesh::FaultKind kind) { return verification.count[static_cast<std::size_t>(kind)]; };
    fuzz::require(count(mesh::FaultKind::DegenerateTriangle) == report.degenerate_triangles,
                  "two counts of degenerate triangles agree");
    if (report.degenerate_triangles == 0) {
        fuzz::require(count(mesh::FaultKind::OpenEdge) == report.border_edges, "two counts of open edges agree");
    }
    fuzz::require(count(mesh::FaultKind::Crossing) + count(mesh::FaultKind::Touching) <= found.size(),
                  "verification finds no more contacts than there are");
    fuzz::require(!verification.summary().empty(), "a verification has a summary");
}

void check(const TriangleMesh& mesh, bool safe) {
    const mesh::MeshReport report = mesh::measure(mesh);
    fuzz::require(!mesh::to_text(report).empty(), "a report has a text");
    write_all(mesh);
    mesh::equal_vertices(mesh.vertices);
    std::vector<float> corners;
    for (const mesh::Triangle& t : mesh.triangles) {
        for (const int v : t) {
            for (int i = 0; i < 3; ++i) {
                corners.push_back(static_cast<float>(mesh.vertices[v][i]));
            }
        }
    }
    const mesh::ClusteredMesh clusters = mesh::cluster(corners.data(), mesh.triangles.size(), 8);
    fuzz::require(clusters.joined.size() == mesh.triangles.size(), "every triangle has a cluster or none");
    if (safe) {
        check_shapes(mesh);
        check_exactly(mesh, report);
    }
}

}  // namespace
}  // namespace mq

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    fuzz::Bytes bytes(data, size);
    const bool safe = bytes.number(0, 1) > 0;
    mesh::TriangleMesh mesh = fuzz::raw_mesh(bytes, safe ? fuzz::Numbers::Safe : fuzz::Numbers::Any);
    if (bytes.number(0, 7) == 0) {
        mesh.triangle_face.assign(static_cast<std::size_t>(bytes.number(0, 40)), bytes.take<std::int32_t>());
    }
    if (bytes.number(0, 7) == 0) {
        mesh.vertex_entity.assign(static_cast<std::size_t>(bytes.number(0, 24)),
                                  {bytes.take<std::int32_t>(), bytes.take<std::int32_t>()});
    }
    try {
        check(mesh, safe);
    } catch (const InvalidInput&) {
        // The mesh was refused with a sentence.
    }
    return 0;
}

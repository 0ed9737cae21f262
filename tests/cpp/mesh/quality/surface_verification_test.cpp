// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/surface_verification.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/cases.h"
#include "base/error.h"
#include "boolean/random_meshes.h"
#include "mesh/quality/mesh_report.h"

namespace mq::mesh {
namespace {

namespace fuzz = boolean::fuzz;
using fuzz::cube;
using fuzz::sphere;

Verification verified(const TriangleMesh& mesh, const std::vector<std::int32_t>* changed = nullptr) {
    return verify(mesh.vertices, mesh.triangles, changed);
}

std::size_t count(const Verification& verification, FaultKind kind) {
    return verification.count[static_cast<std::size_t>(kind)];
}

const Fault& first(const Verification& verification, FaultKind kind) {
    static const Fault kNoFault;
    for (const Fault& fault : verification.faults) {
        if (fault.kind == kind) {
            return fault;
        }
    }
    ADD_FAILURE() << "no " << name(kind);
    return kNoFault;
}

void append(TriangleMesh& mesh, const TriangleMesh& other, double scale, const Vec3& shift) {
    const auto begin = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Vec3& v : other.vertices) {
        mesh.vertices.emplace_back(scale * v + shift);
    }
    for (const Triangle& t : other.triangles) {
        mesh.triangles.push_back({t[0] + begin, t[1] + begin, t[2] + begin});
    }
}

TEST(Verification, PassesSoundMeshes) {
    fuzz::Random random(1);
    for (int i = 0; i < scaled_cases(60) + 1; ++i) {
        const TriangleMesh mesh = fuzz::closed_mesh(random);
        const Verification verification = verified(mesh);
        EXPECT_TRUE(verification.passed()) << verification.summary();
        EXPECT_NEAR(verification.volume, fuzz::signed_volume(mesh.vertices, mesh.triangles), 1e-12);
        EXPECT_EQ(verification.summary(), "none");
    }
    TriangleMesh unused = cube();
    unused.vertices.push_back(unused.vertices[0]);
    unused.vertices.push_back(unused.vertices[0]);
    EXPECT_TRUE(verified(unused).passed());
    EXPECT_TRUE(verified(TriangleMesh{}).passed());
}

TEST(Verification, FindsOpenEdges) {
    TriangleMesh mesh = cube();
    mesh.triangles.pop_back();
    const Verification verification = verified(mesh);
    EXPECT_EQ(count(verification, FaultKind::OpenEdge), 3u);
    EXPECT_EQ(verification.faults.size(), 3u);
    EXPECT_EQ(first(verification, FaultKind::OpenEdge).vertices, (std::array<std::int32_t, 2>{1, 5}));
    EXPECT_EQ(first(verification, FaultKind::OpenEdge).position, Vec3(1, 0, 0.5));
    EXPECT_EQ(verification.volume, 0.0);
    EXPECT_EQ(verification.summary(Vec3(10, 0, 0)), "open edge: 3, first at (11, 0, 0.5) mm");
}

TEST(Verification, FindsTrianglesTurnedTheWrongWay) {
    TriangleMesh mesh = cube();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    const Verification verification = verified(mesh);
    EXPECT_EQ(count(verification, FaultKind::NonmanifoldEdge), 3u);
    EXPECT_EQ(count(verification, FaultKind::OpenEdge), 0u);
}

TEST(Verification, FindsSolidsThatShareAnEdgeOrAVertex) {
    TriangleMesh edge = cube();
    append(edge, cube(), 1.0, Vec3(1, 1, 0));
    Verification verification = verified(edge);
    EXPECT_EQ(count(verification, FaultKind::CoincidentVertices), 2u);
    EXPECT_GT(count(verification, FaultKind::Touching), 0u);
    EXPECT_EQ(count(verification, FaultKind::Crossing), 0u);
    // The same with common indices.
    for (Triangle& t : edge.triangles) {
        for (std::int32_t& v : t) {
            v = v == 8 ? 3 : v == 12 ? 7 : v;
        }
    }
    verification = verified(edge);
    EXPECT_EQ(count(verification, FaultKind::NonmanifoldEdge), 1u);
    EXPECT_EQ(first(verification, FaultKind::NonmanifoldEdge).position, Vec3(1, 1, 0.5));
    EXPECT_EQ(count(verification, FaultKind::CoincidentVertices), 0u);
    TriangleMesh vertex = cube();
    append(vertex, cube(), 1.0, Vec3(1, 1, 1));
    for (Triangle& t : vertex.triangles) {
        for (std::int32_t& v : t) {
            v = v == 8 ? 7 : v;
        }
    }
    verification = verified(vertex);
    EXPECT_EQ(count(verification, FaultKind::PinchedVertex), 1u);
    EXPECT_EQ(first(verification, FaultKind::PinchedVertex).vertices[0], 7);
    EXPECT_EQ(verification.faults.size(), 1u);
}

TEST(Verification, FindsDegenerateTriangles) {
    TriangleMesh mesh = cube();
    fuzz::add_degenerate(mesh, 2);
    mesh.triangles.push_back({1, 1, 2});
    const Verification verification = verified(mesh);
    EXPECT_EQ(count(verification, FaultKind::DegenerateTriangle), 2u);
    // The halves of the divided triangle lie along the edge of the neighbour, which does not have its middle as a
    // vertex.
    EXPECT_EQ(count(verification, FaultKind::Touching), 2u);
    EXPECT_EQ(verification.faults.size(), 4u);
}

TEST(Verification, FindsCrossingsAmongTheChangedOnly) {
    TriangleMesh mesh = sphere(2);
    const auto own = static_cast<std::int32_t>(mesh.triangles.size());
    append(mesh, sphere(2), 0.5, Vec3(0.8, 0.1, 0.2));
    const Verification all = verified(mesh);
    EXPECT_GT(count(all, FaultKind::Crossing), 10u);
    EXPECT_EQ(all.faults.size(), count(all, FaultKind::Crossing));
    const Fault& fault = first(all, FaultKind::Crossing);
    EXPECT_LT(fault.triangles[0], own);
    EXPECT_GE(fault.triangles[1], own);
    EXPECT_NEAR(fault.position.norm(), 1.0, 0.2);
    const std::vector<std::int32_t> involved{fault.triangles[0]};
    std::size_t expected = 0;
    std::vector<std::int32_t> others;
    for (const Fault& f : all.faults) {
        expected += f.triangles[0] == involved[0] ? 1 : 0;
    }
    EXPECT_EQ(count(verified(mesh, &involved), FaultKind::Crossing), expected);
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangles.size()); ++t) {
        if (std::none_of(all.faults.begin(), all.faults.end(),
                         [t](const Fault& f) { return f.triangles[0] == t || f.triangles[1] == t; })) {
            others.push_back(t);
        }
    }
    EXPECT_TRUE(verified(mesh, &others).passed());
}

TEST(Verification, ListsNoMoreThanAsked) {
    TriangleMesh mesh = sphere(2);
    append(mesh, sphere(2), 1.0, Vec3(0.3, 0.2, 0.1));
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 5);
    const Verification verification = verify(mesh.vertices, mesh.triangles, nullptr, 2);
    for (std::size_t k = 0; k < kFaultKinds; ++k) {
        const auto of_kind = std::count_if(verification.faults.begin(), verification.faults.end(),
                                           [k](const Fault& f) { return static_cast<std::size_t>(f.kind) == k; });
        EXPECT_EQ(of_kind, std::min<std::ptrdiff_t>(2, verification.count[k]));
    }
    EXPECT_GT(count(verification, FaultKind::OpenEdge), 2u);
    EXPECT_GT(count(verification, FaultKind::Crossing), 0u);
}

TEST(Verification, AgreesWithTheMeshReportOnDamagedMeshes) {
    for (int seed = 1; seed <= scaled_cases(200); ++seed) {
        fuzz::Random random(seed);
        TriangleMesh mesh = fuzz::closed_mesh(random);
        const auto defect = static_cast<fuzz::Defect>(random.integer(0, int(fuzz::Defect::kCount) - 1));
        fuzz::damage(mesh, defect, random);
        const Verification verification = verified(mesh);
        const MeshReport report = measure(mesh);
        SCOPED_TRACE(std::to_string(seed) + " " + fuzz::name_of(defect));
        EXPECT_EQ(count(verification, FaultKind::OpenEdge), report.border_edges);
        // The report counts an edge of three triangles as misoriented, too.
        const std::size_t edges = count(verification, FaultKind::NonmanifoldEdge);
        EXPECT_GE(edges, std::max(report.nonmanifold_edges, report.misoriented_edges));
        EXPECT_LE(edges, report.nonmanifold_edges + report.misoriented_edges);
        EXPECT_EQ(count(verification, FaultKind::DegenerateTriangle), report.degenerate_triangles);
    }
}

TEST(Verification, IsCancelled) {
    Progress progress;
    progress.cancel();
    const TriangleMesh mesh = cube();
    EXPECT_THROW(verify(mesh.vertices, mesh.triangles, nullptr, 10, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::mesh

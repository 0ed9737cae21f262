// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/tessellation.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax2.hxx>

#include "base/error.h"
#include "curve/checks.h"
#include "curve/elements.h"
#include "geometry/occt/shape_model.h"
#include "mesh/quality/mesh_report.h"

namespace mq::curve {

using elements::Barycentric;
using elements::Lattice;

namespace {

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = std::clamp((b - a).dot(p - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
    return (p - a - t * (b - a)).norm();
}

/// The distance by the perpendicular where its foot has barycentric coordinates in [0, 1], from the sides otherwise.
double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    Eigen::Matrix<double, 3, 2> side;
    side << b - a, c - a;
    const Eigen::Vector2d uv = side.colPivHouseholderQr().solve(p - a);
    if (uv.minCoeff() >= 0.0 && uv.sum() <= 1.0) {
        return (p - a - side * uv).norm();
    }
    return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Points all over a triangle, its border included.
std::vector<Barycentric> samples(int n) {
    std::vector<Barycentric> points;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const double u = static_cast<double>(i) / n;
            const double v = static_cast<double>(j) / n;
            points.push_back({1.0 - u - v, u, v, 0.0});
        }
    }
    return points;
}

/// The largest distance of points on curved triangles from the flat triangles that replace them.
double measured_deviation(const CurvedMesh& mesh, const Tessellation& flat) {
    const Lattice& lattice = Lattice::of(2, mesh.order);
    std::vector<std::vector<std::size_t>> parts(mesh.triangle_face.size());
    for (std::size_t i = 0; i < flat.element.size(); ++i) {
        parts[static_cast<std::size_t>(flat.element[i])].push_back(i);
    }
    const auto point = [&](std::size_t triangle, std::size_t k) -> Vec3 {
        return flat.mesh.vertices[static_cast<std::size_t>(flat.mesh.triangles[triangle][k])] + flat.mesh.origin;
    };
    double most = 0.0;
    for (std::size_t t = 0; t < parts.size(); ++t) {
        const auto control = elements::nodes_to_bezier(lattice, nodes_of(mesh, mesh.triangles, t, lattice));
        for (const Barycentric& at : samples(9)) {
            const Vec3 p = elements::value(lattice, control, at);
            double nearest = 1e300;
            for (const std::size_t i : parts[t]) {
                nearest = std::min(nearest, distance_to_triangle(p, point(i, 0), point(i, 1), point(i, 2)));
            }
            most = std::max(most, nearest);
        }
    }
    return most;
}

/// Each run of vertices follows edges of the triangles, and they are as many as the curved triangles have edges.
void expect_edge_lines(const CurvedMesh& mesh, const Tessellation& flat) {
    std::set<elements::EdgeKey> edges;
    for (const mesh::Triangle& t : flat.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.insert(pair_key(t[k], t[(k + 1) % 3]));
        }
    }
    std::set<elements::EdgeKey> sides;
    const auto width = static_cast<std::size_t>(mesh.nodes_per_triangle());
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            sides.insert(pair_key(mesh.triangles[t * width + k], mesh.triangles[t * width + (k + 1) % 3]));
        }
    }
    std::size_t runs = 0;
    for (std::size_t i = 0; i + 1 < flat.edge_lines.size(); ++i) {
        if (flat.edge_lines[i] >= 0 && flat.edge_lines[i + 1] >= 0) {
            EXPECT_EQ(edges.count(pair_key(flat.edge_lines[i], flat.edge_lines[i + 1])), 1u);
        }
    }
    for (const std::int32_t v : flat.edge_lines) {
        runs += v < 0 ? 1 : 0;
    }
    EXPECT_EQ(runs, sides.size());
}

TEST(Tessellation, KeepsWithinTheDeviationAndStaysClosed) {
    const auto sphere = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    const auto torus = geometry::make_shape_model(BRepPrimAPI_MakeTorus(2.0, 0.6).Shape());
    for (const auto& model : {sphere, torus}) {
        for (int order = 1; order <= 5; ++order) {
            const CurvedMesh mesh = curved(model, of_order(order), 1.0);
            for (const double deviation : {0.1, 0.005}) {
                const Tessellation flat = tessellate(mesh, deviation);
                EXPECT_EQ(flat.deviation, deviation);
                EXPECT_LE(measured_deviation(mesh, flat), deviation * 1.0001) << order;
                const mesh::MeshReport report = mesh::measure(flat.mesh);
                EXPECT_TRUE(report.closed && report.oriented && report.manifold) << order << " " << deviation;
                EXPECT_GT(report.volume, 0.0);
                expect_edge_lines(mesh, flat);
            }
        }
    }
}

TEST(Tessellation, NormalsAreThoseOfTheCurvedCurvedSurface) {
    const CurvedMesh mesh = curved(geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape()), of_order(4), 0.5);
    const Tessellation flat = tessellate(mesh, 0.01);
    ASSERT_EQ(flat.triangle_normals.size(), 3 * flat.mesh.triangles.size());
    for (std::size_t t = 0; t < flat.mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = flat.mesh.vertices[static_cast<std::size_t>(flat.mesh.triangles[t][k])];
            const Vec3& n = flat.normals[static_cast<std::size_t>(flat.triangle_normals[3 * t + k])];
            EXPECT_NEAR(n.norm(), 1.0, 1e-12);
            EXPECT_GT(n.dot(p), 1.0 - 1e-4);
        }
    }
}

TEST(Tessellation, CutsOnlyWhereThereIsABend) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 4.0).Shape());
    const CurvedMesh mesh = curved(model, of_order(3), 1.0);
    EXPECT_EQ(tessellate(mesh, 1.0).mesh.triangles.size(), mesh.triangle_face.size());
    const Tessellation flat = tessellate(mesh, 1e-3);
    const Lattice& lattice = Lattice::of(2, mesh.order);
    std::vector<int> parts(mesh.triangle_face.size(), 0);
    for (const std::int32_t element : flat.element) {
        ++parts[static_cast<std::size_t>(element)];
    }
    int straight = 0;
    for (std::size_t t = 0; t < parts.size(); ++t) {
        const auto nodes = nodes_of(mesh, mesh.triangles, t, lattice);
        double bend = 0.0;
        for (int i = 0; i < lattice.size(); ++i) {
            const Barycentric b = lattice.node(i);
            const Vec3 flat_point = b[0] * nodes[static_cast<std::size_t>(lattice.corner(0))] +
                                    b[1] * nodes[static_cast<std::size_t>(lattice.corner(1))] +
                                    b[2] * nodes[static_cast<std::size_t>(lattice.corner(2))];
            bend = std::max(bend, (nodes[static_cast<std::size_t>(i)] - flat_point).norm());
        }
        if (bend < 1e-9) {
            ++straight;
            EXPECT_EQ(parts[t], 1);
        }
    }
    EXPECT_GT(straight, 0);
}

TEST(Tessellation, TakesFewTriangles) {
    const CurvedMesh mesh = curved(geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape()), of_order(3), 1.0);
    for (const double deviation : {1e-2, 1e-3, 1e-4}) {
        // Equilateral triangles with corners on the sphere, whose middles deviate by exactly the deviation.
        const double ideal = 4.0 * M_PI / (1.5 * std::sqrt(3.0) * deviation);
        EXPECT_LT(static_cast<double>(tessellate(mesh, deviation).mesh.triangles.size()), 4.0 * ideal) << deviation;
    }
}

TEST(Tessellation, OrderOneStaysAsItIs) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    const CurvedMesh mesh = curved(model, of_order(1));
    const Tessellation flat = tessellate(mesh, 1e-6);
    EXPECT_EQ(flat.mesh.triangles.size(), mesh.triangle_face.size());
}

/// Two triangles of order q with a common side.
CurvedMesh pair_of(int order, double size, std::mt19937& random) {
    const Lattice& lattice = Lattice::of(2, order);
    CurvedMesh mesh;
    mesh.order = order;
    const std::vector<int> gmsh = elements::gmsh_order(lattice);
    std::map<std::array<int, 2>, int> known;  // by place in a square
    for (int half = 0; half < 2; ++half) {
        for (const int i : gmsh) {
            const elements::Exponents& e = lattice.exponents(i);
            const std::array<int, 2> place =
                half == 0 ? std::array<int, 2>{e[1], e[2]} : std::array<int, 2>{order - e[1], order - e[2]};
            const auto [found, fresh] = known.try_emplace(place, static_cast<int>(mesh.nodes.size()));
            if (fresh) {
                const Vec3 flat(static_cast<double>(place[0]) / order, static_cast<double>(place[1]) / order, 0.0);
                mesh.nodes.push_back(perturbed({flat}, size, random)[0]);
            }
            mesh.triangles.push_back(found->second);
        }
        mesh.triangle_face.push_back(half);
    }
    return mesh;
}

TEST(Tessellation, HoldsOnWildPatchesToo) {
    std::mt19937 random(7);
    for (int round = 0; round < 12; ++round) {
        for (int order = 2; order <= 5; ++order) {
            const CurvedMesh mesh = pair_of(order, 0.2, random);
            const Tessellation flat = tessellate(mesh, 0.01);
            EXPECT_LE(measured_deviation(mesh, flat), 0.0101);
            const mesh::MeshReport report = mesh::measure(flat.mesh);
            EXPECT_EQ(report.nonmanifold_edges + report.misoriented_edges + report.pinched_vertices, 0u);
            EXPECT_EQ(report.components, 1u);
            EXPECT_EQ(report.euler, 1) << "a disc";
            expect_edge_lines(mesh, flat);
        }
    }
}

TEST(Tessellation, ABumpInsideStraightSides) {
    std::mt19937 random(1);
    CurvedMesh mesh = pair_of(3, 0.0, random);
    mesh.nodes[static_cast<std::size_t>(mesh.triangles[9])].z() = 0.3;  // Gmsh's last node of ten: the inner one
    const Tessellation flat = tessellate(mesh, 0.01);
    EXPECT_LE(measured_deviation(mesh, flat), 0.0101);
    EXPECT_EQ(flat.edge_lines.size(), 5u * 3u) << "no side was cut";
    EXPECT_GT(flat.mesh.triangles.size(), 10u);
    EXPECT_EQ(flat.element.back(), 1) << "the flat neighbour stays whole";
    EXPECT_EQ(std::count(flat.element.begin(), flat.element.end(), 1), 1);
}

TEST(Tessellation, FarFromTheOriginNothingIsLost) {
    const gp_Ax2 far(gp_Pnt(1e6, -2e6, 3e6), gp::DZ());
    const CurvedMesh mesh = curved(geometry::make_shape_model(BRepPrimAPI_MakeSphere(far, 1.0).Shape()), of_order(2));
    const Tessellation flat = tessellate(mesh, 0.002);
    EXPECT_GT(flat.mesh.origin.norm(), 1e6);
    EXPECT_LE(measured_deviation(mesh, flat), 0.00201);
}

TEST(Tessellation, RefusesTooManyTrianglesAndCanBeCancelled) {
    const CurvedMesh mesh = curved(geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape()), of_order(2));
    EXPECT_THROW(tessellate(mesh, 1e-5, nullptr, 1000), InvalidInput);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(tessellate(mesh, 1e-5, &progress), Cancelled);
}

// By estimates before anything is divided, which are three times too large at most.
TEST(Tessellation, RefusesTooManyTrianglesBeforeTheWork) {
    const auto sphere = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    const auto cylinder = geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 5.0).Shape());
    for (const auto& model : {sphere, cylinder}) {
        for (int order = 2; order <= 4; ++order) {
            const CurvedMesh mesh = curved(model, of_order(order));
            const std::size_t count = tessellate(mesh, 1e-3).mesh.triangles.size();
            SCOPED_TRACE(std::to_string(order) + " " + std::to_string(count));
            EXPECT_EQ(tessellate(mesh, 1e-3, nullptr, 3 * count).mesh.triangles.size(), count);
            EXPECT_THROW(tessellate(mesh, 1e-3, nullptr, count - 1), InvalidInput);
        }
    }
}

TEST(TetrahedraBehind, EveryBoundaryTriangleHasItsOwn) {
    const CurvedMesh mesh =
        curved(geometry::make_shape_model(BRepPrimAPI_MakeTorus(2.0, 0.6).Shape()), of_order(2, true));
    const std::vector<std::int32_t> behind = tetrahedra_behind(mesh);
    ASSERT_EQ(behind.size(), mesh.triangle_face.size());
    ASSERT_EQ(mesh.tetrahedron_quality.size(), mesh.tetrahedron_volume.size());
    ASSERT_EQ(mesh.triangle_quality.size(), mesh.triangle_face.size());
    const auto width = static_cast<std::size_t>(mesh.nodes_per_tetrahedron());
    for (std::size_t t = 0; t < behind.size(); ++t) {
        ASSERT_GE(behind[t], 0);
        const std::int32_t* corners = &mesh.tetrahedra[static_cast<std::size_t>(behind[t]) * width];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t corner = mesh.triangles[t * static_cast<std::size_t>(mesh.nodes_per_triangle()) + k];
            EXPECT_EQ(std::count(corners, corners + 4, corner), 1);
        }
    }
    EXPECT_EQ(*std::min_element(mesh.tetrahedron_quality.begin(), mesh.tetrahedron_quality.end()),
              mesh.report.min_scaled_jacobian);
}

}  // namespace
}  // namespace mq::curve

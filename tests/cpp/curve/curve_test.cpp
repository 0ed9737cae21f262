// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/curve.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "curve/gmsh_order.h"
#include "curve/validity.h"
#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"
#include "triangulate/triangulate.h"

namespace mq::curve {
namespace {

CurvedMesh curved(const std::shared_ptr<geometry::Model>& model, const Options& options, double max_edge = 0.0) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    triangulate::Options straight;
    straight.min_angle = 20.0;
    straight.max_edge = max_edge;
    straight.chord_height_relative = max_edge > 0.0 ? 0.0 : 0.02;
    return curve(engine, model, triangulate::triangulate(engine, model, straight).mesh, options);
}

Options of_order(int order, bool volume = false) {
    Options options;
    options.order = order;
    options.volume = volume;
    return options;
}

std::vector<Vec3> nodes_of(const CurvedMesh& mesh, const std::vector<std::int32_t>& list, std::size_t element,
                           const Lattice& lattice) {
    const std::vector<int> order = gmsh_order(lattice);
    std::vector<Vec3> nodes(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto node = static_cast<std::size_t>(list[element * order.size() + i]);
        nodes[static_cast<std::size_t>(order[i])] = mesh.nodes[node];
    }
    return nodes;
}

/// Integral of the Jacobian over all tetrahedra: the volume of what the mesh covers, overlaps counted twice.
double volume_of(const CurvedMesh& mesh) {
    const Lattice& lattice = Lattice::of(3, mesh.order);
    double sum = 0.0;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        const JacobianForm form =
            jacobian_of(lattice, nodes_to_bezier(lattice, nodes_of(mesh, mesh.tetrahedra, e, lattice)));
        double mean = 0.0;
        for (const double c : form.coefficients) {
            mean += c / static_cast<double>(form.coefficients.size());
        }
        sum += mean / 6.0;
    }
    return sum;
}

std::size_t invalid_tetrahedra(const CurvedMesh& mesh) {
    const Lattice& lattice = Lattice::of(3, mesh.order);
    std::size_t invalid = 0;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        const auto control = nodes_to_bezier(lattice, nodes_of(mesh, mesh.tetrahedra, e, lattice));
        invalid += check_positive(jacobian_of(lattice, control)).valid ? 0 : 1;
    }
    return invalid;
}

/// Every face of a tetrahedron belongs to two of them with the same nodes, or to one and a boundary triangle.
void expect_conforming(const CurvedMesh& mesh) {
    const Lattice& lattice = Lattice::of(3, mesh.order);
    const std::vector<int> order = gmsh_order(lattice);
    std::map<std::set<int>, std::set<std::size_t>> faces;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            std::set<int> face;
            for (std::size_t i = 0; i < order.size(); ++i) {
                if (lattice.exponents(order[i])[opposite] == 0) {
                    face.insert(mesh.tetrahedra[e * order.size() + i]);
                }
            }
            faces[face].insert(e);
        }
    }
    std::set<std::set<int>> boundary;
    const auto per = static_cast<std::size_t>(mesh.nodes_per_triangle());
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        boundary.insert({mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t * per),
                         mesh.triangles.begin() + static_cast<std::ptrdiff_t>((t + 1) * per)});
    }
    EXPECT_EQ(boundary.size(), mesh.triangle_face.size());
    for (const auto& [face, elements] : faces) {
        EXPECT_EQ(elements.size(), boundary.count(face) > 0 ? 1u : 2u);
    }
}

std::shared_ptr<geometry::Model> sphere() {
    return geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
}

TEST(CurveSurface, DeviationFallsWithTheOrderPlusOne) {
    for (int order = 1; order <= 5; ++order) {
        const CurvedMesh coarse = curved(sphere(), of_order(order), 0.5);
        const CurvedMesh fine = curved(sphere(), of_order(order), 0.25);
        EXPECT_EQ(coarse.report.invalid, 0u);
        EXPECT_EQ(fine.report.invalid, 0u);
        const double h =
            std::sqrt(static_cast<double>(fine.report.elements) / static_cast<double>(coarse.report.elements));
        const double rate = std::log(coarse.report.rms_deviation / fine.report.rms_deviation) / std::log(h);
        EXPECT_GT(rate, order + 0.8) << "order " << order;
    }
}

TEST(CurveSurface, NodesLieOnTheSphere) {
    for (int order = 2; order <= 5; ++order) {
        const CurvedMesh mesh = curved(sphere(), of_order(order));
        for (const Vec3& node : mesh.nodes) {
            EXPECT_NEAR(node.norm(), 1.0, 1e-12);
        }
    }
}

TEST(CurveSurface, SeamsAndPeriodsOfATorus) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeTorus(2.0, 0.6).Shape());
    for (int order = 2; order <= 4; ++order) {
        const CurvedMesh mesh = curved(model, of_order(order));
        EXPECT_EQ(mesh.report.invalid, 0u);
        EXPECT_GT(mesh.report.min_distortion, 0.3);
        for (const Vec3& p : mesh.nodes) {
            EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 2.0, p.z()), 0.6, 1e-10);
        }
    }
}

TEST(CurveSurface, ApexOfACone) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeCone(1.0, 0.0, 2.0).Shape());
    for (int order = 2; order <= 4; ++order) {
        const CurvedMesh mesh = curved(model, of_order(order));
        EXPECT_EQ(mesh.report.invalid, 0u) << to_text(mesh.report);
        for (const Vec3& p : mesh.nodes) {
            const double on_side = std::hypot(p.x(), p.y()) - 0.5 * (2.0 - p.z());
            EXPECT_LT(std::min(std::abs(on_side), std::abs(p.z())), 1e-10);
        }
    }
}

TEST(CurveSurface, EveryPartIsValidAtOrderTwo) {
    for (const geometry::Part& part : geometry::shape_parts()) {
        const CurvedMesh mesh = curved(part.model, of_order(2));
        EXPECT_EQ(mesh.report.invalid, 0u) << part.name << "\n" << to_text(mesh.report);
    }
}

TEST(CurveVolume, SolidsAreValidConformingAndOfTheRightVolume) {
    struct Case {
        const char* name;
        TopoDS_Shape shape;
        double volume;
    };
    const std::vector<Case> cases{
        {"sphere", BRepPrimAPI_MakeSphere(1.0).Shape(), 4.0 * M_PI / 3.0},
        {"torus", BRepPrimAPI_MakeTorus(1.0, 0.35).Shape(), 2.0 * M_PI * M_PI * 0.35 * 0.35},
        {"cylinder", BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape(), 2.0 * M_PI},
    };
    for (const Case& c : cases) {
        for (int order = 1; order <= 4; ++order) {
            const CurvedMesh mesh = curved(geometry::make_shape_model(c.shape), of_order(order, true));
            EXPECT_EQ(mesh.report.invalid, 0u) << c.name << " " << order << "\n" << to_text(mesh.report);
            EXPECT_EQ(invalid_tetrahedra(mesh), mesh.report.invalid) << c.name << " " << order;
            const double volume = volume_of(mesh);
            EXPECT_NEAR(volume, mesh.report.volume, 1e-9);
            EXPECT_NEAR(volume, c.volume, c.volume * (order == 1 ? 0.1 : 2e-3)) << c.name << " " << order;
            expect_conforming(mesh);
        }
    }
}

TEST(CurveVolume, TheSurfaceStaysAsItIs) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeTorus(1.0, 0.35).Shape());
    const CurvedMesh surface = curved(model, of_order(2));
    const CurvedMesh volume = curved(model, of_order(2, true));
    ASSERT_EQ(surface.triangle_face.size(), volume.triangle_face.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const Vec3& a = surface.nodes[static_cast<std::size_t>(surface.triangles[i])];
        const Vec3& b = volume.nodes[static_cast<std::size_t>(volume.triangles[i])];
        EXPECT_EQ(a, b);
    }
}

TEST(CurveVolume, TheSameInputGivesTheSameBytes) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeTorus(1.0, 0.35).Shape());
    EXPECT_EQ(to_msh(curved(model, of_order(3, true))), to_msh(curved(model, of_order(3, true))));
}

TEST(Curve, RefusesWhatItCannotDo) {
    EXPECT_THROW(curved(sphere(), of_order(0)), InvalidInput);
    EXPECT_THROW(curved(sphere(), of_order(6)), InvalidInput);
    EXPECT_THROW(curved(sphere(), of_order(5, true)), InvalidInput);
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    mesh::TriangleMesh unclassified;
    unclassified.vertices.resize(3);
    unclassified.triangles.push_back({0, 1, 2});
    EXPECT_THROW(curve(engine, sphere(), unclassified, of_order(2)), InvalidInput);
}

TEST(Curve, CanBeCancelled) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    const mesh::TriangleMesh straight = triangulate::triangulate(engine, sphere()).mesh;
    Progress progress;
    progress.cancel();
    EXPECT_THROW(curve(engine, sphere(), straight, of_order(2), &progress), Cancelled);
}

}  // namespace
}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/curve_given.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <map>
#include <set>

#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"
#include "given/simplices/given.h"
#include "given/simplices/measure_given.h"

namespace mq::given {

using curve::curved;
using curve::CurvedMesh;
using curve::of_order;
using curve::to_text;

namespace {

CurvedMesh curved_anew(const std::shared_ptr<geometry::Model>& model, const GivenMesh& given, int order) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    return curve_given(engine, model, given, of_order(order));
}

/// The same mesh without a word on its bodies.
GivenMesh single_body(GivenMesh mesh) {
    mesh.triangles.clear();
    mesh.regions.clear();
    return mesh;
}

TEST(CurveGiven, TetrahedraAreValidConformingAndMostlyTheGivenOnes) {
    const std::vector<std::pair<const char*, TopoDS_Shape>> cases{
        {"sphere", BRepPrimAPI_MakeSphere(1.0).Shape()},
        {"torus", BRepPrimAPI_MakeTorus(1.0, 0.35).Shape()},
        {"cylinder", BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()},
        {"two solids with a common face", geometry::twin_solids()}};
    for (const auto& [name, shape] : cases) {
        const auto model = geometry::make_shape_model(shape);
        const GivenMesh given = given_of(curved(model, of_order(1, true)));
        for (int order = 1; order <= 4; ++order) {
            const CurvedMesh mesh = curved_anew(model, given, order);
            EXPECT_EQ(mesh.report.invalid, 0u) << name << " " << order << "\n" << to_text(mesh.report);
            if (given.triangles.size() == surface_of(single_body(given)).size()) {
                curve::expect_conforming(mesh);  // what it knows is for one body
            }
            EXPECT_NEAR(volume_of(mesh), mesh.report.volume, 1e-9) << name << " " << order;
            const auto kept = std::count_if(mesh.given_element.begin(), mesh.given_element.end(),
                                            [](std::int32_t element) { return element >= 0; });
            EXPECT_GT(kept, 0.9 * static_cast<double>(given.tetrahedra.size())) << name << " " << order;
            for (std::size_t v = 0; v < mesh.vertices; ++v) {
                const std::int32_t node = mesh.given_node[v];
                const bool listed = std::binary_search(mesh.moved_nodes.begin(), mesh.moved_nodes.end(), node);
                EXPECT_TRUE(node < 0 || listed || mesh.nodes[v] == given.nodes[static_cast<std::size_t>(node)]);
            }
        }
    }
}

TEST(CurveGiven, ElementsThatTheGivenProgramLeftInvertedAreReplaced) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape());
    const CurvedMesh straight = curved(model, of_order(1, true));
    GivenMesh given = given_of(straight);
    std::size_t inner = 0;
    while (inner < straight.vertices && straight.node_entity[inner][0] != 3) {
        ++inner;
    }
    ASSERT_LT(inner, straight.vertices);
    given.nodes[inner] += Vec3(0.5, 0.3, 0.2);  // through the elements beside
    const CurvedMesh mesh = curved_anew(model, given, 2);
    EXPECT_EQ(mesh.report.invalid, 0u) << to_text(mesh.report);
    curve::expect_conforming(mesh);
    EXPECT_NEAR(volume_of(mesh), mesh.report.volume, 1e-9);
}

TEST(CurveGiven, SurfacesOfTrianglesAreCurved) {
    for (const geometry::Part& part : geometry::shape_parts()) {
        const GivenMesh given = given_of(curved(part.model, of_order(1)));
        const CurvedMesh mesh = curved_anew(part.model, given, 2);
        EXPECT_EQ(mesh.report.invalid, 0u) << part.name << "\n" << to_text(mesh.report);
    }
}

/// Nodes in the same place become one, as mesh generators do that know a place once.
void merge_places(GivenMesh& mesh) {
    std::map<std::array<double, 3>, int> known;
    for (auto& triangle : mesh.triangles) {
        for (int& v : triangle) {
            const Vec3 p = mesh.nodes[static_cast<std::size_t>(v)] * 1e9;
            v = known.emplace(std::array<double, 3>{std::round(p.x()), std::round(p.y()), std::round(p.z())}, v)
                    .first->second;
        }
    }
}

TEST(CurveGiven, SurfacesOfBodiesThatTouchAreSeparated) {
    const BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    for (const double foot : {0.0, 2.0}) {
        const gp_Ax2 axis(gp_Pnt(0.0, 0.0, foot), gp_Dir(0.0, 0.0, 1.0));
        builder.Add(both, BRepPrimAPI_MakeCylinder(axis, 1.0, 2.0).Shape());
    }
    const auto model = geometry::make_shape_model(both);
    GivenMesh given = given_of(curved(model, of_order(1)));
    const std::vector<std::array<int, 3>> apart = given.triangles;
    merge_places(given);
    ASSERT_NE(given.triangles, apart);
    const CurvedMesh mesh = curved_anew(model, given, 2);
    EXPECT_EQ(mesh.report.invalid, 0u) << to_text(mesh.report);
    EXPECT_TRUE(mesh.moved_nodes.empty());
    EXPECT_EQ(mesh.triangles.size(), given.triangles.size() * 6);
    std::set<std::array<double, 3>> places;
    for (std::size_t v = 0; v < mesh.vertices; ++v) {
        const Vec3& p = mesh.nodes[v];
        EXPECT_EQ(p, given.nodes[static_cast<std::size_t>(mesh.given_node[v])]);
        places.insert({p.x(), p.y(), p.z()});
    }
    EXPECT_LT(places.size(), mesh.vertices);  // each body has nodes of its own
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    std::vector<std::int32_t> corners;
    for (const auto& t : given.triangles) {
        corners.insert(corners.end(), t.begin(), t.end());
    }
    const GivenSurfaceMeasures found = measure_given_surface(engine, model, given.nodes, 1, corners);
    EXPECT_EQ(std::set<std::int32_t>(found.face.begin(), found.face.end()).size(), 6u);
}

TEST(MeasureGiven, KnowsWhatTheMeshIsLike) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeSphere(1.0).Shape());
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    for (int order = 1; order <= 4; ++order) {
        const CurvedMesh mesh = curved(model, of_order(order));
        const GivenSurfaceMeasures found = measure_given_surface(engine, model, mesh.nodes, order, mesh.triangles);
        ASSERT_EQ(found.face, mesh.triangle_face);
        EXPECT_NEAR(*std::max_element(found.deviation.begin(), found.deviation.end()), mesh.report.max_deviation, 1e-9);
        for (std::size_t t = 0; t < found.quality.size(); ++t) {
            EXPECT_NEAR(found.quality[t], mesh.triangle_quality[t], 1e-6);
        }
    }
}

}  // namespace
}  // namespace mq::given

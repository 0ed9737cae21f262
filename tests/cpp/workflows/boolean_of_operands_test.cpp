// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/boolean_of_operands.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <cmath>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "workflows/operands/triangulate_shape.h"

namespace mq::workflows {
namespace {

using boolean::BooleanOptions;
using boolean::Expression;
using boolean::Operation;

class Booleans : public testing::Test {
  protected:
    BooleanSurface run(const std::vector<BooleanOperand>& operands, Operation operation,
                       const BooleanOptions& options = {}, BooleanMethod method = BooleanMethod::Exact) {
        return boolean_of_operands(engine, operands, Expression::chain(operation, static_cast<int>(operands.size())),
                                   options, method, before, progress);
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    Progress progress;
    WorkBefore before;
    triangulate::Result a{boolean::solids::box(Vec3(0, 0, 0), Vec3(2, 2, 2)), {}};
    triangulate::Result b{boolean::solids::box(Vec3(1, 1, 1), Vec3(3, 3, 3)), {}};
};

TEST(BooleanTolerance, IsTheOneThatWasRequestedElseThatOfTheResolution) {
    BooleanOptions options;
    options.resolution = 100;
    EXPECT_DOUBLE_EQ(options.tolerance_for(50.0), std::sqrt(3.0) * 0.5);
    options.tolerance = 0.25;
    EXPECT_EQ(options.tolerance_for(50.0), 0.25);
}

TEST_F(Booleans, AreMeasuredAndKeepTheirOriginInTheOperands) {
    const BooleanSurface result = run({{&a}, {&b}}, Operation::Union);
    EXPECT_TRUE(result.figures.closed);
    EXPECT_NEAR(result.figures.volume, 15.0, 1e-6);
    EXPECT_EQ(result.report.triangles, result.figures.triangles);
    EXPECT_TRUE(met(result.figures));
    EXPECT_DOUBLE_EQ(result.figures.tolerance_asked, std::sqrt(3.0) * 3.0 / 512);
    ASSERT_EQ(result.triangle_source.size(), result.mesh.triangles.size());
    EXPECT_EQ(result.figures.retained + result.figures.reconstructed, result.mesh.triangles.size());
}

TEST_F(Booleans, PiecesAreOnTheFacesOfTheirTriangles) {
    for (triangulate::Result* box : {&a, &b}) {
        for (std::size_t t = 0; t < box->mesh.triangles.size(); ++t) {
            box->mesh.triangle_face.push_back(static_cast<std::int32_t>(t) + (box == &b ? 12 : 0));
        }
    }
    for (const Operation operation : {Operation::Union, Operation::Difference, Operation::SymmetricDifference}) {
        BooleanSurface result = run({{&a}, {&b}}, operation);
        EXPECT_TRUE(result.mesh.triangle_face.empty());
        name_faces(result, {&a, &b});
        ASSERT_EQ(result.mesh.triangle_face.size(), result.mesh.triangles.size());
        ASSERT_GT(result.figures.reconstructed, 0u);
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const auto face = static_cast<std::size_t>(result.mesh.triangle_face[t]);
            const mesh::TriangleMesh& own = face < 12 ? a.mesh : b.mesh;
            const auto corner = [&](const mesh::TriangleMesh& m, std::size_t i, std::size_t k) {
                return m.vertices[static_cast<std::size_t>(m.triangles[i][k])];
            };
            const Vec3 p = corner(own, face % 12, 0);
            const Vec3 normal = (corner(own, face % 12, 1) - p).cross(corner(own, face % 12, 2) - p).normalized();
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_LE(std::abs(normal.dot(corner(result.mesh, t, k) - p)), result.figures.error_bound);
            }
            if (result.triangle_source[t][0] >= 0) {
                EXPECT_EQ(result.triangle_source[t], result.triangle_origin[t]);
            }
        }
    }
}

TEST_F(Booleans, WithoutFacesOfOperandsThereAreNone) {
    BooleanSurface result = run({{&a}, {&b}}, Operation::Union);
    name_faces(result, {&a, &b});
    EXPECT_TRUE(result.mesh.triangle_face.empty());
}

TEST_F(Booleans, WhatWasDoneBeforeComesFirstInTheReport) {
    before = {{{"meshing shapes", 1.5}}, {Message::value("operand A is a shape")}, 3.0};
    const BooleanSurface result = run({{&a}, {&b}}, Operation::Intersection);
    EXPECT_EQ(result.figures.seconds.front().first, "meshing shapes");
    EXPECT_EQ(result.figures.seconds.back().first, "measuring");
    EXPECT_EQ(result.figures.notes.front().text(), "operand A is a shape");
    EXPECT_GE(result.figures.cpu_seconds, 3.0);
}

TEST_F(Booleans, EmptyResultsSaySo) {
    const triangulate::Result far{boolean::solids::box(Vec3(9, 9, 9), Vec3(10, 10, 10)), {}};
    const BooleanSurface nothing = run({{&a}, {&far}}, Operation::Intersection);
    EXPECT_TRUE(nothing.mesh.triangles.empty());
    EXPECT_EQ(nothing.figures.notes.back().text(), "the result is empty: no volume is left");
    const BooleanSurface same = run({{&a}, {&a}}, Operation::SymmetricDifference);
    EXPECT_TRUE(same.mesh.triangles.empty());
    EXPECT_NE(same.figures.notes.back().text().find("the same within the tolerance of"), std::string::npos);
}

TEST_F(Booleans, ResultsOfShapesLieOnTheirSurfaces) {
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, 0), gp_Pnt(3, 3, 2)).Shape();
    const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.1, 0.2, -1), gp::DZ()), 1.0, 4.0).Shape();
    triangulate::TriangulateOptions options;
    options.chord_height = 0.02;
    const triangulate::Result mesh_of_block = triangulate_shape(engine, block, options, progress);
    const triangulate::Result mesh_of_shaft = triangulate_shape(engine, shaft, options, progress);
    BooleanOptions tolerance;
    tolerance.tolerance = 0.05;
    const BooleanSurface result =
        run({{&mesh_of_block, false, &block}, {&mesh_of_shaft, false, &shaft}}, Operation::Difference, tolerance);
    EXPECT_TRUE(result.figures.closed);
    EXPECT_GT(result.figures.fitted_vertices, 0u);
    EXPECT_LE(result.figures.error_bound, 0.05);
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        if (result.triangle_source[t][0] >= 0) {
            continue;
        }
        for (const int v : result.mesh.triangles[t]) {
            const Vec3 p = result.mesh.vertices[static_cast<std::size_t>(v)] + result.mesh.origin;
            const double off_shaft = std::abs(std::hypot(p.x() - 0.1, p.y() - 0.2) - 1.0);
            const double off_block =
                std::min({std::abs(p.z()), std::abs(p.z() - 2.0), 3.0 - std::max(std::abs(p.x()), std::abs(p.y()))});
            EXPECT_LT(std::min(off_shaft, off_block), 1e-5);
        }
    }
}

TEST_F(Booleans, TheUniformMethodTakesAnyNumberOfOperands) {
    const BooleanSurface result = run({{&a}, {&b}}, Operation::Union, {}, BooleanMethod::Uniform);
    EXPECT_TRUE(result.figures.closed);
    EXPECT_NEAR(result.figures.volume, 15.0, 0.1);
    EXPECT_GT(result.figures.tolerance_asked, 0.0);
    EXPECT_EQ(result.figures.method, "uniform");
    const BooleanSurface three = run({{&a}, {&b}, {&a}}, Operation::Union, {}, BooleanMethod::Uniform);
    EXPECT_TRUE(three.figures.closed);
    EXPECT_NEAR(three.figures.volume, result.figures.volume, 1e-6);
    BooleanOptions wrong;
    wrong.resolution = -1;
    EXPECT_THROW(run({{&a}, {&b}}, Operation::Union, wrong), InvalidInput);
}

}  // namespace
}  // namespace mq::workflows

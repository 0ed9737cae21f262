// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <chrono>
#include <cmath>
#include <thread>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/parts.h"
#include "layered_depth/samples/face_samples.h"
#include "layered_depth/samples/rasterise.h"
#include "triangulate/triangulate.h"
#include "workflows/boolean_of_operands.h"
#include "workflows/operands/triangulate_shape.h"

/// Rays that meet the CAD faces of shapes, from their meshes on: the parts that triangulations are tested on, and
/// Booleans.
namespace mq::workflows {
namespace {

using layered_depth::FaceSampleCounts;
using layered_depth::LayeredDepthImage;
using layered_depth::LayeredDepthSet;
using layered_depth::OperandSet;
using layered_depth::SampleGrid;

Box box_of(const mesh::TriangleMesh& mesh) {
    Box box;
    for (const Vec3& p : mesh.vertices) {
        box.add(p);
    }
    return box;
}

/// Distance of a sample from the nearest face of the model.
double distance(geometry::Model& model, const Vec3& p) {
    double least = 1e300;
    for (int face = 0; face < static_cast<int>(model.topology().faces.size()); ++face) {
        const geometry::Answer answer = model.answer(geometry::Query::face_nearest_global(face, p));
        least = answer.found() ? std::min(least, answer.distance) : least;
    }
    return least;
}

TEST(SampledShapes, EveryRayLeavesAsOftenAsItEnters) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    int parts = 0;
    for (const geometry::Part& part : geometry::all_parts()) {
        if (!part.closed) {
            continue;
        }
        ++parts;
        const double side = part.model->topology().box.largest_side();
        triangulate::TriangulateOptions options;
        options.chord_height = 2e-3 * side;
        const triangulate::Result meshed = triangulate::triangulate(engine, part.model, options);
        OperandSet pair(meshed.mesh, mesh::TriangleMesh());
        pair.face = meshed.mesh.triangle_face;
        const SampleGrid grid(box_of(meshed.mesh), 65);
        LayeredDepthSet set = rasterise(pair, 0, grid, nullptr);
        FaceSampleCounts counts;
        sample_faces(set, pair, grid, meshed.mesh.origin,
                     {part.model, &meshed.mesh.triangle_face, meshed.report.max_chord_height}, engine, counts, nullptr);
        EXPECT_EQ(counts.nodes.left, 0u) << part.name;
        EXPECT_LE(counts.on_mesh, counts.on_faces / 50) << part.name;
        double largest = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const LayeredDepthImage& image = set[axis];
            for (std::size_t ray = 0; ray + 1 < image.begin.size(); ++ray) {
                int balance = 0;
                for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
                    balance += image.code[i] < 0 ? -1 : 1;
                    EXPECT_TRUE(i == image.begin[ray] || image.depth[i - 1] <= image.depth[i]) << part.name;
                    EXPECT_NEAR(image.normal[i].norm(), 1.0, 1e-5) << part.name;
                    if (i % 16 == 0) {
                        Vec3 g;
                        g[axis] = image.depth[i];
                        g[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
                        g[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
                        largest = std::max(largest, distance(*part.model, grid.to_space(g) + meshed.mesh.origin));
                    }
                }
                ASSERT_EQ(balance, 0) << part.name << " ray " << ray;
            }
        }
        EXPECT_LE(largest, options.chord_height) << part.name;
    }
    EXPECT_GE(parts, 10);
}

class UniformBooleans : public testing::Test {
  protected:
    triangulate::Result meshed(const TopoDS_Shape& shape, double chord_height) {
        triangulate::TriangulateOptions options;
        options.chord_height = chord_height;
        return triangulate_shape(engine, shape, options, progress);
    }
    BooleanSurface run(const BooleanOperand& a, const BooleanOperand& b, boolean::Operation operation, int resolution) {
        boolean::BooleanOptions options;
        options.resolution = resolution;
        return boolean_of_operands(engine, {a, b}, boolean::Expression::chain(operation, 2), options,
                                   BooleanMethod::Uniform, {}, progress);
    }
    /// The largest and the mean distance of the vertices of triangles that were made, from either shape.
    template <typename Off>
    static std::array<double, 2> errors(const BooleanSurface& result, const Off& off) {
        std::vector<char> own(result.mesh.vertices.size(), 0), made(own);
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            for (const int v : result.mesh.triangles[t]) {
                (result.triangle_source[t][0] < 0 ? made : own)[static_cast<std::size_t>(v)] = 1;
            }
        }
        double largest = 0.0, sum = 0.0;
        int count = 0;
        for (std::size_t v = 0; v < own.size(); ++v) {
            if (made[v] != 0 && own[v] == 0) {
                const double distance = off(result.mesh.vertices[v] + result.mesh.origin);
                largest = std::max(largest, distance);
                sum += distance;
                ++count;
            }
        }
        EXPECT_GT(count, 50);
        return {largest, sum / std::max(count, 1)};
    }

    geometry::Engine engine;
    Progress progress;
};

TEST_F(UniformBooleans, ReconstructedVerticesLieOnTheShapes) {
    const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(10.0, 4.0).Shape();
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(2.1, -4.3, -9.7), 20.0, 9.0, 20.0).Shape();
    const triangulate::Result a = meshed(ring, 0.03), b = meshed(block, 0.03);
    const auto off = [](const Vec3& p) {
        const double tube = std::abs(std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 4.0);
        return std::min({tube, std::abs(p.x() - 2.1), std::abs(p.y() + 4.3), std::abs(p.y() - 4.7)});
    };
    const BooleanSurface by_faces = run({&a, false, &ring}, {&b, false, &block}, boolean::Operation::Difference, 129);
    const BooleanSurface by_meshes = run({&a}, {&b}, boolean::Operation::Difference, 129);
    EXPECT_TRUE(by_faces.figures.closed);
    EXPECT_GT(by_faces.figures.face_samples, by_faces.figures.samples / 100 * 99);
    EXPECT_EQ(by_meshes.figures.face_samples, 0u);
    EXPECT_EQ(by_meshes.figures.fitted_vertices, 0u);
    const auto [largest, mean] = errors(by_faces, off);
    const auto [largest_by_mesh, mean_by_mesh] = errors(by_meshes, off);
    EXPECT_LT(10.0 * mean, mean_by_mesh);
    EXPECT_LE(largest, largest_by_mesh);
    EXPECT_LT(by_faces.figures.unfitted_vertices, by_faces.figures.fitted_vertices / 20);
}

TEST_F(UniformBooleans, TakeAShapeAndAMesh) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10.0).Shape();
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(1.3, -6.2, 2.1), 12.3, 14.1, 9.7).Shape();
    const triangulate::Result a = meshed(ball, 0.02), b = meshed(block, 0.02);
    const BooleanSurface both = run({&a, false, &ball}, {&b, false, &block}, boolean::Operation::Union, 65);
    const BooleanSurface mixed = run({&a, false, &ball}, {&b}, boolean::Operation::Union, 65);
    EXPECT_TRUE(mixed.figures.closed);
    EXPECT_GT(mixed.figures.face_samples, 10000u);
    EXPECT_LT(mixed.figures.face_samples, mixed.figures.samples);
    EXPECT_NEAR(mixed.figures.volume, both.figures.volume, 1e-3 * both.figures.volume);
}

TEST_F(UniformBooleans, AreTheSameForAnyNumberOfThreads) {
    const TopoDS_Shape part = geometry::stored("filleted_box");
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0.2, 0.3, 0.1), 0.8).Shape();
    const triangulate::Result a = meshed(part, 0.01), b = meshed(ball, 0.01);
    const auto on_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return run({&a, false, &part}, {&b, false, &ball}, boolean::Operation::Union, 65);
    };
    const BooleanSurface one = on_threads(1), four = on_threads(4);
    EXPECT_EQ(one.mesh.triangles, four.mesh.triangles);
    EXPECT_EQ(one.mesh.vertices, four.mesh.vertices);
}

TEST_F(UniformBooleans, EndSoonAfterTheyAreCancelled) {
    const TopoDS_Shape part = geometry::stored("blade");
    const triangulate::Result a = meshed(part, 0.05);
    std::chrono::steady_clock::time_point cancelled;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
        cancelled = std::chrono::steady_clock::now();
        progress.cancel();
    });
    EXPECT_THROW(run({&a, false, &part}, {&a, false, &part}, boolean::Operation::Union, 1025), Cancelled);
    const auto now = std::chrono::steady_clock::now();
    canceller.join();
    EXPECT_LT(std::chrono::duration<double>(now - cancelled).count(), 0.2);
}

}  // namespace
}  // namespace mq::workflows

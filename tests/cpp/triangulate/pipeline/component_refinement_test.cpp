// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/component_refinement.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/assemblies.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

using geometry::at_place;
using geometry::compound_of;

constexpr double kNever = 1e6;  // mm: edges are never as long

TopoDS_Shape cone() {
    return BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape();
}

/// A cone at three places, one of them turned, and a torus.
TopoDS_Shape assembly() {
    const TopoDS_Shape one = cone();
    return compound_of({one, at_place(BRepPrimAPI_MakeTorus(2.0, 0.5).Shape(), 10.0, 0.0), at_place(one, 20.0, 0.7),
                        at_place(one, 30.0, 0.0)});
}

TriangulateOptions options_for(double chord) {
    TriangulateOptions options;
    options.chord_height = chord;
    return options;
}

/// The triangles on some faces, as points.
std::vector<std::array<Vec3, 3>> triangles_on(const Result& result, int first, int last) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        if (result.mesh.triangle_face[t] >= first && result.mesh.triangle_face[t] < last) {
            triangles.push_back(corners_of(result.mesh, t));
        }
    }
    return triangles;
}

/// The largest distance of corners after a motion.
double difference(const std::vector<std::array<Vec3, 3>>& original, const std::vector<std::array<Vec3, 3>>& copy,
                  const geometry::RigidMotion& motion) {
    double most = original.size() == copy.size() ? 0.0 : kNever;
    for (std::size_t t = 0; t < std::min(original.size(), copy.size()); ++t) {
        double least = kNever;  // of the three rotations of its corners
        for (std::size_t turn = 0; turn < 3; ++turn) {
            double here = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                here = std::max(here, (motion.of_point(original[t][(k + turn) % 3]) - copy[t][k]).norm());
            }
            least = std::min(least, here);
        }
        most = std::max(most, least);
    }
    return most;
}

/// The motion of a shape.
geometry::RigidMotion motion_of(const TopoDS_Shape& shape) {
    return geometry::make_shape_model(shape)->place();
}

void expect_good(const Result& result) {
    EXPECT_TRUE(result.report.closed);
    EXPECT_TRUE(result.report.oriented);
    EXPECT_TRUE(result.report.manifold);
    EXPECT_TRUE(result.report.complete);
    EXPECT_EQ(result.report.self_intersections, 0);
    EXPECT_GE(result.report.min_angle_unexempted, 25.0);
    EXPECT_LE(result.report.max_chord_height, result.report.chord_height_asked);
}

TEST(ComponentRefinement, CopiesHaveTheMeshOfTheirOriginal) {
    const auto model = geometry::make_shape_model(assembly());
    const double resolution = SinglePrecisionGrid(model->topology().box).resolution();
    const Result result = mesh_of(model, options_for(0.002));
    expect_good(result);
    expect_sound(result, 6, true);  // three balls and a ring
    const auto original = triangles_on(result, 0, 3);
    EXPECT_GT(original.size(), 500U);
    EXPECT_LE(difference(original, triangles_on(result, 4, 7), motion_of(at_place(cone(), 20.0, 0.7))),
              2.0 * resolution);
    EXPECT_LE(difference(original, triangles_on(result, 7, 10), motion_of(at_place(cone(), 30.0, 0.0))),
              2.0 * resolution);
}

TEST(ComponentRefinement, CopiesCostFewQueries) {
    TriangulateOptions options = options_for(0.002);
    const auto model = geometry::make_shape_model(assembly());
    const Result equal = mesh_of(model, options);
    options.local_sizes = {{2, 4, kNever}, {2, 7, 2.0 * kNever}};  // other demands, which change nothing
    const Result different = mesh_of(model, options);
    expect_good(different);
    EXPECT_LT(static_cast<double>(equal.report.queries), 0.7 * static_cast<double>(different.report.queries));
}

TEST(ComponentRefinement, ALocalSizeConcernsItsBodyOnly) {
    const auto model = geometry::make_shape_model(assembly());
    const Result before = mesh_of(model, options_for(0.01));
    TriangulateOptions options = options_for(0.01);
    options.local_sizes = {{2, 5, 0.2}};
    const Result result = mesh_of(model, options);
    expect_good(result);
    EXPECT_TRUE(triangles_on(result, 0, 3) == triangles_on(before, 0, 3));
    EXPECT_TRUE(triangles_on(result, 7, 10) == triangles_on(before, 7, 10));
    EXPECT_GT(triangles_on(result, 4, 7).size(), triangles_on(before, 4, 7).size() + 100);
}

TEST(ComponentRefinement, SamplesAreDrawnForEachBody) {
    TriangulateOptions options = options_for(0.02);
    options.method = Method::Sprinkle;
    const Result result = mesh_of(geometry::make_shape_model(assembly()), options);
    EXPECT_TRUE(result.report.closed);
    EXPECT_GT(
        difference(triangles_on(result, 0, 3), triangles_on(result, 7, 10), motion_of(at_place(cone(), 30.0, 0.0))),
        1e-3);
}

TEST(ComponentRefinement, TheNumberOfThreadsChangesNothing) {
    std::vector<TopoDS_Shape> shapes{assembly()};
    for (int i = 0; i < 70; ++i) {  // more than are refined apart
        shapes.push_back(at_place(BRepPrimAPI_MakeCone(2.0, 1.0, 3.0 + i % 35).Shape(), 8.0 * i, 0.3 * i));
    }
    const auto model = geometry::make_shape_model(compound_of(shapes));
    TriangulateOptions options = options_for(0.05);
    options.threads = 1;
    const Result one = mesh_of(model, options, geometry::Engine::Mode::Threaded);
    for (const int threads : {2, 3, 8}) {
        options.threads = threads;
        const Result several = mesh_of(model, options, geometry::Engine::Mode::Threaded);
        EXPECT_EQ(one.mesh.vertices, several.mesh.vertices);
        EXPECT_EQ(one.mesh.triangles, several.mesh.triangles);
        EXPECT_EQ(one.mesh.triangle_face, several.mesh.triangle_face);
        EXPECT_EQ(one.report.queries, several.report.queries);
        EXPECT_EQ(one.report.predicates, several.report.predicates);
    }
}

TEST(ComponentRefinement, CopiesThatCrossAreReported) {
    const TopoDS_Shape one = cone();
    const Result result =
        mesh_of(geometry::make_shape_model(compound_of({one, at_place(one, 1.5, 0.0)})), options_for(0.01));
    expect_good(result);
    EXPECT_GT(result.report.overlaps, 0);
}

/// What refine_components is called with.
class Whole {
  public:
    Whole(const TopoDS_Shape& shape, TriangulateOptions options)
        : options_(std::move(options)), pipeline_(geometry::make_shape_model(shape)), findings_(pipeline_.work) {
        std::vector<int> touched;
        pipeline_.maxmin.sweep(touched);
        refinement_.emplace(pipeline_.work, findings_, options_, options_.chord_height,
                            pipeline_.surface.vertex_count(), [](const char*) {});
        refinement_->prepare();
    }

    bool refine() { return refine_components(*refinement_, findings_.chords, stages_); }
    Workspace& work() { return pipeline_.work; }
    const StageTimes& stages() const { return stages_; }

  private:
    TriangulateOptions options_;
    Pipeline pipeline_;
    MeasurementCache findings_;
    std::optional<Refinement> refinement_;
    StageTimes stages_;
};

TEST(ComponentRefinement, JoinsWhatItHasRefined) {
    Whole whole(assembly(), options_for(0.01));
    const int before = whole.work().mesh.triangle_count();
    ASSERT_TRUE(whole.refine());
    EXPECT_EQ(whole.work().mesh.inconsistency(), "");
    EXPECT_GT(whole.work().mesh.triangle_count(), before);
    EXPECT_EQ(whole.work().mesh.triangle_count(), whole.work().mesh.used_triangle_count());
    EXPECT_FALSE(whole.stages().empty());
    for (int t = 0; t < whole.work().mesh.triangle_count(); ++t) {
        EXPECT_GE(smallest_angle(whole.work().mesh, t).angle, 25.0 * kDegree);
    }
}

TEST(ComponentRefinement, LeavesWhatIsNotToBeDivided) {
    TriangulateOptions limited = options_for(0.01);
    limited.max_triangles = 100000;
    TriangulateOptions recorded = options_for(0.01);
    recorded.record_angles = true;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(0.1, 0.1, 0.1).Shape();
    const TopoDS_Shape mostly_one = compound_of({cone(), at_place(box, 9.0, 0.0)});
    for (const auto& [shape, options] :
         std::vector<std::pair<TopoDS_Shape, TriangulateOptions>>{{assembly(), limited},
                                                                  {assembly(), recorded},
                                                                  {cone(), options_for(0.01)},
                                                                  {mostly_one, options_for(0.0002)}}) {
        Whole whole(shape, options);
        const int before = whole.work().mesh.triangle_count();
        EXPECT_FALSE(whole.refine());
        EXPECT_EQ(whole.work().mesh.triangle_count(), before);
    }
}

TEST(ComponentRefinement, LeavesWhatWouldBeMoreThanTheBudget) {
    Whole whole(assembly(), options_for(0.001));
    const int before = whole.work().mesh.triangle_count();
    whole.work().budget = 3000;
    EXPECT_FALSE(whole.refine());
    EXPECT_EQ(whole.work().mesh.triangle_count(), before);
    EXPECT_FALSE(whole.work().over_budget());
}

}  // namespace
}  // namespace mq::triangulate

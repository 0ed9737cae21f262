// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/vertex_removal.h"

#include <set>

#include "triangulate/checks.h"
#include "triangulate/measure/max_chord_error.h"
#include "triangulate/refine/chord_refinement.h"
#include "triangulate/work_mesh/corner_classification.h"

/// Removal of vertices that no bound requires.
namespace mq::triangulate {
namespace {

constexpr double kAngle = 25.0;  // Degrees: the angle bound of all meshes here.

struct Refined {
    explicit Refined(const std::shared_ptr<geometry::Model>& model, double tolerance, double max_edge = 0.0)
        : pipeline(model),
          first_vertex(pipeline.surface.vertex_count()),
          sizing{tolerance, EdgeBounds(model->topology(), max_edge, {}), 0.0, 0.0},
          chords(pipeline.work) {
        std::vector<int> touched;
        pipeline.maxmin.sweep(touched);
        SegmentSplitter segments(pipeline.work);
        AngleRefinement refiner(pipeline.work, segments, kAngle, Insertion::OffCentre);
        refiner.run();
        ChordRefinement finer(pipeline.work, segments, chords, sizing);
        while (finer.run()) {
            refiner.run();
        }
    }

    bool coarsen() { return VertexRemoval(pipeline.work, chords, kAngle, sizing, first_vertex).run(); }

    double smallest() const {
        double least = 180.0;
        for (int t = 0; t < pipeline.surface.triangle_count(); ++t) {
            least = std::min(least, smallest_angle(pipeline.surface, t).angle * 180.0 / M_PI);
        }
        return least;
    }
    double distance() {
        ChordErrorCache anew(pipeline.work);
        return measure_chord_height(pipeline.work, anew, sizing.tolerance).distance;
    }

    Pipeline pipeline;
    int first_vertex;
    Sizing sizing;
    ChordErrorCache chords;
};

std::shared_ptr<geometry::Model> block() {
    return geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
}

std::set<int> vertices_in_use(const ClassifiedMesh& mesh) {
    std::set<int> vertices;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        vertices.insert(mesh.vertex_of(h));
    }
    return vertices;
}

class CoarsenerOnParts : public testing::TestWithParam<double> {};

TEST_P(CoarsenerOnParts, KeepsEveryBoundWithFewerTriangles) {
    const double tolerance = GetParam();
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Refined refined(part.model, tolerance * part.model->topology().box.largest_side());
        const ClassifiedMesh& mesh = refined.pipeline.surface;
        const int before = mesh.triangle_count();
        const double distance = std::max(refined.distance(), refined.sizing.tolerance);
        const double smallest = refined.smallest();
        const std::set<int> in_use = vertices_in_use(mesh);
        refined.coarsen();
        EXPECT_LE(mesh.triangle_count(), before);
        EXPECT_EQ(mesh.inconsistency(), "");
        EXPECT_GE(refined.smallest(), std::min(smallest, kAngle));
        EXPECT_LE(refined.distance(), distance * (1.0 + 1e-9));
        const std::set<int> used = vertices_in_use(mesh);
        for (const int v : in_use) {
            EXPECT_TRUE(v >= refined.first_vertex || used.count(v) == 1)
                << "vertex " << v << " of the initial triangulation";
        }
        EXPECT_TRUE(refined.pipeline.maxmin.doubled_edges().empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Tolerances, CoarsenerOnParts, testing::Values(1e-2, 1e-3));

/// A flat face that was refined for a bound on lengths can lose most of its vertices without that bound.
TEST(VertexRemoval, TakesOutWhatOnlyABoundThatIsGoneNeeded) {
    const auto model = block();
    Refined refined(model, 0.0, 0.05 * model->topology().box.largest_side());
    const int fine = refined.pipeline.surface.triangle_count();
    EXPECT_FALSE(refined.distance() > 1e-9);
    Sizing none{0.0, EdgeBounds(model->topology(), 0.0, {}), 0.0, 0.0};
    VertexRemoval(refined.pipeline.work, refined.chords, kAngle, none, refined.first_vertex).run();
    EXPECT_LT(refined.pipeline.surface.triangle_count(), fine / 3);
    EXPECT_EQ(refined.pipeline.surface.inconsistency(), "");
    EXPECT_GE(refined.smallest(), kAngle);
    EXPECT_LT(refined.distance(), 1e-6);
}

/// Poles have a site for each of their images in the parameter domain: removals beside them must not mix these up.
TEST(VertexRemoval, LeavesEveryPartConsistentHoweverFewVerticesAreLeft) {
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        const double size = part.model->topology().box.largest_side();
        Refined refined(part.model, 0.0, 0.07 * size);
        const Sizing loose{0.5 * size, EdgeBounds(part.model->topology(), 0.0, {}), 0.0, 0.0};
        VertexRemoval(refined.pipeline.work, refined.chords, kAngle, loose, refined.first_vertex).run();
        EXPECT_EQ(refined.pipeline.surface.inconsistency(), "");
        EXPECT_TRUE(refined.pipeline.maxmin.doubled_edges().empty());
    }
}

TEST(VertexRemoval, KeepsABoundOnLengths) {
    const auto model = block();
    const double longest = 0.2 * model->topology().box.largest_side();
    Refined refined(model, 0.0, longest);
    refined.coarsen();
    const ClassifiedMesh& mesh = refined.pipeline.surface;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        EXPECT_LE((mesh.point_of(ClassifiedMesh::next(h)) - mesh.point_of(h)).norm(), longest * (1.0 + 1e-9));
    }
}

TEST(VertexRemoval, LeavesGradedMeshesAlone) {
    const auto model = block();
    Refined refined(model, 0.0, 0.1 * model->topology().box.largest_side());
    const Sizing graded{0.0, EdgeBounds(model->topology(), 0.0, {}), 0.0, 1.5};
    EXPECT_FALSE(VertexRemoval(refined.pipeline.work, refined.chords, kAngle, graded, refined.first_vertex).run());
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/optimise/edge_vertex_relocation.h"

#include <memory>
#include <utility>

#include "triangulate/checks.h"
#include "triangulate/measure/max_chord_error.h"
#include "triangulate/work_mesh/corner_classification.h"

/// Moving vertices along CAD edges.
namespace mq::triangulate {
namespace {

// Returns the smallest angle except small input angles of the shape.
double smallest_around(const ClassifiedMesh& mesh, const std::vector<int>& triangles) {
    double least = M_PI;
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            least = h != narrow_corner_of(mesh, t) ? std::min(least, angle_at(mesh, h)) : least;
        }
    }
    return least;
}

/// A shape refined to 25 degrees, whose vertices may move without bounds on lengths and distances.
struct RefinedPart {
    explicit RefinedPart(std::shared_ptr<geometry::Model> model) : pipeline(std::move(model)) { pipeline.refine(25.0); }

    Pipeline pipeline;
    Sizing sizing{0.0, EdgeBounds(pipeline.session.topology(), 0.0, {}), 0.0, 0.0};
    EdgeVertexRelocation slider{pipeline.work, sizing};
    EditTransaction undo{pipeline.work};
};

/// Every move enlarges the smallest angle around the vertex by the requested gain, and leaves it on its edge; the
/// ends of the innermost pieces at small input angles move, too.
TEST(EdgeVertexRelocation, MovesVerticesAlongTheirEdges) {
    constexpr double kGain = 0.02;  // Radians: requested gain of the smallest angle.
    int moves = 0;
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        RefinedPart refined(part.model);
        Pipeline& pipeline = refined.pipeline;
        for (int t = 0; t < pipeline.surface.triangle_count(); ++t) {
            double before = 0.0;
            const auto enough = [&](double angle) {
                before = angle;
                return angle + kGain;
            };
            const std::vector<int> changed = refined.slider.improve(t, 0.5, enough, refined.undo);
            if (!changed.empty()) {
                EXPECT_GE(smallest_around(pipeline.surface, changed), before + kGain - 1e-9);
                ++moves;
            }
        }
        EXPECT_EQ(pipeline.surface.inconsistency(), "");
        EXPECT_TRUE(pipeline.maxmin.doubled_edges().empty());
        expect_on_curves(pipeline);
    }
    EXPECT_GT(moves, 10);
}

/// With a tolerance that the mesh just meets, vertices on curved edges do not move, or only if no distance exceeds it.
TEST(EdgeVertexRelocation, KeepsTheDistanceFromThePart) {
    for (const geometry::Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        pipeline.refine(25.0);
        ChordErrorCache measure(pipeline.work);
        const double tolerance = measure_chord_height(pipeline.work, measure, 0.0).distance;
        const Sizing sizing{tolerance, EdgeBounds(pipeline.session.topology(), 0.0, {}), 0.0, 0.0};
        EdgeVertexRelocation slider(pipeline.work, sizing);
        EditTransaction undo(pipeline.work);
        for (int t = 0; t < pipeline.surface.triangle_count(); ++t) {
            slider.improve(
                t, 0.5, [](double angle) { return angle + 0.01; }, undo);
        }
        ChordErrorCache again(pipeline.work);
        EXPECT_LE(measure_chord_height(pipeline.work, again, 0.0).distance, tolerance + 1e-9);
    }
}

/// The exemption of a triangle below the bound passes to the triangles that are below it afterwards.
TEST(EdgeVertexRelocation, ExemptionsStay) {
    RefinedPart refined(geometry::make_shape_model(geometry::wedge(5.0, 10.0, 3.0)));
    Pipeline& pipeline = refined.pipeline;
    for (int t = 0; t < pipeline.surface.triangle_count(); ++t) {
        refined.slider.improve(
            t, 25.0 * M_PI / 180.0, [](double angle) { return angle + 0.01; }, refined.undo);
    }
    for (int t = 0; t < pipeline.surface.triangle_count(); ++t) {
        EXPECT_EQ(pipeline.work.exemption_of(t) != nullptr,
                  smallest_angle(pipeline.surface, t).angle < 25.0 * M_PI / 180.0);
    }
}

}  // namespace
}  // namespace mq::triangulate

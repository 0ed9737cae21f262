// SPDX-License-Identifier: LGPL-2.1-or-later
#include <functional>
#include <limits>

#include "base/error.h"
#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();      // Not a number, which every option must refuse.
constexpr double kInfinity = std::numeric_limits<double>::infinity();  // Infinity, which every option must refuse.

void expect_refused(const TriangulateOptions& options, const std::string& name) {
    try {
        options.validate();
        ADD_FAILURE() << name << " is taken";
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    EXPECT_THROW(mesh_of(geometry::make_box(1.0, 2.0, 3.0), options), InvalidInput);
}

TEST(TriangulateOptions, DefaultsAreValid) {
    EXPECT_NO_THROW(TriangulateOptions().validate());
}

TEST(TriangulateOptions, MinAngleHasARange) {
    for (const double angle : {-1.0, 34.1, 60.0, kNan, kInfinity}) {
        TriangulateOptions options;
        options.min_angle = angle;
        expect_refused(options, "min_angle");
    }
    for (const double angle : {0.0, 0.1, 34.0}) {
        TriangulateOptions options;
        options.min_angle = angle;
        EXPECT_NO_THROW(options.validate());
    }
}

TEST(TriangulateOptions, LengthsAreNumbersOfAtLeastZero) {
    const std::vector<std::pair<const char*, double TriangulateOptions::*>> lengths{
        {"chord_height", &TriangulateOptions::chord_height},
        {"chord_height_relative", &TriangulateOptions::chord_height_relative},
        {"max_edge", &TriangulateOptions::max_edge},
        {"min_edge", &TriangulateOptions::min_edge}};
    for (const auto& [name, member] : lengths) {
        for (const double value : {-1.0, -1e-12, kNan, kInfinity}) {
            TriangulateOptions options;
            options.*member = value;
            expect_refused(options, name);
        }
        TriangulateOptions options;
        options.*member = 0.5;
        EXPECT_NO_THROW(options.validate());
    }
}

TEST(TriangulateOptions, ContradictionsNameBothSides) {
    TriangulateOptions chords;
    chords.chord_height = 0.1;
    chords.chord_height_relative = 0.1;
    expect_refused(chords, "chord_height_relative");
    TriangulateOptions edges;
    edges.max_edge = 1.0;
    edges.min_edge = 2.0;
    expect_refused(edges, "min_edge");
    expect_refused(edges, "max_edge");
}

TEST(TriangulateOptions, WithoutABoundOnAnglesTheDistanceAloneDecides) {
    for (const geometry::Part& part : geometry::analytic_parts()) {
        SCOPED_TRACE(part.name);
        TriangulateOptions options;
        options.chord_height_relative = 1e-3;
        const auto with_angles = static_cast<double>(mesh_of(part.model, options).mesh.triangles.size());
        options.min_angle = 0.0;
        const Result result = mesh_of(part.model, options);
        expect_sound(result, part.euler, part.closed);
        EXPECT_LE(result.report.max_chord_height, result.report.chord_height_asked);
        EXPECT_TRUE(result.report.exempt.empty());
        EXPECT_LE(static_cast<double>(result.mesh.triangles.size()), 1.05 * with_angles);  // round ones need no fewer
    }
}

TEST(TriangulateOptions, TheExtremesOfMinAngleWork) {
    for (const double angle : {0.0, 0.1, 34.0}) {
        for (const geometry::Part& part : geometry::analytic_parts()) {
            SCOPED_TRACE(part.name);
            TriangulateOptions options;
            options.min_angle = angle;
            const Result result = mesh_of(part.model, options);
            expect_sound(result, part.euler, part.closed);
            expect_angles(result, angle);
        }
    }
}

/// No edge is split below min_edge; the edges of S_C do not change.
TEST(TriangulateOptions, MinEdgeIsKeptAndNamed) {
    const auto model = geometry::make_shape_model(geometry::stored("bored"));
    TriangulateOptions options;
    options.min_angle = 30.0;
    options.min_edge = 2.0;  // with 1 mm the angle bound can be reached
    const Result result = mesh_of(model, options);
    expect_sound(result, 0, true);
    expect_angles(result, 30.0);
    options.min_edge = 0.0;
    EXPECT_LT(result.mesh.triangles.size(), mesh_of(model, options).mesh.triangles.size());
    const bool named = std::any_of(result.report.exempt.begin(), result.report.exempt.end(),
                                   [](const auto& entry) { return entry.second.cause == mesh::ExemptCause::MinEdge; });
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace mq::triangulate

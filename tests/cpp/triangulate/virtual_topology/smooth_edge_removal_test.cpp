// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/smooth_edge_removal.h"

#include "triangulate/checks.h"
#include "triangulate/virtual_topology/stadium.h"

/// Smooth CAD edges that no longer constrain the mesh.
namespace mq::triangulate {
namespace {

Result released(const std::shared_ptr<geometry::Model>& model, double chord = 0.02) {
    TriangulateOptions options;
    options.chord_height = chord;
    options.keep_edges = KeepEdges::Feature;
    return mesh_of(model, options);
}

Result kept(const std::shared_ptr<geometry::Model>& model, double chord = 0.02) {
    TriangulateOptions options;
    options.chord_height = chord;
    return mesh_of(model, options);
}

TEST(SmoothEdgeRemoval, ShortPiecesOfSmoothSidesCostFewerTriangles) {
    const Result plain = kept(stadium(4));
    const Result free = released(stadium(4));
    EXPECT_LT(free.report.triangles, plain.report.triangles);
    EXPECT_FALSE(free.report.spanning.empty());
    EXPECT_TRUE(free.report.closed && free.report.manifold && free.report.oriented);
    EXPECT_EQ(free.report.self_intersections, 0);
    EXPECT_GE(free.report.min_angle_unexempted, 25.0 - 1e-9);
    EXPECT_LE(free.report.exempt.size(), plain.report.exempt.size());
    EXPECT_LE(free.report.max_chord_height, 0.02);
    EXPECT_NEAR(free.report.volume, plain.report.volume, 0.01 * plain.report.volume);
}

TEST(SmoothEdgeRemoval, VerticesLieOnTheSurface) {
    const Result free = released(stadium(3));
    for (const Vec3& p : free.mesh.vertices) {
        const double x = std::max(0.0, std::abs(p.x()) - 5.0);
        const double beside = std::hypot(x, p.y());
        const bool on_end = std::abs(p.z()) < 1e-5 || std::abs(p.z() - 4.0) < 1e-5;
        EXPECT_TRUE(on_end || std::abs(beside - 2.0) < 1e-5) << p.transpose();
    }
}

TEST(SmoothEdgeRemoval, NamesOfFacesAreThoseOfSpanningTriangles) {
    const Result free = released(stadium(4));
    for (const auto& [triangle, text] : free.report.spanning) {
        const std::string own = geometry::name_of({2, free.mesh.triangle_face[static_cast<std::size_t>(triangle)]});
        EXPECT_EQ(text.rfind("spans " + own, 0), 0u) << text;
    }
}

TEST(SmoothEdgeRemoval, PartsWithoutSmoothEdgesStayAsTheyAre) {
    const auto wedge = geometry::make_shape_model(geometry::wedge(40.0, 5.0, 1.0));
    EXPECT_EQ(released(wedge).mesh.triangles, kept(wedge).mesh.triangles);
}

TEST(SmoothEdgeRemoval, SameInputSameMesh) {
    const Result first = released(stadium(3));
    const Result second = released(stadium(3));
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
    EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
}

TEST(SmoothEdgeRemoval, OptionsOutOfRangeAreNamed) {
    TriangulateOptions options;
    options.feature_angle = 50.0;
    EXPECT_THROW(options.validate(), InvalidInput);
    options.feature_angle = 10.0;
    options.keep_edges = KeepEdges::Feature;
    options.method = Method::Star;
    options.polish = false;
    EXPECT_THROW(options.validate(), InvalidInput);
}

}  // namespace
}  // namespace mq::triangulate

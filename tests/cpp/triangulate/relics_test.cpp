// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/relics.h"

#include "triangulate/checks.h"
#include "triangulate/smooth_edges.h"

/// Smooth CAD edges that let go of the mesh.
namespace mq::triangulate {
namespace {

/// A stadium of two half circles, whose sides have been cut into `pieces` with a very short one first.
std::shared_ptr<geometry::Model> stadium(int pieces) {
    std::vector<TopoDS_Edge> border{geometry::arc(geometry::circle_about(5.0, 0.0, 2.0), -0.5 * M_PI, 0.5 * M_PI)};
    const auto side = [&](double from, double to, double y) {
        double last = from;
        for (int i = 0; i < pieces; ++i) {
            const double next = i + 1 == pieces ? to : from + (to - from) * 0.002 * (i + 1);
            border.push_back(geometry::line(last, y, next, y));
            last = next;
        }
    };
    side(5.0, -5.0, 2.0);
    border.push_back(geometry::arc(geometry::circle_about(-5.0, 0.0, 2.0), 0.5 * M_PI, 1.5 * M_PI));
    side(-5.0, 5.0, -2.0);
    return geometry::make_shape_model(geometry::extruded(geometry::planar_face(border), 4.0));
}

Result released(const std::shared_ptr<geometry::Model>& model, double chord = 0.02) {
    Options options;
    options.chord_height = chord;
    options.keep_edges = KeepEdges::Feature;
    return mesh_of(model, options);
}

Result kept(const std::shared_ptr<geometry::Model>& model, double chord = 0.02) {
    Options options;
    options.chord_height = chord;
    return mesh_of(model, options);
}

TEST(SmoothEdges, AreThoseAcrossWhichTheNormalIsContinuous) {
    Pipeline rounded(stadium(1));
    const std::vector<char> smooth = smooth_edges(rounded.work, 10.0, {});
    EXPECT_EQ(std::count(smooth.begin(), smooth.end(), 1), 4);  // where half circles meet straight sides
    Pipeline box(geometry::make_shape_model(geometry::wedge(40.0, 5.0, 1.0)));
    const std::vector<char> sharp = smooth_edges(box.work, 10.0, {});
    EXPECT_EQ(std::count(sharp.begin(), sharp.end(), 1), 0);
    Pipeline seam(geometry::make_cylinder(2.0, 5.0));
    const std::vector<char> none = smooth_edges(seam.work, 10.0, {});
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
}

TEST(SmoothEdges, ThatSizesNameStay) {
    Pipeline pipeline(stadium(1));
    const auto count = [&](const std::vector<LocalSize>& sizes) {
        const std::vector<char> smooth = smooth_edges(pipeline.work, 10.0, sizes);
        return std::count(smooth.begin(), smooth.end(), 1);
    };
    const std::vector<char> all = smooth_edges(pipeline.work, 10.0, {});
    const int first = static_cast<int>(std::find(all.begin(), all.end(), 1) - all.begin());
    EXPECT_EQ(count({{1, first, 0.1}}), 3);
}

TEST(Relics, ShortPiecesOfSmoothSidesCostNoTriangles) {
    const Result plain = kept(stadium(4));
    const Result free = released(stadium(4));
    EXPECT_LT(free.report.triangles, plain.report.triangles * 3 / 4);
    EXPECT_FALSE(free.report.spanning.empty());
    EXPECT_TRUE(free.report.closed && free.report.manifold && free.report.oriented);
    EXPECT_EQ(free.report.self_intersections, 0);
    EXPECT_GE(free.report.min_angle_unexempted, 25.0 - 1e-9);
    EXPECT_LE(free.report.exempt.size(), plain.report.exempt.size());
    EXPECT_LE(free.report.max_chord_height, 0.02);
    EXPECT_NEAR(free.report.volume, plain.report.volume, 0.01 * plain.report.volume);
}

TEST(Relics, VerticesLieOnTheSurface) {
    const Result free = released(stadium(3));
    for (const Vec3& p : free.mesh.vertices) {
        const double x = std::max(0.0, std::abs(p.x()) - 5.0);
        const double beside = std::hypot(x, p.y());
        const bool on_end = std::abs(p.z()) < 1e-5 || std::abs(p.z() - 4.0) < 1e-5;
        EXPECT_TRUE(on_end || std::abs(beside - 2.0) < 1e-5) << p.transpose();
    }
}

TEST(Relics, NamesOfFacesAreThoseOfSpanningTriangles) {
    const Result free = released(stadium(4));
    for (const auto& [triangle, text] : free.report.spanning) {
        const std::string own = geometry::name_of({2, free.mesh.triangle_face[static_cast<std::size_t>(triangle)]});
        EXPECT_EQ(text.rfind("spans " + own, 0), 0u) << text;
    }
}

TEST(Relics, PartsWithoutSmoothEdgesStayAsTheyAre) {
    const auto wedge = geometry::make_shape_model(geometry::wedge(40.0, 5.0, 1.0));
    EXPECT_EQ(released(wedge).mesh.triangles, kept(wedge).mesh.triangles);
}

TEST(Relics, SameInputSameMesh) {
    const Result first = released(stadium(3));
    const Result second = released(stadium(3));
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
    EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
}

TEST(Relics, OptionsOutOfRangeAreNamed) {
    Options options;
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

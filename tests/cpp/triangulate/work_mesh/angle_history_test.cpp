// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/angle_history.h"

#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

/// Counts the triangles between two solids once: the output has one for each.
std::size_t places(const mesh::TriangleMesh& mesh) {
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::set<std::array<double, 9>> found;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<Vec3, 3> corners = corners_of(mesh, t);
        std::sort(corners.begin(), corners.end(), before);
        std::array<double, 9> place{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::copy_n(corners[i].data(), 3, place.data() + 3 * i);
        }
        found.insert(place);
    }
    return found.size();
}

/// Checks that the entry holds for the mesh, measured without the history.
void expect_state(const AngleHistory::Entry& entry, const Result& result) {
    EXPECT_EQ(entry.triangles, places(result.mesh));
    EXPECT_NEAR(entry.min_angle, result.report.min_angle_unexempted, 1e-9);
}

TEST(AngleHistory, EndsAtTheMeshAndChangesNothing) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        TriangulateOptions options;
        options.insertion = Insertion::Circumcentre;  // no other step changes the mesh afterwards
        const Result plain = mesh_of(part.model, options);
        EXPECT_TRUE(plain.angle_history.empty());
        options.record_angles = true;
        const Result recorded = mesh_of(part.model, options);
        EXPECT_EQ(recorded.mesh.vertices, plain.mesh.vertices);
        EXPECT_EQ(recorded.mesh.triangles, plain.mesh.triangles);
        ASSERT_FALSE(recorded.angle_history.empty());
        expect_state(recorded.angle_history.back(), recorded);
    }
}

TEST(AngleHistory, HasAnEntryForEachVertex) {
    Pipeline pipeline(geometry::all_parts().front().model);
    std::vector<int> touched;
    pipeline.maxmin.sweep(touched);
    const int before = pipeline.surface.vertex_count();
    SegmentSplitter segments(pipeline.work);
    pipeline.work.angle_history.start();
    AngleRefinement(pipeline.work, segments, 25.0, Insertion::OffCentre).run();
    EXPECT_EQ(pipeline.work.angle_history.entries().size(),
              static_cast<std::size_t>(pipeline.surface.vertex_count() - before));
    pipeline.work.angle_history.stop();
    const std::size_t entries = pipeline.work.angle_history.entries().size();
    AngleRefinement(pipeline.work, segments, 30.0, Insertion::OffCentre).run();
    EXPECT_EQ(pipeline.work.angle_history.entries().size(), entries);
}

}  // namespace
}  // namespace mq::triangulate

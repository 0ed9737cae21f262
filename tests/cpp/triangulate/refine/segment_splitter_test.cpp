// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/segment_splitter.h"

#include <cmath>

#include "triangulate/checks.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

double length_of(const ClassifiedMesh& mesh, int segment) {
    const auto& v = mesh.segment(segment).vertices;
    return (mesh.vertex(v[1]).point - mesh.vertex(v[0]).point).norm();
}

/// Returns the piece of the segment's CAD edge that ends in the node.
int piece_at(const ClassifiedMesh& mesh, int segment, int node) {
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const auto& ends = mesh.segment(s).vertices;
        if (mesh.segment(s).edge == mesh.segment(segment).edge && (ends[0] == node || ends[1] == node)) {
            return s;
        }
    }
    return -1;
}

/// Splits every segment once in every round.
void split_all(Pipeline& pipeline, SegmentSplitter& segments, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        const int count = pipeline.surface.segment_count();
        for (int s = 0; s < count; ++s) {
            segments.request(s);
        }
        std::vector<int> touched;
        segments.run(touched);
        EXPECT_TRUE(segments.idle());
    }
}

TEST(SegmentSplitter, PutsVerticesOnTheCurveAndOnEveryFace) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const int before = pipeline.surface.segment_count();
        SegmentSplitter segments(pipeline.work);
        split_all(pipeline, segments, 2);
        EXPECT_GE(pipeline.surface.segment_count(), before);
        EXPECT_EQ(pipeline.surface.inconsistency(), "");
        expect_on_curves(pipeline);
    }
}

TEST(SegmentSplitter, LeavesNoSegmentEncroachedThatItCouldSplit) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        SegmentSplitter segments(pipeline.work);
        split_all(pipeline, segments, 1);
        for (int s = 0; s < pipeline.surface.segment_count(); ++s) {
            EXPECT_TRUE(!segments.encroached(s) || segments.refused(s) || segments.is_terminal(s)) << "segment " << s;
        }
    }
}

/// Returns why the first segment of a shape may not be split at all.
std::optional<Cause> obstacle_of_the_first(Pipeline& pipeline) {
    SegmentSplitter segments(pipeline.work);
    EXPECT_FALSE(segments.obstacle(0));
    segments.request(0, true);
    std::vector<int> touched;
    segments.run(touched);
    EXPECT_EQ(segments.refused(0), segments.obstacle(0).has_value());
    return segments.obstacle(0);
}

TEST(SegmentSplitter, TellsWhyASegmentIsNotSplit) {
    const auto box = geometry::make_box(1.0, 1.0, 1.0);
    Pipeline possible(box);
    EXPECT_FALSE(obstacle_of_the_first(possible));
    Pipeline fine(box);
    fine.work.floor = 10.0;
    EXPECT_EQ(obstacle_of_the_first(fine), Cause::Resolution);
    Pipeline wide(box);
    wide.work.min_edge = 10.0;
    EXPECT_EQ(obstacle_of_the_first(wide), Cause::MinEdge);
    Pipeline folded(box);
    for (int h = 0; h < folded.surface.half_edge_count(); ++h) {
        const Vec3 outward = doubled_area(folded.surface, h / 3).normalized();
        folded.surface.set_normal(folded.surface.site_of(h), -outward);
    }
    EXPECT_EQ(obstacle_of_the_first(folded), Cause::Fold);
}

/// The innermost pieces at an acute corner end on spheres about its node whose radii are powers of two, in mm.
TEST(SegmentSplitter, SplitsOnShellsNearAcuteCorners) {
    for (const double angle : {5.0, 15.0, 40.0, 80.0}) {
        SCOPED_TRACE(angle);
        Pipeline pipeline(geometry::make_shape_model(geometry::wedge(angle, 10.0, 6.0)));
        const std::vector<double> innermost = corner_shells(pipeline.surface).innermost;
        SegmentSplitter segments(pipeline.work);
        split_all(pipeline, segments, 3);
        const ClassifiedMesh& mesh = pipeline.surface;
        int shells = 0;
        for (int s = 0; s < mesh.segment_count(); ++s) {
            const ClassifiedMesh::Segment& segment = mesh.segment(s);
            for (int end = 0; end < 2; ++end) {
                const Vec3& node = mesh.vertex(segment.vertices[end]).point;
                const bool in_corner =
                    mesh.vertex(segment.vertices[end]).entity[0] == 0 && node.head<2>().norm() < 1e-6;
                const bool across = std::abs(mesh.vertex(segment.vertices[1 - end]).point.z() - node.z()) < 1e-6;
                if (in_corner && across) {
                    const auto v = static_cast<std::size_t>(segment.vertices[end]);
                    const double exponent = std::log2(length_of(mesh, s) / innermost[v]);
                    EXPECT_NEAR(exponent, std::round(exponent), 1e-5);
                    ++shells;
                }
            }
        }
        EXPECT_EQ(shells, 4);  // two edges at either end of the wedge
    }
}

/// Pieces of equal length at one corner: neither encroaches upon the other.
TEST(SegmentSplitter, PiecesOfACornerGetEqualLengths) {
    Pipeline pipeline(geometry::make_shape_model(geometry::wedge(30.0, 9.0, 4.0)));
    SegmentSplitter segments(pipeline.work);
    split_all(pipeline, segments, 3);
    std::set<long> lengths;
    for (int s = 0; s < pipeline.surface.segment_count(); ++s) {
        for (int end = 0; end < 2; ++end) {
            if (narrowest_corner(pipeline.surface, s, end).angle < 0.6) {
                lengths.insert(std::lround(1e4 * length_of(pipeline.surface, s)));
            }
        }
    }
    EXPECT_EQ(lengths.size(), 1u);
}

/// Independent of which of them is split, and at which of its ends the corner is; nothing is split twice because of
/// the other.
TEST(SegmentSplitter, TheOtherPieceOfACornerFollows) {
    const auto model = geometry::make_shape_model(geometry::wedge(20.0, 9.0, 4.0));
    const int count = Pipeline(model).surface.segment_count();
    for (int forced = 0; forced < count; ++forced) {
        Pipeline pipeline(model);
        const ClassifiedMesh& mesh = pipeline.surface;
        for (int end = 0; end < 2; ++end) {
            const NarrowCorner corner = narrowest_corner(mesh, forced, end);
            if (corner.angle > 0.4) {
                continue;
            }
            SCOPED_TRACE(forced);
            const int node = mesh.segment(forced).vertices[end];
            SegmentSplitter segments(pipeline.work);
            std::vector<int> touched;
            for (int round = 0; round < 3; ++round) {
                segments.request(piece_at(mesh, forced, node), true);
                segments.run(touched);
            }
            const double length = length_of(mesh, piece_at(mesh, forced, node));
            EXPECT_NEAR(length_of(mesh, piece_at(mesh, corner.segment, node)), length, 1e-4 * length);
        }
    }
}

TEST(SegmentSplitter, RefusesWhatWouldBeShorterThanTheFloor) {
    Pipeline pipeline(geometry::make_box(1.0, 2.0, 3.0));
    pipeline.work.min_edge = 0.3;
    SegmentSplitter segments(pipeline.work);
    split_all(pipeline, segments, 8);
    for (int s = 0; s < pipeline.surface.segment_count(); ++s) {
        EXPECT_GE(length_of(pipeline.surface, s), 0.3);
        EXPECT_TRUE(segments.refused(s));
    }
}

}  // namespace
}  // namespace mq::triangulate

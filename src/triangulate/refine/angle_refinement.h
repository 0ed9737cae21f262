// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <vector>

#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/apex_rings.h"
#include "triangulate/refine/graded_fans.h"
#include "triangulate/refine/segment_splitter.h"
#include "triangulate/work_mesh/element_marks.h"
#include "triangulate/work_mesh/options.h"

namespace mq::triangulate {

/// Algorithm M (Aftosmis 1999, section 3.3): refines until every angle is at least `min_angle`, except in triangles
/// that are put into `Workspace::exempt` with their cause.
///
/// Terminates for every input: no vertex is placed closer to its neighbours than `Workspace::floor`, so that a shape
/// has room for a bounded number of vertices; for small input angles, see SegmentSplitter::may_split.
class AngleRefinement {
  public:
    /// `chord_height` (mm, 0: none): chord tolerance of the refinement that follows, see ApexRings. `sites_in_round`:
    /// see TriangulateOptions.
    AngleRefinement(Workspace& work, SegmentSplitter& segments, double min_angle_degrees, Insertion insertion,
                    double chord_height = 0.0, std::size_t sites_in_round = 0);

    void run();  ///< without a bound on angles it does nothing
    /// Follows ClassifiedMesh::order_in_space, between runs.
    void renumber(const NewIndices& renewed) {
        apex_rings_.renumber(renewed);
        graded_fans_.renumber(renewed);
        move_to_indices(renewed.vertices, sharpened_);
        turned_.renumber(renewed);
        looked_at_.renumber(renewed);
    }

  private:
    struct QueuedTriangle {
        double angle;  // radians; for a triangle whose normal deviates, its alignment - 2
        int triangle;
        std::uint32_t stamp;
        bool turned() const { return angle < 0.0; }          // its normal deviates from the surface
        bool operator<(const QueuedTriangle& other) const {  // for a max-heap: the smallest angle on top, ties by index
            return angle != other.angle ? angle > other.angle : triangle > other.triangle;
        }
    };
    using Queue = std::priority_queue<QueuedTriangle>;
    static constexpr int kLastAttempt = 2;  // Index of the last rule for sites: the middle of the longest edge.
    struct Job {
        QueuedTriangle bad;
        Candidate candidate;
        int attempt = 0;  // the chosen rule's site; if refused, the other rule's, then the middle of the longest edge
    };

    /// Counts of the changes that may let a retry succeed where the previous one failed.
    using State = std::array<std::size_t, 4>;

    void add_turned(const QueuedTriangle& bad, std::vector<Job>& jobs);
    std::optional<QueuedTriangle> if_bad(int triangle) const;
    void push_touched();
    void push_new();
    void refine_in_blocks();
    void refine_block(geometry::Answerer& answerer, Workspace& block, const ClassifiedMesh::Share& share,
                      std::size_t room, std::vector<QueuedTriangle>& bad);
    std::optional<int> insert_in_block(geometry::Answerer& answerer, Workspace& block, const QueuedTriangle& bad,
                                       std::vector<int>& touched) const;
    bool refine_round();
    void drop_lost(std::vector<Job>& jobs);
    std::vector<Job> next_jobs();
    std::optional<Candidate> site_by_rule(int triangle, int attempt, int& blocking_segment) const;
    void handle_blocked(const QueuedTriangle& bad, int segment);
    void work_on(const Job& job, const std::optional<SurfacePoint>& p);
    bool split_instead(const QueuedTriangle& bad, const std::vector<int>& segments);
    bool flattens_segment(const std::vector<int>& segments, const Vec3& p) const;
    void give_up(const Job& job, Cause cause, const std::vector<int>& segments = {});
    bool shares_wide_corner(int triangle, int vertex) const;
    void exempt_for(const QueuedTriangle& bad, Cause cause, const std::vector<int>& segments);
    bool crowded(int triangle, double nearest, int& shrinks) const;
    void remember_shrinks(int first_vertex, int shrinks);
    void exempt(const QueuedTriangle& bad, Cause cause, int vertex = -1, int segment = -1);
    bool exempt_narrow_corner(const QueuedTriangle& bad);
    bool exempt_where_narrow(const QueuedTriangle& bad);
    bool request_finer_chords(int a, int b, int vertex);
    bool slender_apex(int h) const;
    bool insert_apex_ring(const QueuedTriangle& bad);
    bool write_graded_fan(const QueuedTriangle& bad);
    bool divides_guarded_fan(const std::vector<int>& triangles) const;
    bool retry_exempted();
    State state() const;
    void exempt_the_rest();

    Workspace& work_;
    SegmentSplitter& segments_;
    double bound_;          // radians
    double surely_enough_;  // squared sine that surely exceeds the bound
    Insertion insertion_;
    std::size_t sites_in_round_;
    ApexRings apex_rings_;
    GradedFans graded_fans_;
    Queue queue_;
    std::map<int, int> sharpened_;  // by vertex: number of times the chords at a small input angle were halved
    TriangleMarks turned_;          // triangles that were refined for their alignment
    std::vector<int> touched_;
    TriangleMarks looked_at_;  // triangles that were queued if below the bound
    std::vector<Job> again_;   // fallbacks for the next round
};

}  // namespace mq::triangulate

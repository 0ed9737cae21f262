// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <vector>

#include "triangulate/apex_rings.h"
#include "triangulate/insertion.h"
#include "triangulate/segment_split.h"
#include "triangulate/triangle_marks.h"
#include "triangulate/triangulate.h"

namespace mq::triangulate {

/// Algorithm M (Aftosmis 1999, section 3.3): refines until every angle is at least `min_angle`, except in triangles
/// that are put into `Workspace::exempt` with their cause.
///
/// Ends for every input: a vertex is never put closer to its neighbours than `Workspace::floor`, so a part has room
/// for a bounded number of them; near narrow corners, see SegmentSplitter::may_split_for.
class Refiner {
  public:
    /// `chord_height` (mm, 0: none) is what the mesh is refined to afterwards: see ApexRings.
    Refiner(Workspace& work, SegmentSplitter& segments, double min_angle_degrees, Insertion insertion,
            double chord_height = 0.0);

    void run();

  private:
    struct Bad {
        double angle;  // radians; of a turned triangle its alignment - 2
        int triangle;
        std::uint32_t stamp;
        bool turned() const { return angle < 0.0; }  // it lies askew on the surface
        bool operator<(const Bad& other) const {     // a max-heap: the smallest angle on top, ties by index
            return angle != other.angle ? angle > other.angle : triangle > other.triangle;
        }
    };
    static constexpr int kLastAttempt = 2;
    struct Job {
        Bad bad;
        Candidate candidate;
        int attempt =
            0;  // the chosen rule's site; when it is refused the other rule's, then the middle of the longest edge
    };

    void take_turned(const Bad& bad, std::vector<Job>& jobs);
    void push_if_bad(int triangle);
    void push_touched();
    bool refine_round();
    std::vector<Job> take_jobs();
    std::optional<Candidate> site_by_rule(int triangle, int attempt, int& blocking_segment) const;
    void handle_blocked(const Bad& bad, int segment);
    void work_on(const Job& job, const std::optional<SurfacePoint>& p);
    bool split_instead(const Bad& bad, const std::vector<int>& segments);
    bool too_flat(const std::vector<int>& segments, const Vec3& p) const;
    void give_up(const Job& job, Cause cause, const std::vector<int>& segments = {});
    void exempt_for(const Bad& bad, Cause cause, const std::vector<int>& segments);
    bool crowded(int triangle, double nearest, int& shrinks) const;
    void remember_shrinks(int first_vertex, int shrinks);
    void exempt(const Bad& bad, Cause cause, int vertex = -1, int segment = -1);
    bool narrow_corner(const Bad& bad);
    bool narrowed_by_chords(int a, int b, int vertex);
    bool slender_apex(int h) const;
    bool round_apex(const Bad& bad);
    bool divides_guarded_fan(const std::vector<int>& triangles) const;
    bool retry_exempted();
    void exempt_the_rest();

    Workspace& work_;
    SegmentSplitter& segments_;
    double bound_;          // radians
    double surely_enough_;  // squared sine
    Insertion insertion_;
    ApexRings apex_rings_;
    std::priority_queue<Bad> queue_;
    std::map<int, int> sharpened_;  // by vertex: how often the chords at a narrow corner were halved
    TriangleMarks turned_;          // those that were refined for their alignment
    std::vector<int> touched_;
    TriangleMarks looked_at_;  // those that were pushed if bad
    std::vector<Job> again_;   // fallbacks for the next round
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <queue>
#include <vector>

#include "triangulate/insertion.h"
#include "triangulate/segment_split.h"

namespace mq::triangulate {

/// Algorithm M (Aftosmis 1999, section 3.3): refines until every angle is at least `min_angle`, except in triangles
/// that are put into `Workspace::exempt` with their cause.
///
/// Ends for every input: a vertex is never put closer to its neighbours than `Workspace::floor`, so a part has room
/// for a bounded number of them; near narrow corners, see SegmentSplitter::may_split_for.
class Refiner {
  public:
    Refiner(Workspace& work, SegmentSplitter& segments, double min_angle_degrees);

    void run();

  private:
    struct Bad {
        double angle;
        int triangle;
        std::uint32_t stamp;
        bool operator<(const Bad& other) const {  // a max-heap: the smallest angle on top, ties by index
            return angle != other.angle ? angle > other.angle : triangle > other.triangle;
        }
    };
    struct Job {
        Bad bad;
        Candidate candidate;
        int attempt = 0;  // the paper's site; when it is refused the circumcentre, then the middle of the longest edge
    };

    void push_if_bad(int triangle);
    void push_touched();
    bool refine_round();
    std::vector<Job> take_jobs();
    void handle_blocked(const Bad& bad, int segment);
    void work_on(const Job& job, const std::optional<SurfacePoint>& p);
    bool split_instead(const Bad& bad, const std::vector<int>& segments);
    bool too_flat(const Bad& bad, const std::vector<int>& segments, const Vec3& p);
    void give_up(const Job& job, Cause cause);
    bool crowded(int triangle, double nearest, int& shrinks) const;
    void remember_shrinks(int first_vertex, int shrinks);
    void exempt(const Bad& bad, Cause cause, int vertex = -1, int segment = -1);
    bool narrow_corner(const Bad& bad);
    bool retry_exempted();
    double shortest_edge(int triangle) const;
    int longest_edge(int triangle) const;

    Workspace& work_;
    SegmentSplitter& segments_;
    double bound_;  // radians
    std::priority_queue<Bad> queue_;
    std::vector<int> touched_;
    std::vector<Job> again_;  // fallbacks for the next round
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include "triangulate/corner_angle.h"
#include "triangulate/insertion.h"
#include "triangulate/segment_split.h"

namespace mq::triangulate {

/// Fans around the apexes of slender cones. Few triangles have room there, and refinement by itself would go on
/// towards the apex until no more than these meet by chance. Where one of them is too narrow, this puts a ring of
/// vertices at equal angles around the apex instead: half as many as before, and so much nearer that triangles between
/// the two rings are about equilateral.
class ApexRings {
  public:
    /// @param bound the least angle, radians
    /// @param chord_height mm, 0: none. The chords of a ring are to keep it.
    ApexRings(Workspace& work, SegmentSplitter& segments, double bound, double chord_height)
        : work_(work), segments_(segments), bound_(bound), chord_height_(chord_height) {}

    /// Around the origin of `h`, where that is such an apex. Changed triangles are appended to `touched`.
    /// @return whether there are any
    bool put_around(int h, std::vector<int>& touched);

  private:
    struct Ring {
        int count;            // of its vertices
        double away;          // from the apex, mm
        double least_beyond;  // the nearest vertex so far, mm
        bool holds(double length) const;
    };
    struct Apex {
        int vertex;
        int face;
        int half_edge;  // one that leaves it on that face
    };
    void find_again(Apex& apex, const std::vector<int>& touched, std::size_t first) const;
    bool narrow_widest(Apex& apex, const ApexFan& fan, std::vector<int>& touched);
    Ring ring_within(const Apex& apex, const ApexFan& fan) const;
    bool split_seam(Apex& apex, Ring& ring, std::vector<int>& touched);
    std::vector<Candidate> sites_on(const Apex& apex, const ApexFan& fan, const Ring& ring) const;
    void give_up_if_missed(const Apex& apex, const Ring& ring);
    void insert(const std::vector<Candidate>& sites, std::vector<int>& touched);

    Workspace& work_;
    SegmentSplitter& segments_;
    double bound_;
    double chord_height_;
    std::map<int, int> tries_;   // by vertex
    std::map<int, int> misses_;  // by vertex: rings that left too many triangles there
};

}  // namespace mq::triangulate

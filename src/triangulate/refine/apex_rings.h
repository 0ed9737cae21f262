// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/segment_splitter.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

/// Fans around the apexes of slender cones. Few triangles have room there, and refinement alone would go on towards
/// the apex until only these meet by chance. Where one of them is too narrow, this class inserts a ring of vertices at
/// equal angles around the apex instead: half as many as before, at such a distance that triangles between the two
/// rings are about equilateral.
class ApexRings {
  public:
    /// @param bound  the angle bound, radians
    /// @param chord_height  chord tolerance in mm that the chords of a ring keep, 0: none
    ApexRings(Workspace& work, SegmentSplitter& segments, double bound, double chord_height)
        : work_(work), segments_(segments), bound_(bound), chord_height_(chord_height) {}

    /// Inserts a ring around the origin of `h`, if that is such an apex. Changed triangles are appended to `touched`.
    /// @return whether any triangle was changed
    bool insert_ring(int h, std::vector<int>& touched);
    /// Returns the number of rings tried at all apexes.
    std::size_t tried() const { return tried_; }

    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed) {
        move_to_indices(renewed.vertices, tries_);
        move_to_indices(renewed.vertices, misses_);
    }

  private:
    struct Ring {
        int count;            // number of its vertices
        double away;          // distance from the apex, mm
        double least_beyond;  // distance of the nearest present vertex, mm
        bool holds(double length) const;
    };
    struct Apex {
        int vertex;
        int face;
        int half_edge;  // a half-edge that leaves the apex on that face
    };
    void relocate(Apex& apex, const std::vector<int>& touched, std::size_t first) const;
    bool swap_widest(Apex& apex, const ApexFan& fan, std::vector<int>& touched);
    Ring ring_within(const Apex& apex, const ApexFan& fan) const;
    bool split_seam(Apex& apex, Ring& ring, std::vector<int>& touched);
    std::vector<Candidate> sites_on(const Apex& apex, const ApexFan& fan, const Ring& ring) const;
    void count_miss(const Apex& apex, const Ring& ring);
    void insert(const std::vector<Candidate>& sites, std::vector<int>& touched);

    Workspace& work_;
    SegmentSplitter& segments_;
    double bound_;
    double chord_height_;
    std::map<int, int> tries_;  // by vertex
    std::size_t tried_ = 0;
    std::map<int, int> misses_;  // by vertex: rings that left too many triangles there
};

}  // namespace mq::triangulate

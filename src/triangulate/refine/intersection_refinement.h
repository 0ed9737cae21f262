// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "triangulate/measure/body_contacts.h"
#include "triangulate/measure/self_intersections.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/segment_splitter.h"

namespace mq::triangulate {

/// Resolves crossings of triangles of one volume: thin walls, faces that nearly touch and sharp cusps, whose chords
/// are too coarse to remain separated. Splits such triangles until they are close enough to their surfaces.
///
/// Where the shape's own faces cross, most crossings of the two are deeper than chords explain, and are kept.
class IntersectionRefinement {
  public:
    IntersectionRefinement(Workspace& work, SegmentSplitter& segments, SelfIntersections& finder, BodyContacts& bodies)
        : work_(work), segments_(segments), finder_(finder), bodies_(bodies) {}

    /// Splits all crossing triangles that are not exact yet.
    /// @return whether anything was split.
    bool run();
    /// Splits triangles of different bodies that cross where the bodies are apart in the shape.
    /// @param deviation  largest distance of the mesh from its faces, mm
    /// @return whether anything was split.
    bool run_between_bodies(double deviation);

  private:
    using Pairs = std::vector<std::array<int, 2>>;
    struct Side {
        int half_edge = -1;
        double height = 0.0;  ///< height over its surface or its curve, mm
    };
    struct Crossing {
        std::array<int, 2> pair;
        std::array<Side, 2> sides;  ///< the highest side of each triangle
        bool by_chords;             ///< whether it is no deeper than the heights of the sides explain
    };
    /// The higher sides of the crossings of two faces.
    struct Bends {
        double crossings = 0.0;  ///< their number
        double sum = 0.0;        ///< sum of heights over squared lengths, 1/mm
    };
    struct SideToSplit {
        int half_edge;
        std::uint32_t stamp;
    };

    std::vector<Crossing> crossings();
    bool folded(const std::array<int, 2>& pair) const;
    void judge(const std::vector<Crossing>& crossings);
    void request(const Crossing& crossing, std::vector<SideToSplit>& sides) const;
    bool split(std::vector<SideToSplit> sides);
    std::map<int, double> heights_of_segments(const Pairs& pairs);
    std::map<int, Side> highest_sides(const Pairs& pairs);

    Workspace& work_;
    SegmentSplitter& segments_;
    SelfIntersections& finder_;
    BodyContacts& bodies_;
    std::set<SelfIntersections::Faces> of_the_part_;
    std::map<SelfIntersections::Faces, Bends> first_;  // in the round that found crossings first
};

}  // namespace mq::triangulate

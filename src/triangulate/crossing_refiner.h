// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "triangulate/crossing_finder.h"
#include "triangulate/insertion.h"
#include "triangulate/segment_split.h"

namespace mq::triangulate {

/// Where triangles of one volume meet that should not: thin walls, faces that nearly touch and sharp cusps, whose
/// chords are too coarse to keep apart. Splits such triangles until they are as near to their surfaces as that takes.
///
/// Where the part's own faces cross, most crossings of the two are deeper than chords explain, and stay as they are.
class CrossingRefiner {
  public:
    CrossingRefiner(Workspace& work, SegmentSplitter& segments, CrossingFinder& finder)
        : work_(work), segments_(segments), finder_(finder) {}

    /// Splits all triangles that cross and are not exact already.
    /// @return whether anything was split.
    bool run();

  private:
    using Pairs = std::vector<std::array<int, 2>>;
    struct Side {
        int half_edge = -1;
        double height = 0.0;  ///< over its surface or its curve, mm
    };
    struct Crossing {
        std::array<int, 2> pair;
        std::array<Side, 2> sides;  ///< of each triangle the highest
        bool by_chords;             ///< no deeper than the heights explain
    };
    struct Site {
        int half_edge;
        std::uint32_t stamp;
    };

    std::vector<Crossing> crossings();
    double depth(int a, int b) const;
    bool folded(const std::array<int, 2>& pair) const;
    void judge(const std::vector<Crossing>& crossings);
    void request(const Crossing& crossing, std::vector<Site>& sites) const;
    bool split(const std::vector<Site>& sites);
    std::map<int, double> heights_of_segments(const Pairs& pairs);
    std::map<int, Side> highest_sides(const Pairs& pairs);

    Workspace& work_;
    SegmentSplitter& segments_;
    CrossingFinder& finder_;
    std::set<CrossingFinder::Faces> of_the_part_;
};

}  // namespace mq::triangulate

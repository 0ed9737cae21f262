// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "triangulate/chord_measure.h"
#include "triangulate/edge_marks.h"
#include "triangulate/insertion.h"
#include "triangulate/segment_split.h"
#include "triangulate/sizing.h"
#include "triangulate/triangle_marks.h"

namespace mq::triangulate {

/// Algorithm E (Aftosmis 1999, section 3.5): splits edges until none is farther from the part than a tolerance, or
/// longer than the other bounds allow. See ChordMeasure for where distances are measured.
class ChordRefiner {
  public:
    ChordRefiner(Workspace& work, SegmentSplitter& segments, ChordMeasure& measure, const Sizing& sizing)
        : work_(work), segments_(segments), measure_(measure), sizing_(sizing) {}

    /// @return whether anything was split.
    bool run();

  private:
    struct Site {
        int half_edge;
        std::uint32_t stamp;
        double excess;  // how many times over its bound
        Candidate candidate;
        std::optional<SurfacePoint> surface_point{};  // of the candidate, where it is known already
    };
    std::vector<Site> violations();
    void measure_segments(std::vector<Site>& found);
    void measure_edges(std::vector<Site>& found);
    void measure_triangles(std::vector<Site>& found);
    std::optional<int> side_to_split(int triangle) const;
    bool refused(int half_edge) const;
    void refuse(int half_edge);
    void measure_growth(std::vector<Site>& found);
    double excess(double chord) const { return sizing_.tolerance > 0.0 ? chord / sizing_.tolerance : 0.0; }
    double excess_of_edge(double chord, int half_edge) const;
    std::vector<double> turns_of(const std::vector<int>& segments);
    void split(const std::vector<Site>& sites);
    std::vector<std::optional<SurfacePoint>> surface_points_of(const std::vector<const Site*>& sites);
    void split_one(const Site& site, const std::optional<SurfacePoint>& p);

    Workspace& work_;
    SegmentSplitter& segments_;
    ChordMeasure& measure_;
    const Sizing& sizing_;
    EdgeMarks passed_;            // within all bounds
    TriangleMarks edges_passed_;  // those all of whose edges passed
    TriangleMarks measured_;      // within the tolerance, or not to be split
    using Stamps = std::array<std::uint32_t, 2>;
    std::map<int, Stamps> refused_;  // edges that could not be split, by number, and the triangles beside them then
    std::vector<int> touched_;
    bool changed_ = false;
};

}  // namespace mq::triangulate

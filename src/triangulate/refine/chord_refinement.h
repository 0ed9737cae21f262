// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "triangulate/measure/chord_error.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/segment_splitter.h"
#include "triangulate/work_mesh/element_marks.h"
#include "triangulate/work_mesh/size_bounds.h"

namespace mq::triangulate {

/// Algorithm E (Aftosmis 1999, section 3.5): splits edges until none deviates from the CAD model by more than the
/// chord tolerance, or is longer than the other bounds allow. See ChordErrorCache for where distances are measured.
class ChordRefinement {
  public:
    ChordRefinement(Workspace& work, SegmentSplitter& segments, ChordErrorCache& measure, const Sizing& sizing)
        : work_(work), segments_(segments), measure_(measure), sizing_(sizing) {}

    /// `before_round` may renumber the mesh.
    /// @return whether anything was split.
    bool run(const std::function<void()>& before_round = [] {});
    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed);

  private:
    /// A side or an inside that deviates more than allowed.
    struct Violation {
        int half_edge;
        std::uint32_t stamp;
        double excess;           // ratio of the measured value to its bound
        int surface_point = -1;  // index of the surface point of its middle; -1: not known yet
        int place = 0;           // among the violations as they were found
    };
    using Violations = LargeVector<Violation>;
    using SurfacePoints = std::vector<std::optional<SurfacePoint>>;
    static void sort_worst_first(Violations& found);
    Violations violations();
    void forget_gone_edges();
    void measure_segments(Violations& found);
    void add_unpassed_edges(int triangle, std::vector<int>& edges);
    std::vector<int> unpassed_edges();
    void measure_edges(Violations& found);
    void measure_edges(const int* first, const int* last, Violations& found);
    void measure_triangles(Violations& found);
    void measure_triangles(const std::vector<int>& triangles, Violations& found);
    std::optional<int> side_to_split(int triangle) const;
    bool refused(int half_edge) const;
    void refuse(int half_edge);
    void measure_growth(Violations& found);
    double excess(double chord) const { return sizing_.tolerance > 0.0 ? chord / sizing_.tolerance : 0.0; }
    double excess_of_edge(double chord, int half_edge) const;
    std::vector<double> turns_of(const std::vector<int>& segments);
    void split(const Violations& found);
    Violations split_in_blocks(const Violations& inner, std::size_t count);
    Violations split_block(geometry::Answerer& answerer, Workspace& block, const Violations& violations) const;
    bool split_in_block(Workspace& block, int half_edge, const SurfacePoint& p, std::vector<int>& touched) const;
    SurfacePoints surface_points_of(const Violation* first, const Violation* last);
    bool changed(const Violation& violation) const;
    bool shorten_corner(int h);
    void split_one(const Violation& violation, const std::optional<SurfacePoint>& p);

    Workspace& work_;
    SegmentSplitter& segments_;
    ChordErrorCache& measure_;
    const Sizing& sizing_;
    EdgeMarks passed_;            // within all bounds
    TriangleMarks edges_passed_;  // triangles whose edges are all within their bounds
    TriangleMarks measured_;      // triangles within the tolerance, or that cannot be split
    using Stamps = std::array<std::uint32_t, 2>;
    // Edges that could not be split, by number, and the versions of the triangles beside them.
    std::map<int, Stamps> refused_;
    LargeVector<std::optional<SurfacePoint>> known_points_;  // surface points of this round's violations
    std::vector<int> touched_;
    bool changed_ = false;
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "triangulate/refine/angle_refinement.h"
#include "triangulate/refine/chord_refinement.h"
#include "triangulate/refine/intersection_refinement.h"
#include "triangulate/report/final_report.h"

namespace mq::triangulate {

/// The fraction of the whole work that is done when refinement begins.
double share_before_refinement(const TriangulateOptions& options);

/// Refines a coarse mesh until it keeps all bounds: angles, chord height, removal of vertices, crossings, optimisation.
class Refinement {
  public:
    /// Ends the running stage and names it.
    using EndStage = std::function<void(const char*)>;

    /// `chord`: chord tolerance, mm; 0: none. Vertices from `first_vertex` on may be removed.
    Refinement(Workspace& work, MeasurementCache& findings, const TriangulateOptions& options, double chord,
               int first_vertex, EndStage end_stage);

    /// Corrects what refinement could not start with: vertices that encroach on segments, normals, doubled segments.
    void prepare();
    /// Refines the mesh.
    /// @throws Cancelled
    void run();
    /// Splits triangles of bodies that cross though the bodies are apart in the shape, until they are clear or the gap
    /// is too narrow for that. Nothing once the budget has ended the work.
    /// @throws Cancelled
    void separate_bodies();
    /// Removes smooth edges if they are not to be kept. Nothing once the budget has ended the work.
    /// @return what was done about them, for the report
    /// @throws Cancelled
    Message release_smooth_edges();

    Workspace& work() { return work_; }
    const TriangulateOptions& options() const { return options_; }
    double chord() const { return chord_; }
    const Sizing& sizing() const { return sizing_; }
    int first_vertex() const { return first_vertex_; }

  private:
    void refine_angles();
    void refine_chords();
    void refine_again();
    void order_where_grown();
    void order_in_space();
    void separate_doubled();
    bool split_crossings();
    bool split_crossings_of_bodies();
    void separate_crossings();

    Workspace& work_;
    MeasurementCache& findings_;
    const TriangulateOptions& options_;
    double chord_;
    int first_vertex_;
    EndStage end_stage_;
    Sizing sizing_;
    SegmentSplitter segments_;
    AngleRefinement angles_;
    ChordRefinement chords_;
    IntersectionRefinement crossings_;
    std::vector<int> touched_;
    // Vertices of the initial mesh keep their indices; this is their number.
    int vertices_before_;
    int sites_before_;
    int ordered_;  // number of triangles when they were ordered in space
};

}  // namespace mq::triangulate

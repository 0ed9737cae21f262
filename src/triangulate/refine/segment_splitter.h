// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/operators/insertion_cavity.h"
#include "triangulate/refine/corner_shells.h"
#include "triangulate/refine/face_size_floors.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Splits constraining edges on their CAD curves: in the middle by arc length, and near a CAD node with an acute
/// corner on concentric shells, at power-of-two multiples of the innermost (Ruppert 1995, modified segment splitting).
/// On shells the pieces at one small input angle get equal lengths, and equal pieces at less than 60 degrees do not
/// encroach on each other. Beyond the innermost pieces of corners below RefinementTuning::kWidestLadder, edges are the
/// rails of a ladder: their pieces are as long as the distance to the other edge allows for the bound.
class SegmentSplitter {
  public:
    /// To be constructed before refinement: measures the innermost shells around all CAD nodes. With `guard_apexes`,
    /// seams that end in a guarded apex are not split for the sake of angles (see ApexRings), and edges are rails of
    /// ladders. `bound` as for FaceSizeFloors.
    explicit SegmentSplitter(Workspace& work, bool guard_apexes = true, double bound = 0.0);

    /// Evaluates Φ_encroached for the apexes of the triangles beside the segment, except where the face is too narrow
    /// (see FaceSizeFloors).
    bool encroached(int segment) const;
    /// Whether the segment is an innermost piece at a small input angle, which is not split any more once it is short
    /// compared with its surroundings. Pieces on one shell could otherwise encroach on each other through their
    /// neighbours without terminating (the cascade that Shewchuk 2002 calls the terminator's problem); an innermost
    /// shell ends it, and leaves one triangle in the corner with the input angle. `corner_vertex` receives the
    /// corner's node.
    bool is_terminal(int segment, int* corner_vertex = nullptr) const;
    /// Halves the innermost shell around a CAD node, so that its pieces may be split once more: for triangles that
    /// these pieces leave below the bound although no corner there is.
    /// @return whether that was done: not again and again
    bool shrink_shell(int vertex);
    /// Whether pieces at this vertex, where a corner was cut off, enclose a larger angle the shorter they are, and are
    /// not as short yet as the corner is wide there.
    bool opens(int vertex, int segment) const;
    /// Returns the CAD node with a small input angle in or near whose innermost shell p lies, as a vertex; -1: none.
    int narrow_corner_near(const Vec3& p) const;
    /// Whether the segment is seen from p under an angle above 120 degrees.
    bool in_diametral_lens(int segment, const Vec3& p) const;

    /// Queues the segment. With `force`, innermost pieces are queued, too: for bounds on lengths and chord errors,
    /// which terminate by themselves. The other edge at its small input angle follows to the same shell.
    void request(int segment, bool force = false);
    /// Queues the segment with force, to be split not in its middle but at this distance (mm) from one of its ends. A
    /// failure does not block splits at other places.
    void request_at(int segment, int end, double distance);
    /// Splits all queued segments and all that become encroached, in batches. Changed triangles are appended to
    /// `touched`.
    void run(std::vector<int>& touched);
    /// Whether a split failed. A refusal due to `min_edge` alone counts only while that bound is in force.
    bool refused(int segment) const;
    /// Whether triangles around the origin of `h` may be changed by ApexRings only.
    bool is_apex_protected(int h) const;
    /// Marks the vertex as an apex where rings do not help.
    void free_apex(int vertex) { free_apexes_.insert(vertex); }
    bool is_free(int vertex) const { return free_apexes_.count(vertex) > 0; }
    /// Returns why the segment may not be split for the sake of angles; nothing if it may.
    std::optional<Cause> obstacle(int segment) const;
    /// Whether the segment may be split for the sake of angles.
    bool may_split(int segment) const;
    FaceSizeFloors& floors() { return floors_; }
    bool idle() const { return pending_.empty(); }
    /// Returns the number of splits tried.
    std::size_t tried() const { return tried_; }

  private:
    struct Shell {
        int end = -1;  ///< the end at whose node the shell is centred, -1: none
        double radius = 0.0;
    };
    Shell shell_of(int segment) const;
    Shell rung_of(int segment) const;
    double unresolved(int segment, int end) const;
    Shell place_of(int segment) const;
    double chord(int segment) const;
    geometry::Query place_query(int segment) const;
    void split_pending(std::vector<int>& touched);
    void split_batch(const std::vector<int>& segments, std::vector<int>& touched);
    enum class Outcome { Split, TooShort, NoPoint, Folds, Later };
    InsertionCavity cavity_for(int half_edge, const Vec3& point, geometry::Answer& on_face) const;
    Outcome split(int segment, const geometry::Answer& place, geometry::Answer* on_faces, std::vector<int>& touched);
    bool on_curve(int segment, const geometry::Answer& place) const;
    bool far_enough(int segment, const Vec3& point) const;
    Outcome wait_for(int segment, int other);
    void insert(int segment, double t, const Vec3& point, const geometry::Answer* on_faces,
                const std::vector<InsertionCavity>& cavities, std::vector<int>& touched);
    void request_encroached_around(const std::vector<int>& triangles);

    void enforce_equal_shells(int segment);

    Workspace& work_;
    FaceSizeFloors floors_;
    bool guard_apexes_;
    double step_;                           // length of a piece in distances between the rails; 0: there is no bound
    std::set<std::array<int, 2>> ladders_;  // pairs of edges that meet in corners below kWidestLadder
    std::set<int> free_apexes_;
    CornerShells shells_;               // before refinement
    std::set<int> cut_;                 // vertices where corners were cut off
    std::map<int, int> halvings_left_;  // by vertex of a CAD node: see shrink_shell
    std::vector<int> pending_;
    std::vector<char> waiting_;   // by segment
    std::map<int, Shell> asked_;  // by segment, until it is split
    std::map<int, Cause> refusals_;
    std::map<int, int> postponed_;  // by segment: number of times it waited for another one
    std::size_t tried_ = 0;
};

}  // namespace mq::triangulate

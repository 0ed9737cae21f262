// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "base/key_set.h"
#include "triangulate/operators/cavity.h"
#include "triangulate/operators/edit_transaction.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/optimise/edge_vertex_relocation.h"
#include "triangulate/optimise/tuning.h"
#include "triangulate/work_mesh/element_marks.h"
#include "triangulate/work_mesh/size_bounds.h"

namespace mq::triangulate {

/// Improves triangles below the bound that refinement has given up, by local changes: the triangles of a disc around
/// one of them (the stars of its corners and edges, itself with its neighbours) are replaced by a fan from a new
/// vertex, or from one on the boundary, if the smallest angle among them becomes larger. This moves vertices,
/// collapses edges or inserts vertices, whichever improves most; where no fan suffices, vertices on CAD edges are
/// moved along these (EdgeVertexRelocation).
///
/// Refinement fails where a long edge at a small input angle of the shape has short ones beside it: encroachment
/// forbids the vertices that a graded fan needs. Here only angles count, besides the bounds on lengths and chord
/// errors. Every change increases the smallest angle of its disc by a least amount, and the number of attempts is
/// limited.
///
/// Where no single change improves a triangle, the mesh is perturbed: a disc gets a vertex more or less; then the
/// neighbourhood is repaired, and everything is undone unless the result is better. Nothing is tried again before
/// something beside it has changed, except at the resolution, once in each pass.
class CavityOptimiser {
  public:
    /// @param attempts  attempts to improve one triangle that may be made in all
    CavityOptimiser(Workspace& work, double min_angle_degrees, const Sizing& sizing, std::size_t attempts);

    /// Applies single changes as long as one improves the mesh. @return whether anything was changed, as for all
    /// functions below.
    bool improve_once();
    /// Rounds as long as the deficit decreases sufficiently: triangles around bad ones are improved beyond the bound
    /// where they prevent changes, single changes are applied, and then perturbations.
    bool search();
    std::size_t attempts_left() const { return attempts_of_all_; }
    /// Returns the total angle deficit, radians: the sum of what triangles that could reach the bound lack.
    double missing() const;
    /// Returns the triangles below the bound that may be improvable.
    std::vector<int> bad_triangles() const;

  private:
    struct QueuedTriangle {
        double angle;
        int triangle;
        std::uint32_t stamp;
        bool operator<(const QueuedTriangle& other) const {  // for a max-heap: the smallest angle on top, ties by index
            return angle != other.angle ? angle > other.angle : triangle > other.triangle;
        }
    };
    struct Retriangulation {
        Cavity disc;
        int apex_site = -1;  ///< site on the boundary; -1: a new vertex at `apex`
        Vec3 apex = Vec3::Zero();
        double angle = 0.0;  ///< smallest angle of the fan, radians
        double before = 0.0;
    };

    /// The fans for a disc that improve it sufficiently, and the side beyond which a larger disc may be better, or -1.
    struct Fan {
        int apex_site = -1;
        Vec3 apex = Vec3::Zero();
        double angle = 0.0;
    };
    struct CavityCandidates {
        std::vector<Fan> fans;
        double before = 0.0;  ///< smallest angle of the disc, radians
        int over = -1;
    };

    void want(double angle);
    void push_if_bad(int triangle);
    bool near(int triangle) const;
    void push_all();
    bool process_queue();
    bool process_next(std::size_t& left, bool& changed);
    bool over_improve_neighbours_and_retry();
    void over_improve_neighbours();
    bool has_failed(int triangle) const;
    bool hopeless(int triangle) const;
    bool at_resolution(int triangle) const;
    bool mend(int triangle);
    std::vector<Cavity> discs_around(int triangle) const;
    const CavityCandidates& fans_of(const Cavity& disc);
    CavityCandidates search_fans(const Cavity& disc) const;
    int propose(const Cavity& disc, std::vector<Retriangulation>& proposals);
    std::vector<Cavity> grown(const std::vector<Cavity>& discs, const std::vector<int>& over) const;
    bool try_best(std::vector<Retriangulation>& proposals, double at_least);
    std::optional<SurfacePoint> apex_near(const Cavity& disc, const Vec3& p) const;
    bool within_budget(const Retriangulation& proposal);
    bool apply(const Retriangulation& proposal);
    bool slide(int triangle);

    // The following functions are implemented in perturbation_search.cpp.
    bool perturb_all();
    bool budget_spent() const;
    void count_attempt();
    bool mark_tried(int triangle);
    bool escape(int triangle);
    bool try_perturbation(const Retriangulation& fan);
    bool better() const;
    void keep(const Exemption& reason);
    bool move_corner(int triangle);
    void follow(const std::function<bool(int)>& change, double worst);
    std::vector<Retriangulation> perturbations(int triangle) const;
    void add_fans(const Cavity& disc, std::vector<Retriangulation>& fans) const;

    void requeue_around(const std::vector<int>& changed);
    double enough_after(double before) const;
    bool good_enough(const Cavity& disc, const Corner& apex, int apex_site, double before) const;
    bool near_surface(const Cavity& disc, const Corner& apex, const Vec2& uv, int apex_site) const;
    double distance_of_fan(const Cavity& disc, const Corner& apex, const Vec2& uv, int apex_site) const;
    double distance_of_disc(const Cavity& disc) const;

    Workspace& work_;
    double bound_;                // radians
    double wanted_ = 0.0;         // target angle, radians: slightly above the bound or, near some vertices, larger
    double surely_enough_ = 0.0;  // squared sine that surely exceeds the target angle
    std::vector<int> near_;       // the vertices with the larger target, ascending
    const Sizing& sizing_;
    std::priority_queue<QueuedTriangle> queue_;
    EdgeVertexRelocation slider_;
    EditTransaction undo_;         // open while changes may still be undone
    TriangleMarks failed_;         // triangles that failed, until a triangle beside them changes
    TriangleMarks failed_beyond_;  // triangles that failed with the larger target
    KeySet tried_to_escape_;
    int attempts_of_search_ = 0;  // left for the present triangle
    std::int64_t vain_attempts_left_ = OptimisationTuning::kSearchAttempts;
    std::size_t attempts_of_all_;
    double least_aligned_ = kAlignedSwap;
    KeyMap<CavityCandidates> found_;  // by disc, for the present target angle
    KeySet exhausted_;                // keys of discs for which no improvement was found, without the larger target
};

/// Improves the mesh by single changes, and by perturbations where these leave a deficit.
/// @return whether anything was changed. Leaves no unused triangle indices.
bool mend(Workspace& work, double min_angle_degrees, const Sizing& sizing);

}  // namespace mq::triangulate

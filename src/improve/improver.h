// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "improve/improve.h"
#include "improve/local_operations.h"
#include "improve/reference_surface.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::improve {

/// The improvement of one mesh: finds bad triangles, and applies changes to them.
class Improver {
  public:
    /// @param frozen  triangles whose boxes no change may reach; null: none. They outlive the object.
    Improver(const mesh::TriangleMesh& given, const ImproveOptions& options, Progress& progress,
             const mesh::AabbTree* frozen = nullptr);

    double tolerance() const { return tolerance_; }  ///< mm
    /// Works until no bad triangle can be improved.
    void run();

    const EditableMesh& mesh() const { return mesh_; }
    /// The counts, and the triangles that stay bad with the reason, by their index in mesh().
    Result counts;
    std::vector<std::pair<int, mesh::ExemptCause>> left() const;

  private:
    /// Conditions for a change: the worst angle becomes better; the tolerance is kept; the surface stays as it is.
    enum class Rule { Better, Any, Same };

    /// Saves the present mesh if it has fewer bad triangles than all meshes since the start.
    bool keep_if_best(std::size_t bad);
    bool bad(int t) const;
    /// Whether the smallest angle lies between two sharp edges, which no change can open.
    bool forced(int t) const;
    double smallest_angle(const Triangle& t) const;
    std::vector<int> bad_triangles() const;

    bool mend(int t);
    /// Whether the surroundings on which improving a triangle depends have not changed since a time.
    bool same_around(int t, int since) const;
    void note_changed(const LocalOperation& change);
    /// Whether the worst angle at a vertex becomes better where it moves to a place, leaving out the triangles that the
    /// vertex `without` has too. This test is usually quick, whereas a change must list all triangles, of which a fan
    /// has many.
    bool betters(int v, const Vec3& place, int without = -1);
    double worst_angle_at(int v);
    int add_vertex(const Vec3& point, int halvings);
    void forget_last_vertex();
    /// Makes a change that was accepted; `taken` are the new triangles' witnesses.
    void make(const LocalOperation& change, std::vector<std::vector<Vec3>> taken);
    bool swap_some(int t);
    bool collapse_some(int t);
    bool move_some(int t);
    bool move(int v);
    bool refine(int t);
    bool split(int a, int b);
    /// The point at which to divide a sharp edge: in the middle, or at a power of two from the end at which it meets
    /// another one at a small angle, so that both are divided alike (concentric shells, Ruppert 1995).
    Vec3 on_a_shell(int a, int b) const;
    void swap_around(int v);

    bool attempt(const LocalOperation& change, Rule rule, const std::vector<Vec3>& leaving = {});
    bool reaches_frozen(const LocalOperation& change) const;
    bool good_enough(const LocalOperation& change, Rule rule) const;
    bool near_enough(const LocalOperation& change) const;
    /// Assigns the witnesses of `removed`, and `leaving`, to the nearest triangles of `added`; false when one is
    /// farther than `most`, mm.
    bool hand_over(const LocalOperation& change, const std::vector<Vec3>& leaving, double most,
                   std::vector<std::vector<Vec3>>& taken) const;

    ImproveOptions options_;
    double tolerance_;
    Progress& progress_;
    const mesh::AabbTree* frozen_;
    EditableMesh mesh_;
    ReferenceSurface surface_;
    double bend_;
    double shortest_;
    int most_triangles_;
    std::vector<std::vector<Vec3>> witnesses_;  ///< by triangle: given vertices near it that were removed
    std::vector<double> angles_;                ///< by triangle: its smallest angle, degrees
    std::vector<int> halvings_;  ///< by vertex: how often edges were halved before it was inserted; 0: given
    // The number of changes made, as a clock: what failed is tried again only after a change of its surroundings.
    int now_ = 1;
    std::vector<int> changed_;                   ///< by vertex: when its triangles changed last
    std::vector<int> around_;                    ///< by vertex: when its triangles or those of a neighbour changed last
    std::vector<std::pair<int, double>> worst_;  ///< by vertex: its worst angle, and the time of its computation
    std::vector<int> mended_;                    ///< by triangle: when improving it failed last
    std::vector<int> moved_;                     ///< by vertex: when moving it failed last
    std::optional<EditableMesh::State> best_;    ///< the mesh with the fewest bad triangles since the start
    Result best_counts_;
    std::size_t fewest_bad_ = 0;
};

}  // namespace mq::improve

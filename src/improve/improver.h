// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "improve/changes.h"
#include "improve/given_surface.h"
#include "improve/improve.h"

namespace mq::improve {

/// The work on one mesh: which triangles are bad, and what is done about them.
class Improver {
  public:
    Improver(const mesh::TriangleMesh& given, const Options& options, Progress& progress);

    /// Works until no triangle is bad that can be mended.
    void run();

    const EditableMesh& mesh() const { return mesh_; }
    /// Counts, and the triangles that stay bad with the reason, by their index in mesh().
    Result counts;
    std::vector<std::pair<int, std::string>> left() const;

  private:
    /// Of a change: the worst angle becomes better; any that keeps the tolerance; the surface stays as it is.
    enum class Rule { Better, Any, Same };

    /// Keeps the mesh as it is now if it has the fewest bad triangles so far.
    bool keep_if_best(std::size_t bad);
    bool bad(int t) const;
    /// The smallest angle lies between two sharp edges, which nothing can open.
    bool forced(int t) const;
    double smallest_angle(const Triangle& t) const;
    std::vector<int> bad_triangles() const;

    bool mend(int t);
    /// Whether nothing that mending a triangle looks at has changed since a time.
    bool same_around(int t, int since) const;
    void note_changed(const Change& change);
    /// Whether the worst angle at a vertex becomes better where it moves to a place, as far as triangles go that are
    /// not at the vertex `without` too. Mostly soon said, while a change must name all triangles, of which a fan has
    /// many.
    bool betters(int v, const Vec3& place, int without = -1);
    double worst_angle_at(int v);
    int add_vertex(const Vec3& point, int halvings);
    void forget_last_vertex();
    /// Makes a change that was allowed; `taken` are the new triangles' witnesses.
    void make(const Change& change, std::vector<std::vector<Vec3>> taken);
    bool swap_some(int t);
    bool collapse_some(int t);
    bool move_some(int t);
    bool move(int v);
    bool refine(int t);
    bool split(int a, int b);
    /// Where to divide a sharp edge: in the middle, or at a power of two from the end at which it meets another one at
    /// a small angle, so that both are divided alike (concentric shells, Ruppert 1995).
    Vec3 on_a_shell(int a, int b) const;
    void swap_around(int v);

    bool attempt(const Change& change, Rule rule, const std::vector<Vec3>& leaving = {});
    bool good_enough(const Change& change, Rule rule) const;
    bool near_enough(const Change& change) const;
    /// The given vertices that `removed` stood for, and `leaving`, each with the triangle of `added` nearest to it;
    /// false when one is farther than `most`.
    bool hand_over(const Change& change, const std::vector<Vec3>& leaving, double most,
                   std::vector<std::vector<Vec3>>& taken) const;

    Options options_;
    double tolerance_;
    Progress& progress_;
    EditableMesh mesh_;
    GivenSurface surface_;
    double bend_;
    double shortest_;
    int most_triangles_;
    std::vector<std::vector<Vec3>> witnesses_;  ///< by triangle: given vertices near it that are vertices no longer
    std::vector<double> angles_;                ///< by triangle: its smallest angle, degrees
    std::vector<int> halvings_;                 ///< by vertex: how often edges were halved until it came; 0: given
    // What was tried in vain is not tried again before something has changed that it depends on. Times count changes.
    int now_ = 1;
    std::vector<int> changed_;                   ///< by vertex: when its triangles changed last
    std::vector<int> around_;                    ///< by vertex: when its triangles or those of a neighbour changed last
    std::vector<std::pair<int, double>> worst_;  ///< by vertex: its worst angle, and when that was found
    std::vector<int> mended_;                    ///< by triangle: when mending it failed last
    std::vector<int> moved_;                     ///< by vertex: when moving it failed last
    std::optional<EditableMesh::State> best_;    ///< the mesh with the fewest bad triangles so far
    Result best_counts_;
    std::size_t fewest_bad_ = 0;
};

}  // namespace mq::improve

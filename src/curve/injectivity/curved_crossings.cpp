// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_crossings.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/parallel.h"
#include "curve/bezier/bernstein.h"
#include "curve/bezier/node_orders.h"
#include "curve/injectivity/patch_pair.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/weld_vertices.h"

namespace mq::curve {

namespace {

using Pair = std::array<std::int32_t, 2>;

/// Bound of the error of control points and their differences, relative to the largest coordinate: the conversion from
/// nodes has weights whose sum of sizes is less than 100 at order 5.
constexpr double kRelativeRounding = 1024.0 * std::numeric_limits<double>::epsilon();

/// The triangles' control points about the middle of the mesh, where rounding errors are least, and their nodes.
class Patches {
  public:
    explicit Patches(const CurvedMesh& mesh) : lattice_(Lattice::of(2, mesh.order)) {
        const auto per = static_cast<std::size_t>(lattice_.size());
        const std::vector<std::int32_t> same = mesh::equal_vertices(mesh.nodes);
        const std::vector<int> order = gmsh_order(lattice_);
        Box all;
        for (const std::int32_t node : mesh.triangles) {
            all.add(mesh.nodes[static_cast<std::size_t>(node)]);
        }
        middle_ = all.empty() ? Vec3::Zero() : all.center();
        limits_.least_size = kLeastPiece * all.largest_side();
        nodes_.resize(mesh.triangles.size());
        control_.resize(mesh.triangles.size() / per);
        std::vector<Vec3> nodes(per);
        double largest = 0.0;
        for (std::size_t t = 0; t < control_.size(); ++t) {
            for (std::size_t i = 0; i < per; ++i) {
                const auto node = static_cast<std::size_t>(mesh.triangles[t * per + i]);
                const auto at = static_cast<std::size_t>(order[i]);
                nodes_[t * per + at] = same[node];
                nodes[at] = mesh.nodes[node] - middle_;
                largest = std::max(largest, nodes[at].cwiseAbs().maxCoeff());
            }
            control_[t] = nodes_to_bezier(lattice_, nodes);
        }
        limits_.rounding = kRelativeRounding * (largest + middle_.cwiseAbs().maxCoeff());
    }

    std::size_t size() const { return control_.size(); }
    const Vec3& middle() const { return middle_; }
    const std::vector<Vec3>& control(std::int32_t t) const { return control_[static_cast<std::size_t>(t)]; }
    double rounding() const { return limits_.rounding; }

    bool lie_on_each_other(std::int32_t a, std::int32_t b) const {
        for (int k = 0; k < 3; ++k) {
            if (!has_corner(b, node(a, lattice_.corner(k)))) {
                return false;
            }
        }
        return sorted_nodes(a) == sorted_nodes(b);
    }

    SharedEntities shared(std::int32_t a, std::int32_t b) const {
        SharedEntities found;
        for (int k = 0; k < 3; ++k) {
            for (int m = 0; m < 3; ++m) {
                if (node(a, lattice_.corner(k)) == node(b, lattice_.corner(m))) {
                    found.corners.push_back({k, m});
                }
            }
        }
        for (int i = 0; i < static_cast<int>(found.corners.size()); ++i) {
            for (int j = i + 1; j < static_cast<int>(found.corners.size()); ++j) {
                if (share_edge(a, b, found.corners[static_cast<std::size_t>(i)],
                               found.corners[static_cast<std::size_t>(j)])) {
                    found.edges.push_back({i, j});
                }
            }
        }
        return found;
    }

    PatchVerdict contact(std::int32_t a, std::int32_t b) const {
        return a == b ? contact_with_itself(lattice_, control(a), limits_)
                      : contact_of_patches(lattice_, control(a), control(b), shared(a, b), limits_);
    }

  private:
    std::int32_t node(std::int32_t t, int i) const {
        return nodes_[static_cast<std::size_t>(t) * static_cast<std::size_t>(lattice_.size()) +
                      static_cast<std::size_t>(i)];
    }
    bool has_corner(std::int32_t t, std::int32_t vertex) const {
        return node(t, lattice_.corner(0)) == vertex || node(t, lattice_.corner(1)) == vertex ||
               node(t, lattice_.corner(2)) == vertex;
    }
    std::vector<std::int32_t> sorted_nodes(std::int32_t t) const {
        const auto first = nodes_.begin() + static_cast<std::ptrdiff_t>(t) * lattice_.size();
        std::vector<std::int32_t> nodes(first, first + lattice_.size());
        std::sort(nodes.begin(), nodes.end());
        return nodes;
    }
    /// Whether the edges between two pairs of equal corners have the same nodes.
    bool share_edge(std::int32_t a, std::int32_t b, const std::array<int, 2>& from,
                    const std::array<int, 2>& to) const {
        if (from[0] == to[0] || from[1] == to[1]) {
            return false;
        }
        for (int i = 1; i < lattice_.degree(); ++i) {
            const auto at = [&](std::size_t side) {
                Exponents e{};
                e[static_cast<std::size_t>(from[side])] = lattice_.degree() - i;
                e[static_cast<std::size_t>(to[side])] = i;
                return lattice_.index(e);
            };
            if (node(a, at(0)) != node(b, at(1))) {
                return false;
            }
        }
        return true;
    }

    const Lattice& lattice_;
    Vec3 middle_ = Vec3::Zero();
    PatchLimits limits_;
    std::vector<std::int32_t> nodes_;         ///< by triangle in the order of the lattice; equal ones are one
    std::vector<std::vector<Vec3>> control_;  ///< by triangle
};

/// All pairs whose bounding boxes meet and that do not lie on each other, and each triangle with itself.
std::vector<Pair> candidates(const Patches& patches, const Progress* progress) {
    // Tasks of the traversal: several for each thread, so that all threads end at about the same time.
    constexpr std::size_t kTasks = 64;
    std::vector<Vec3> ends;
    std::vector<mesh::Triangle> boxes;  // each stands for the box between two points
    std::vector<Pair> pairs;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(patches.size()); ++t) {
        Box box;
        for (const Vec3& p : patches.control(t)) {
            box.add(p);
        }
        ends.push_back(box.low);
        ends.push_back(box.high);
        boxes.push_back({2 * t, 2 * t + 1, 2 * t});
        pairs.push_back({t, t});
    }
    const mesh::AabbTree tree(ends, boxes, patches.rounding());
    const std::vector<mesh::AabbTree::Task> tasks = tree.own_pair_tasks(kTasks);
    std::vector<std::vector<Pair>> found(tasks.size());
    parallel_for(static_cast<int>(tasks.size()), [&](int k) {
        CancelPace pace(progress);
        tree.for_each_own_pair(tasks[static_cast<std::size_t>(k)], [&](std::int32_t i, std::int32_t j) {
            pace.step();
            if (!patches.lie_on_each_other(i, j)) {
                found[static_cast<std::size_t>(k)].push_back({std::min(i, j), std::max(i, j)});
            }
        });
    });
    for (const std::vector<Pair>& some : found) {
        pairs.insert(pairs.end(), some.begin(), some.end());
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace

CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress) {
    // Pairs of one task: a few hundred microseconds of work, unless some are hard.
    constexpr std::size_t kAtOnce = 64;
    CurvedCrossings result;
    if (mesh.triangles.empty()) {
        return result;
    }
    const Patches patches(mesh);
    const std::vector<Pair> pairs = candidates(patches, progress);
    result.compared = pairs.size() - patches.size();
    // The end of the search must not depend on the number of threads: it is looked at between rounds.
    constexpr std::size_t kInRound = 16 * kAtOnce;
    for (std::size_t round = 0; round < pairs.size() && result.complete; round += kInRound) {
        const std::size_t end = std::min(round + kInRound, pairs.size());
        std::vector<CurvedCrossings> found((end - round + kAtOnce - 1) / kAtOnce);
        parallel_for(static_cast<int>(found.size()), [&](int k) {
            const std::size_t first = round + kAtOnce * static_cast<std::size_t>(k);
            CurvedCrossings& here = found[static_cast<std::size_t>(k)];
            for (std::size_t i = first; i < std::min(first + kAtOnce, end); ++i) {
                check_cancelled(progress);
                const auto [a, b] = pairs[i];
                const PatchVerdict verdict = patches.contact(a, b);
                if (verdict.contact == PatchContact::Crossing) {
                    here.crossing.push_back({a, b, verdict.point + patches.middle()});
                } else if (verdict.contact == PatchContact::NotProven) {
                    here.not_proven.emplace_back(a, b);
                }
            }
        });
        for (const CurvedCrossings& some : found) {
            result.crossing.insert(result.crossing.end(), some.crossing.begin(), some.crossing.end());
            result.not_proven.insert(result.not_proven.end(), some.not_proven.begin(), some.not_proven.end());
        }
        if (progress != nullptr) {
            progress->advance(static_cast<double>(end) / static_cast<double>(pairs.size()));
        }
        result.complete = end == pairs.size() || result.crossing.size() + result.not_proven.size() < kMostFound;
    }
    return result;
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_crossings.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/disjoint_sets.h"
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
        limits_.touching = kTouching * all.largest_side();
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
        find_bodies();
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
        found.may_touch = body_[static_cast<std::size_t>(a)] != body_[static_cast<std::size_t>(b)];
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

    PatchVerdict contact(std::int32_t a, std::int32_t b, int most_pairs) const {
        PatchLimits limits = limits_;
        limits.most_pairs = most_pairs;
        return a == b ? contact_with_itself(lattice_, control(a), limits)
                      : contact_of_patches(lattice_, control(a), control(b), shared(a, b), limits);
    }

  private:
    /// Triangles are of one body where edges of just two of them connect them. Where bodies lie on each other, edges in
    /// the same place have four.
    void find_bodies() {
        const auto count = static_cast<std::int32_t>(control_.size());
        std::vector<std::array<std::int32_t, 3>> edges;  // two corners, and a triangle
        for (std::int32_t t = 0; t < count; ++t) {
            for (int k = 0; k < 3; ++k) {
                const std::int32_t a = node(t, lattice_.corner(k));
                const std::int32_t b = node(t, lattice_.corner((k + 1) % 3));
                edges.push_back({std::min(a, b), std::max(a, b), t});
            }
        }
        std::sort(edges.begin(), edges.end());
        const auto same = [&](std::size_t i, std::size_t j) {
            return j < edges.size() && edges[i][0] == edges[j][0] && edges[i][1] == edges[j][1];
        };
        DisjointSets<std::int32_t> sets(control_.size());
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            while (same(i, end)) {
                ++end;
            }
            if (end == i + 2) {
                sets.unite(edges[i][2], edges[i + 1][2]);
            }
            i = end;
        }
        for (std::int32_t t = 0; t < count; ++t) {
            body_.push_back(sets.find(t));
        }
    }
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
    std::vector<std::int32_t> body_;          ///< likewise, the number of its body
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

/// Compares pairs, several at once. @return their verdicts, in their order
std::vector<PatchVerdict> verdicts(const Patches& patches, const Pair* pairs, std::size_t count, int most_pairs,
                                   std::size_t at_once, Progress* progress) {
    std::vector<PatchVerdict> found(count);
    parallel_for(static_cast<int>((count + at_once - 1) / at_once), [&](int k) {
        const std::size_t first = at_once * static_cast<std::size_t>(k);
        for (std::size_t i = first; i < std::min(first + at_once, count); ++i) {
            check_cancelled(progress);
            found[i] = patches.contact(pairs[i][0], pairs[i][1], most_pairs);
        }
    });
    return found;
}

/// Compares the pairs that a few comparisons of pieces decide. @return the others
std::vector<Pair> compare_quickly(const Patches& patches, const std::vector<Pair>& pairs, CurvedCrossings& result,
                                  Progress* progress) {
    // Pieces of a pair: nearly all pairs need fewer.
    constexpr int kFew = 48;
    // Pairs of one task, a few hundred microseconds of work, and between two reports of the progress.
    constexpr std::size_t kAtOnce = 64;
    constexpr std::size_t kInRound = 256 * kAtOnce;
    std::vector<Pair> left;
    for (std::size_t round = 0; round < pairs.size(); round += kInRound) {
        const std::size_t count = std::min(kInRound, pairs.size() - round);
        const std::vector<PatchVerdict> found = verdicts(patches, pairs.data() + round, count, kFew, kAtOnce, progress);
        for (std::size_t i = 0; i < count; ++i) {
            const Pair& pair = pairs[round + i];
            if (found[i].contact == PatchContact::Crossing) {
                result.crossing.push_back({pair[0], pair[1], found[i].point + patches.middle()});
            } else if (found[i].contact == PatchContact::Touching) {
                result.touching.emplace_back(pair[0], pair[1]);
            } else if (found[i].contact == PatchContact::NotProven && found[i].looked_at >= kFew) {
                left.push_back(pair);
            } else if (found[i].contact == PatchContact::NotProven) {
                result.not_proven.emplace_back(pair[0], pair[1]);
            }
        }
        if (progress != nullptr) {
            progress->advance(0.5 * static_cast<double>(round + count) / static_cast<double>(pairs.size()));
        }
    }
    return left;
}

}  // namespace

CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress, const CrossingEffort& effort) {
    CurvedCrossings result;
    if (mesh.triangles.empty()) {
        return result;
    }
    const Patches patches(mesh);
    const std::vector<Pair> pairs = candidates(patches, progress);
    result.compared = pairs.size() - patches.size();
    const std::vector<Pair> left = compare_quickly(patches, pairs, result, progress);
    // What is left of the effort must not depend on the number of threads: it is looked at between rounds.
    constexpr std::size_t kInRound = 32;
    const std::size_t most = effort.base + effort.for_each_triangle * patches.size();
    std::size_t looked_at = 0;
    for (std::size_t round = 0; round < left.size(); round += kInRound) {
        const std::size_t count = std::min(kInRound, left.size() - round);
        const bool given_up = looked_at >= most;
        const std::vector<PatchVerdict> found =
            given_up ? std::vector<PatchVerdict>(count)
                     : verdicts(patches, left.data() + round, count, kMostPiecePairs, 1, progress);
        for (std::size_t i = 0; i < count; ++i) {
            const Pair& pair = left[round + i];
            looked_at += static_cast<std::size_t>(found[i].looked_at);
            if (found[i].contact == PatchContact::Crossing) {
                result.crossing.push_back({pair[0], pair[1], found[i].point + patches.middle()});
            } else if (found[i].contact == PatchContact::Touching) {
                result.touching.emplace_back(pair[0], pair[1]);
            } else if (given_up || found[i].contact == PatchContact::NotProven) {
                result.not_proven.emplace_back(pair[0], pair[1]);
                result.given_up += given_up ? 1 : 0;
            }
        }
        if (progress != nullptr) {
            progress->advance(0.5 + 0.5 * static_cast<double>(round + count) / static_cast<double>(left.size()));
        }
    }
    std::sort(result.not_proven.begin(), result.not_proven.end());
    std::sort(result.touching.begin(), result.touching.end());
    std::sort(result.crossing.begin(), result.crossing.end(), [](const auto& a, const auto& b) {
        return Pair{a.a, a.b} < Pair{b.a, b.b};
    });
    return result;
}

}  // namespace mq::curve

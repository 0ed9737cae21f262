// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_crossings.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/parallel.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::curve {

namespace {

using Pair = std::array<std::int32_t, 2>;

/// All pairs whose bounding boxes meet and that do not lie on each other, and the pair of each patch with itself.
std::vector<Pair> candidates(const SurfacePatches& patches, const Progress* progress) {
    // Tasks of the traversal: several for each thread, so that all threads end at about the same time.
    constexpr std::size_t kTasks = 64;
    std::vector<Vec3> ends;
    std::vector<mesh::Triangle> boxes;  // degenerate triangles with the boxes of the patches
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

/// Compares pairs in parallel. @return their verdicts, in their order
std::vector<PatchVerdict> verdicts(const SurfacePatches& patches, const Pair* pairs, std::size_t count, int most_pairs,
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

/// The verdicts by pairs of sides: all pairs of patches of the same two sides become one pair.
class PairsOfSides {
  public:
    explicit PairsOfSides(const SurfacePatches& patches) : patches_(patches) {}

    void add(const Pair& pair, const PatchVerdict& verdict, bool given_up) {
        const std::int32_t a = patches_.side(pair[0]);
        const std::int32_t b = patches_.side(pair[1]);
        const Pair sides{std::min(a, b), std::max(a, b)};
        if (verdict.contact == PatchContact::Crossing) {
            crossing_.push_back({sides[0], sides[1], verdict.point + patches_.middle()});
        } else if (verdict.contact == PatchContact::Touching) {
            touching_.push_back(sides);
        } else if (given_up || verdict.contact == PatchContact::NotProven) {
            open_.push_back(sides);
            if (given_up) {
                given_up_.push_back(sides);
            }
        }
    }

    /// Each pair once. It crosses if one of its pairs of patches does, and touches only if none of these is undecided.
    CurvedCrossings result() {
        CurvedCrossings found;
        const auto pair_of = [](const CurvedCrossings::Crossing& c) { return Pair{c.a, c.b}; };
        std::stable_sort(crossing_.begin(), crossing_.end(),
                         [&](const auto& a, const auto& b) { return pair_of(a) < pair_of(b); });
        std::vector<Pair> known;
        for (const CurvedCrossings::Crossing& crossing : crossing_) {
            if (known.empty() || known.back() != pair_of(crossing)) {
                found.crossing.push_back(crossing);
                known.push_back(pair_of(crossing));
            }
        }
        found.given_up = without(given_up_, known).size();
        for (const Pair& pair : without(open_, known)) {
            found.not_proven.emplace_back(pair[0], pair[1]);
            known.push_back(pair);
        }
        std::sort(known.begin(), known.end());
        for (const Pair& pair : without(touching_, known)) {
            found.touching.emplace_back(pair[0], pair[1]);
        }
        return found;
    }

  private:
    /// The pairs in ascending order, each once, without those of a sorted list.
    static std::vector<Pair> without(std::vector<Pair> pairs, const std::vector<Pair>& others) {
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        std::vector<Pair> left;
        std::set_difference(pairs.begin(), pairs.end(), others.begin(), others.end(), std::back_inserter(left));
        return left;
    }

    const SurfacePatches& patches_;
    std::vector<CurvedCrossings::Crossing> crossing_;
    std::vector<Pair> open_;
    std::vector<Pair> given_up_;
    std::vector<Pair> touching_;
};

/// Compares the pairs that a few comparisons of pieces decide. @return the undecided pairs
std::vector<Pair> compare_quickly(const SurfacePatches& patches, const std::vector<Pair>& pairs,
                                  PairsOfSides& pairs_of_sides, Progress* progress) {
    // Comparisons of pieces for one pair: nearly all pairs need fewer.
    constexpr int kFew = 48;
    // Pairs of one task: a few hundred microseconds of work between two reports of the progress.
    constexpr std::size_t kPairsAtOnce = 64;
    constexpr std::size_t kInRound = 256 * kPairsAtOnce;
    std::vector<Pair> left;
    for (std::size_t round = 0; round < pairs.size(); round += kInRound) {
        const std::size_t count = std::min(kInRound, pairs.size() - round);
        const std::vector<PatchVerdict> found =
            verdicts(patches, pairs.data() + round, count, kFew, kPairsAtOnce, progress);
        for (std::size_t i = 0; i < count; ++i) {
            if (found[i].contact == PatchContact::NotProven && found[i].looked_at >= kFew) {
                left.push_back(pairs[round + i]);
            } else {
                pairs_of_sides.add(pairs[round + i], found[i], false);
            }
        }
        if (progress != nullptr) {
            progress->advance(0.5 * static_cast<double>(round + count) / static_cast<double>(pairs.size()));
        }
    }
    return left;
}

}  // namespace

CurvedCrossings curved_crossings(const SurfacePatches& patches, Progress* progress, const CrossingEffort& effort) {
    const std::vector<Pair> pairs = candidates(patches, progress);
    PairsOfSides pairs_of_sides(patches);
    const std::vector<Pair> left = compare_quickly(patches, pairs, pairs_of_sides, progress);
    // The remaining effort must not depend on the number of threads: it is only read between rounds.
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
            looked_at += static_cast<std::size_t>(found[i].looked_at);
            pairs_of_sides.add(left[round + i], found[i], given_up);
        }
        if (progress != nullptr) {
            progress->advance(0.5 + 0.5 * static_cast<double>(round + count) / static_cast<double>(left.size()));
        }
    }
    CurvedCrossings result = pairs_of_sides.result();
    result.compared = pairs.size() - patches.size();
    return result;
}

CurvedCrossings curved_crossings(const CurvedMesh& mesh, Progress* progress, const CrossingEffort& effort) {
    const SideBlock triangles{elements::ElementKind::Triangle, mesh.order, static_cast<int>(mesh.nodes_per_triangle()),
                              mesh.triangles};
    return curved_crossings(SurfacePatches(mesh.nodes, {triangles}), progress, effort);
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "base/predicates.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/embedded_star.h"
#include "mesh/intersection/height_fields.h"
#include "mesh/intersection/needle_frame.h"
#include "mesh/intersection/vertex_grid.h"
#include "mesh/vertex_stars.h"

namespace mq::mesh {
namespace {

/// Takes pairs whose boxes meet, and keeps those that are in contact.
class Collector {
  public:
    /// `patch`: for each triangle a patch without contacts, or -1; empty: no patches are known.
    /// `embedded`: for each vertex at which several patches meet whether no two triangles of its star are in contact.
    Collector(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
              const std::vector<std::int32_t>& patch, const std::vector<char>& embedded, std::size_t limit,
              const Progress* progress)
        : vertices_(vertices),
          triangles_(triangles),
          patch_(patch),
          embedded_(embedded),
          limit_(limit),
          progress_(progress) {}

    /// False once the number of pairs reaches the limit.
    bool operator()(std::int32_t i, std::int32_t j) {
        // Pairs tested between two checks for cancellation.
        constexpr std::uint32_t kPairsBetweenChecks = 1u << 16;
        if (progress_ != nullptr && ++asked_ % kPairsBetweenChecks == 0) {
            progress_->check();
        }
        if (in_one_patch(i, j) || settled(triangles_[i], triangles_[j])) {
            return true;
        }
        const auto [a, b] = std::minmax(i, j);
        const Contact how = contact(vertices_, triangles_[a], triangles_[b]);
        if (how != Contact::None) {
            found_.push_back({a, b, how});
        }
        return found_.size() < limit_;
    }

    std::vector<ContactPair> release() { return std::move(found_); }

  private:
    bool in_one_patch(std::int32_t i, std::int32_t j) const {
        return !patch_.empty() && patch_[i] >= 0 && patch_[i] == patch_[j];
    }
    bool settled(const Triangle& t, const Triangle& s) const {
        for (const std::int32_t v : t) {
            if ((v == s[0] || v == s[1] || v == s[2]) && embedded_[v] != 0) {
                return true;
            }
        }
        return false;
    }

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    const std::vector<std::int32_t>& patch_;
    const std::vector<char>& embedded_;
    std::size_t limit_;
    const Progress* progress_;
    std::uint32_t asked_ = 0;
    std::vector<ContactPair> found_;
};

Box box_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
           const std::vector<std::int32_t>& subset) {
    Box box;
    for (const std::int32_t t : subset) {
        for (const std::int32_t v : triangles[t]) {
            box.add(vertices[v]);
        }
    }
    return box;
}

/// A grid whose cells are marked if they meet boxes of some triangles: a quick test of triangles that may meet these.
class OccupiedCells {
  public:
    OccupiedCells(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                  const std::vector<std::int32_t>& marked)
        : grid_(vertices, box_of(vertices, triangles, marked),
                {VertexGrid::kMostCells, VertexGrid::kMostCells, VertexGrid::kMostCells}),
          occupied_(grid_.size(), 0) {
        for (const std::int32_t t : marked) {
            all_ = all_ || !grid_.visit(triangles[t], kMostMarked, [this](std::size_t cell) {
                occupied_[cell] = 1;
                return true;
            });
        }
    }

    /// False only if the triangle's box meets no box of a marked triangle.
    bool may_meet(const Triangle& t) const {
        return all_ || !grid_.visit(t, kMostAsked, [this](std::size_t cell) { return occupied_[cell] == 0; });
    }

  private:
    static constexpr int kMostMarked = 4096;  ///< cells of one triangle at most; larger triangles make the grid useless
    /// Most cells of a tested triangle; for larger triangles the test would take too long.
    static constexpr int kMostAsked = 64;

    VertexGrid grid_;
    std::vector<char> occupied_;
    bool all_ = false;  ///< whether everything may meet the marked triangles
};

/// Calls work(0) and work(1), at the same time where there are triangles enough.
template <typename Work>
void do_both(std::size_t triangles, const Work& work) {
    // Number of triangles per thread above which waking the thread pays.
    constexpr std::size_t kWorthAThread = 4096;
    const ThreadLimit limit(threads_for(triangles, kWorthAThread));
    parallel_for(2, work);
}

std::vector<ContactPair> sorted(std::vector<ContactPair>&& pairs) {
    std::sort(pairs.begin(), pairs.end(),
              [](const ContactPair& p, const ContactPair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
    return std::move(pairs);
}

/// By vertex: 0 if it lies inside of a patch or on the border of one patch only, else 1.
std::vector<char> between_patches(std::size_t vertex_count, const std::vector<Triangle>& triangles,
                                  const std::vector<std::int32_t>& patch) {
    // The vertex belongs to no patch yet.
    constexpr std::int32_t kUnseen = -2;
    std::vector<std::int32_t> own(vertex_count, kUnseen);
    std::vector<char> result(vertex_count, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::int32_t v : triangles[t]) {
            result[v] |= static_cast<char>(patch[t] < 0 || (own[v] != kUnseen && own[v] != patch[t]));
            own[v] = patch[t];
        }
    }
    return result;
}

/// For each vertex at which several patches meet: whether no two triangles of its star are in contact.
std::vector<char> embedded_vertices(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                    const std::vector<std::int32_t>& patch, const Progress* progress) {
    // Vertices in one parallel task: enough that starting a task costs little.
    constexpr std::size_t kVerticesAtOnce = 8192;
    std::vector<char> embedded = between_patches(vertices.size(), triangles, patch);
    std::vector<Triangle> around;  // all triangles with such a vertex
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(around), [&](const Triangle& t) {
        return std::any_of(t.begin(), t.end(), [&](std::int32_t v) { return embedded[v] != 0; });
    });
    const VertexStars stars(around, vertices.size());
    parallel_for(static_cast<int>((vertices.size() + kVerticesAtOnce - 1) / kVerticesAtOnce), [&](int k) {
        check_cancelled(progress);
        const std::size_t first = kVerticesAtOnce * static_cast<std::size_t>(k);
        for (std::size_t v = first; v < std::min(first + kVerticesAtOnce, vertices.size()); ++v) {
            embedded[v] = static_cast<char>(embedded[v] != 0 && embedded_star(vertices, around, stars[v]));
        }
    });
    return embedded;
}

}  // namespace

SelfIntersectionSearch::SelfIntersectionSearch(const std::vector<Vec3>& vertices,
                                               const std::vector<Triangle>& triangles, const Progress* progress)
    : vertices_(vertices), triangles_(triangles), progress_(progress) {
    // Number of triangles above which a patch saves more tests of pairs than its proof costs.
    constexpr std::size_t kWorthAProof = 64;
    do_both(triangles.size(), [&](int task) {
        if (task == 0) {
            patch_ = height_fields(vertices, triangles, kWorthAProof, progress);
        } else {
            frame_.emplace(vertices, triangles);
            check_cancelled(progress);
            tree_.emplace(frame_->vertices(), triangles, frame_->slack());
        }
    });
    check_cancelled(progress);
}

std::vector<ContactPair> SelfIntersectionSearch::pairs(std::size_t limit) {
    const std::vector<char> embedded = embedded_vertices(vertices_, triangles_, patch_, progress_);
    tree_->set_groups(patch_);
    // Tasks of the traversal within a node: several for each thread, so that all threads end at about the same time.
    constexpr std::size_t kTasks = 64;
    const std::vector<AabbTree::Task> tasks = tree_->own_pair_tasks(kTasks);
    // With a limit the tasks run in groups, so that the search can end early; each group is larger than the one before,
    // as each starts threads. The first pairs do not depend on the groups.
    std::size_t turn = limit == kAllPairs ? tasks.size() : 8;
    std::vector<ContactPair> all;
    for (std::size_t first = 0; first < tasks.size() && all.size() < limit;) {
        std::vector<std::vector<ContactPair>> found(std::min(turn, tasks.size() - first));
        parallel_for(static_cast<int>(found.size()), [&](int k) {
            check_cancelled(progress_);  // a collector checks for a cancellation only after many pairs
            Collector collector(vertices_, triangles_, patch_, embedded, limit, progress_);
            tree_->for_each_own_pair(tasks[first + static_cast<std::size_t>(k)], collector);
            found[static_cast<std::size_t>(k)] = collector.release();
        });
        for (const std::vector<ContactPair>& part : found) {
            all.insert(all.end(), part.begin(), part.end());
        }
        first += found.size();
        turn *= 2;
    }
    all.resize(std::min(all.size(), limit));
    return sorted(std::move(all));
}

std::vector<ContactPair> self_intersections(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                            std::size_t limit, const Progress* progress) {
    return SelfIntersectionSearch(vertices, triangles, progress).pairs(limit);
}

std::vector<ContactPair> self_intersections_with(const std::vector<Vec3>& vertices,
                                                 const std::vector<Triangle>& triangles,
                                                 const std::vector<std::int32_t>& subset, std::size_t limit,
                                                 const Progress* progress) {
    // The star of the vertex was not tested yet.
    constexpr char kUnasked = 2;
    const NeedleFrame frame(vertices, triangles);
    const OccupiedCells cells(vertices, triangles, subset);
    std::vector<char> in_subset(triangles.size(), 0);
    for (const std::int32_t t : subset) {
        in_subset[t] = 1;
    }
    std::vector<std::int32_t> near;
    std::vector<Triangle> near_triangles;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (cells.may_meet(triangles[k])) {
            near.push_back(static_cast<std::int32_t>(k));
            near_triangles.push_back(triangles[k]);
        }
    }
    // A vertex that two triangles of a pair share belongs to the subset or its neighbours, whose stars are complete.
    std::vector<char> embedded(vertices.size(), kUnasked);
    const auto ask_stars = [&] {
        const VertexStars stars(near_triangles, vertices.size());
        for (const std::int32_t t : subset) {
            for (const std::int32_t v : triangles[t]) {
                if (embedded[v] == kUnasked) {
                    embedded[v] = static_cast<char>(embedded_star(vertices, near_triangles, stars[v]));
                }
            }
        }
    };
    std::optional<AabbTree> part;
    std::optional<AabbTree> whole;
    do_both(triangles.size(), [&](int task) {
        if (task == 0) {
            ask_stars();
            part.emplace(frame.vertices(), triangles, subset, frame.slack());
        } else {
            whole.emplace(frame.vertices(), triangles, near, frame.slack());
        }
    });
    const std::vector<std::int32_t> no_patches;
    Collector collector(vertices, triangles, no_patches, embedded, limit, progress);
    part->for_each_pair(*whole, [&](std::int32_t i, std::int32_t j) {
        return i == j || (in_subset[j] != 0 && j < i) || collector(i, j);
    });
    return sorted(collector.release());
}

}  // namespace mq::mesh

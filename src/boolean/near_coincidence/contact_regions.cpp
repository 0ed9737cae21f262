// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/contact_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "boolean/near_coincidence/tuning.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::boolean {

namespace {

/// Two triangles of different operands that face each other.
struct FacingPair {
    std::array<std::int32_t, 2> operands{};
    bool same_side = false;  ///< their normals have the same direction
    std::int32_t earlier = -1;
    std::int32_t later = -1;
    Overlap overlap;

    double middle() const { return std::abs(overlap.low + overlap.high); }
    auto key() const { return std::tie(operands, same_side, later, earlier); }
};

/// All pairs of triangles of different operands that face each other within `reach`, sorted.
std::vector<FacingPair> facing_pairs(const Soup& soup, const FacingSearch& search,
                                     const std::vector<CoincidentTriangle>& twins, double reach,
                                     const Progress& progress) {
    // Triangles of one task: enough that starting a task costs little.
    constexpr std::size_t kTrianglesAtOnce = 2048;
    const std::vector<std::int32_t>& near = search.near();
    std::vector<char> twin(soup.triangles.size(), 0);
    for (const CoincidentTriangle& triangle : twins) {
        twin[static_cast<std::size_t>(triangle.triangle)] = 1;
    }
    std::vector<std::vector<FacingPair>> found((near.size() + kTrianglesAtOnce - 1) / kTrianglesAtOnce);
    parallel_for(static_cast<int>(found.size()), [&](int k) {
        check_cancelled(&progress);
        const std::size_t first = kTrianglesAtOnce * static_cast<std::size_t>(k);
        for (std::size_t i = first; i < std::min(first + kTrianglesAtOnce, near.size()); ++i) {
            if (twin[static_cast<std::size_t>(near[i])] != 0) {
                continue;
            }
            search.for_each_facing(near[i], reach, 0.0, [&](std::int32_t earlier, const Overlap& overlap) {
                found[static_cast<std::size_t>(k)].push_back({{operand_of(soup, earlier), operand_of(soup, near[i])},
                                                              overlap.same_side,
                                                              earlier,
                                                              near[i],
                                                              overlap});
            });
        }
    });
    std::vector<FacingPair> result;
    for (const std::vector<FacingPair>& part : found) {
        result.insert(result.end(), part.begin(), part.end());
    }
    std::sort(result.begin(), result.end(), [](const FacingPair& a, const FacingPair& b) { return a.key() < b.key(); });
    return result;
}

/// Removes pairs with another sheet of one of the two operands between them: the far sides of thin walls.
class FarSides {
  public:
    FarSides(const Soup& soup, double reach) : soup_(soup), reach_(reach) {}

    void remove(std::vector<FacingPair>& pairs) const {
        const auto same_side = [](const FacingPair& pair) { return pair.same_side; };
        if (std::all_of(pairs.begin(), pairs.end(), same_side) || std::none_of(pairs.begin(), pairs.end(), same_side)) {
            return;
        }
        std::vector<char> far(pairs.size(), 0);
        mark(pairs, &FacingPair::earlier, &FacingPair::later, far);
        mark(pairs, &FacingPair::later, &FacingPair::earlier, far);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (far[i] == 0) {
                pairs[kept++] = pairs[i];
            }
        }
        pairs.resize(kept);
    }

  private:
    using Side = std::int32_t FacingPair::*;

    /// Marks the pairs of one triangle `own` whose triangle `other` lies behind that of another pair.
    void mark(const std::vector<FacingPair>& pairs, Side own, Side other, std::vector<char>& far) const {
        std::vector<std::size_t> order(pairs.size());
        std::iota(order.begin(), order.end(), 0);
        const auto group = [&](std::size_t i) { return std::tuple(pairs[i].operands, pairs[i].*own); };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::tuple(group(a), pairs[a].same_side, a) < std::tuple(group(b), pairs[b].same_side, b);
        });
        for (auto first = order.begin(); first != order.end();) {
            const auto last =
                std::find_if(first, order.end(), [&](std::size_t i) { return group(i) != group(*first); });
            const auto same = std::find_if(first, last, [&](std::size_t i) { return pairs[i].same_side; });
            if (first != same && same != last) {
                mark_behind(pairs, {first, same}, {same, last}, other, far);
                mark_behind(pairs, {same, last}, {first, same}, other, far);
            }
            first = last;
        }
    }

    /// Marks those of some pairs that lie behind one of the others.
    void mark_behind(const std::vector<FacingPair>& pairs, const std::vector<std::size_t>& some,
                     const std::vector<std::size_t>& others, Side other, std::vector<char>& far) const {
        std::map<std::int32_t, double> distance;
        std::vector<std::int32_t> sheet;
        for (const std::size_t i : others) {
            distance.emplace(pairs[i].*other, pairs[i].middle());
            sheet.push_back(pairs[i].*other);
        }
        const mesh::AabbTree tree(soup_.vertices, soup_.triangles, sheet);
        for (const std::size_t i : some) {
            const std::array<Vec3, 3> q = corners(soup_, pairs[i].*other);
            tree.for_each_in_box(swept(q, reach_), [&](std::int32_t t) {
                const bool behind =
                    distance.at(t) < pairs[i].middle() && overlap_of(corners(soup_, t), q, reach_).area > 0.0;
                far[i] = static_cast<char>(far[i] != 0 || behind);
                return far[i] == 0;
            });
        }
    }

    const Soup& soup_;
    double reach_;
};

/// A connected set of pairs of the same two operands, on the same side.
struct Region {
    std::vector<const FacingPair*> pairs;

    /// Whether kContactShare of the region's area is within a distance.
    bool is_within(double distance) const {
        double sum = 0.0;
        for (const FacingPair* pair : pairs) {
            sum += pair->overlap.worst <= distance ? pair->overlap.area : 0.0;
        }
        return sum >= NearCoincidenceTuning::kContactShare * area();
    }
    /// The distance, mm, within which kContactShare of the region's area is. Sorts the pairs by their largest distance.
    double gap() {
        std::sort(pairs.begin(), pairs.end(), [](const FacingPair* a, const FacingPair* b) {
            return std::pair(a->overlap.worst, a) < std::pair(b->overlap.worst, b);
        });
        const double share = NearCoincidenceTuning::kContactShare * area();
        double sum = 0.0;
        for (const FacingPair* pair : pairs) {
            sum += pair->overlap.area;
            if (sum >= share) {
                return pair->overlap.worst;
            }
        }
        return pairs.back()->overlap.worst;
    }
    double area() const {
        return std::accumulate(pairs.begin(), pairs.end(), 0.0,
                               [](double sum, const FacingPair* pair) { return sum + pair->overlap.area; });
    }
    /// A lower bound of the region's length, mm.
    double length() const {
        Box box;
        for (const FacingPair* pair : pairs) {
            box.add(pair->overlap.box);
        }
        return (box.high - box.low).norm();
    }
};

/// Pairs of the same two operands and the same side, joined by common triangles to regions.
/// @param last  for each triangle of the soup -1, before and after the call
std::vector<Region> regions_of(const FacingPair* begin, const FacingPair* end, std::vector<std::int32_t>& last) {
    const auto size = static_cast<std::size_t>(end - begin);
    DisjointSets<std::int32_t> sets(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (const std::int32_t triangle : {begin[i].earlier, begin[i].later}) {
            std::int32_t& before = last[static_cast<std::size_t>(triangle)];
            if (before >= 0) {
                sets.unite(before, static_cast<std::int32_t>(i));
            }
            before = static_cast<std::int32_t>(i);
        }
    }
    std::int32_t count = 0;
    const std::vector<std::int32_t> number = sets.number(count);
    std::vector<Region> result(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < size; ++i) {
        result[static_cast<std::size_t>(number[i])].pairs.push_back(begin + i);
        last[static_cast<std::size_t>(begin[i].earlier)] = last[static_cast<std::size_t>(begin[i].later)] = -1;
    }
    return result;
}

}  // namespace

std::vector<ContactFace> contact_faces(const Soup& soup, const FacingSearch& search,
                                       const std::vector<CoincidentTriangle>& twins, double tolerance, double least,
                                       const Progress& progress) {
    const double reach = 2.0 * tolerance;
    std::vector<FacingPair> pairs = facing_pairs(soup, search, twins, reach, progress);
    FarSides(soup, reach).remove(pairs);
    std::vector<ContactFace> result;
    std::vector<std::int32_t> last(pairs.empty() ? 0 : soup.triangles.size(), -1);
    const auto one_surface = [](const FacingPair& a, const FacingPair& b) {
        return a.operands == b.operands && a.same_side == b.same_side;
    };
    for (const FacingPair* begin = pairs.data(); begin != pairs.data() + pairs.size();) {
        const FacingPair* end = begin;
        while (end != pairs.data() + pairs.size() && one_surface(*begin, *end)) {
            ++end;
        }
        for (Region& region : regions_of(begin, end, last)) {
            if (!region.is_within(tolerance)) {
                continue;
            }
            const double gap = region.gap();
            if (region.area() < NearCoincidenceTuning::kLeastWidth * gap * region.length()) {
                continue;
            }
            const double most = std::min(reach, NearCoincidenceTuning::kLargestGap * gap + least);
            for (const FacingPair* pair : region.pairs) {
                if (-pair->overlap.low <= most && pair->overlap.high <= most) {
                    result.push_back(
                        {pair->earlier, pair->later, pair->overlap.low, pair->overlap.high, most, pair->same_side});
                }
            }
        }
        begin = end;
    }
    for (const CoincidentTriangle& twin : twins) {
        if (operand_of(soup, twin.of) < operand_of(soup, twin.triangle)) {
            result.push_back({twin.of, twin.triangle, 0.0, 0.0, least, twin.turn > 0});
        }
    }
    std::sort(result.begin(), result.end(), [&](const ContactFace& a, const ContactFace& b) {
        return std::tuple(operand_of(soup, a.later), a.later, a.earlier) <
               std::tuple(operand_of(soup, b.later), b.later, b.earlier);
    });
    return result;
}

}  // namespace mq::boolean

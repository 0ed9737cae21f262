// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_snapping.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "base/segment_distance.h"
#include "boolean/arrangement/point_table.h"
#include "boolean/rounding/planar_pieces.h"
#include "mesh/intersection/triangle_contact.h"

namespace mq::boolean {

namespace {

bool has(const Triangle& t, std::int32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

/// Vertices at most this many times the reach apart are merged. From the root of the golden ratio, 1.272, on, a vertex
/// that is not merged with an end of an edge, and passes by it within the reach, divides it into two shorter ones: with
/// finitely many vertices snapping to edges ends.
constexpr double kMerge = 1.28;

/// The vertices snapped to one triangle.
struct Snapped {
    std::array<std::vector<std::int32_t>, 3> on_edge;
    std::vector<std::int32_t> inside;
};

/// One pass over the hot vertices of a surface.
class SnapPass {
  public:
    SnapPass(RoundedSurface& surface, double reach, const std::function<Vec3(const Vec3&)>& rounded,
             const Progress& progress)
        : surface_(surface), reach_(reach), rounded_(rounded), progress_(progress) {}

    std::size_t run(const std::vector<TrianglePair>& contacts) {
        const std::vector<std::int32_t> hot = hot_vertices(contacts);
        merge(hot);
        std::vector<std::int32_t> centres = vertices_between_edges(contacts);
        std::copy_if(hot.begin(), hot.end(), std::back_inserter(centres), [&](std::int32_t v) { return root(v) == v; });
        for (const std::int32_t v : centres) {
            progress_.check();
            lead_through(v);
        }
        apply();
        return events_;
    }

  private:
    /// The corners of triangles in contact or without area: operands' own first, so that made ones move to them.
    std::vector<std::int32_t> hot_vertices(const std::vector<TrianglePair>& contacts) const {
        std::vector<std::int32_t> hot;
        for (const TrianglePair& pair : contacts) {
            for (const std::int32_t t : pair) {
                hot.insert(hot.end(), surface_.triangle(t).begin(), surface_.triangle(t).end());
            }
        }
        for (const std::int32_t t : surface_.flat()) {
            hot.insert(hot.end(), surface_.triangle(t).begin(), surface_.triangle(t).end());
        }
        std::sort(hot.begin(), hot.end());
        hot.erase(std::unique(hot.begin(), hot.end()), hot.end());
        std::stable_partition(hot.begin(), hot.end(), [&](std::int32_t v) { return !surface_.made(v); });
        return hot;
    }

    std::int32_t root(std::int32_t v) const {
        const auto found = merged_.find(v);
        return found != merged_.end() ? found->second : v;
    }

    /// Merges vertices into hot ones. A hot vertex that has not been merged is a centre; those around it are merged
    /// into it, unless they are centres.
    void merge(const std::vector<std::int32_t>& hot) {
        std::unordered_set<std::int32_t> centres;
        for (const std::int32_t centre : hot) {
            if (merged_.count(centre) > 0) {
                continue;
            }
            centres.insert(centre);
            surface_.for_each_near(surface_.at(centre), kMerge * reach_, [&](std::int32_t t) {
                for (const std::int32_t v : surface_.triangle(t)) {
                    if (centres.count(v) == 0 && (surface_.at(v) - surface_.at(centre)).norm() <= kMerge * reach_ &&
                        merged_.emplace(v, centre).second) {
                        ++events_;
                    }
                }
            });
        }
        for (const auto& entry : merged_) {
            surface_.for_each_near(surface_.at(entry.first), reach_, [&](std::int32_t t) {
                if (has(surface_.triangle(t), entry.first)) {
                    snapped_[t];
                }
            });
        }
    }

    /// New vertices where edges of triangles in contact pass by each other.
    std::vector<std::int32_t> vertices_between_edges(const std::vector<TrianglePair>& contacts) {
        std::set<std::array<EdgeKey, 2>> known;
        std::vector<std::int32_t> result;
        for (const TrianglePair& pair : contacts) {
            progress_.check();
            const Triangle one = surface_.triangle(pair[0]);
            const Triangle two = surface_.triangle(pair[1]);
            for (std::size_t k = 0; k < 9; ++k) {
                const EdgeKey e = edge_key(one[k / 3], one[(k / 3 + 1) % 3]);
                const EdgeKey f = edge_key(two[k % 3], two[(k % 3 + 1) % 3]);
                const auto middle = between(e, f);
                if (middle.has_value() && known.insert({std::min(e, f), std::max(e, f)}).second) {
                    const Vec3 place = rounded_(*middle);
                    if (!near_vertex(place, result)) {
                        result.push_back(surface_.add_vertex(place));
                        ++events_;
                    }
                }
            }
        }
        return result;
    }

    /// Whether a vertex of the surface, or one of some more, is so near to a place that they would be merged.
    bool near_vertex(const Vec3& place, const std::vector<std::int32_t>& more) const {
        const auto near = [&](std::int32_t v) { return (surface_.at(v) - place).norm() <= kMerge * reach_; };
        bool found = std::any_of(more.begin(), more.end(), near);
        surface_.for_each_near(place, kMerge * reach_, [&](std::int32_t t) {
            found = found || std::any_of(surface_.triangle(t).begin(), surface_.triangle(t).end(), near);
        });
        return found;
    }

    /// The point halfway between two edges that pass by each other within reach, where no end of the one is within
    /// reach of the other.
    std::optional<Vec3> between(const EdgeKey& e, const EdgeKey& f) const {
        for (const std::int32_t v : e) {
            for (const std::int32_t w : f) {
                if (root(v) == root(w)) {
                    return std::nullopt;
                }
            }
        }
        const Vec3& p = surface_.at(e[0]);
        const Vec3& q = surface_.at(f[0]);
        const Vec3 along = surface_.at(e[1]) - p;
        const Vec3 across = surface_.at(f[1]) - q;
        const double beside = along.dot(across);
        const double square = along.squaredNorm() * across.squaredNorm() - beside * beside;
        if (square <= 0.0) {
            return std::nullopt;
        }
        const Vec3 gap = q - p;
        const double s = (gap.dot(along) * across.squaredNorm() - gap.dot(across) * beside) / square;
        const double t = (gap.dot(along) * beside - gap.dot(across) * along.squaredNorm()) / square;
        if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) {
            return std::nullopt;
        }
        const Vec3 here = p + s * along;
        const Vec3 there = q + t * across;
        const auto end_near = [&](const EdgeKey& ends, const EdgeKey& other) {
            return std::any_of(ends.begin(), ends.end(), [&](std::int32_t v) {
                return distance_to_segment(surface_.at(v), surface_.at(other[0]), surface_.at(other[1])) <= reach_;
            });
        };
        if ((there - here).norm() > reach_ || end_near(e, f) || end_near(f, e)) {
            return std::nullopt;
        }
        return 0.5 * (here + there);
    }

    /// Leads the edges and faces that pass near a centre through it.
    void lead_through(std::int32_t centre) {
        surface_.for_each_near(surface_.at(centre), reach_, [&](std::int32_t t) {
            const Triangle& c = surface_.triangle(t);
            bool own = false;
            bool beside = false;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t a = c[k];
                const std::int32_t b = c[(k + 1) % 3];
                own = own || root(a) == centre;
                if (root(a) != centre && root(b) != centre && near_edge(centre, a, b)) {
                    snapped_[t].on_edge[k].push_back(centre);
                    ++events_;
                    beside = true;
                }
            }
            if (!own && !beside && over_face(centre, c)) {
                snapped_[t].inside.push_back(centre);
                ++events_;
            }
        });
    }

    /// The place of the foot of a vertex on an edge, as a fraction of it.
    double along(std::int32_t v, std::int32_t from, std::int32_t to) const {
        const Vec3 way = surface_.at(to) - surface_.at(from);
        return (surface_.at(v) - surface_.at(from)).dot(way) / way.squaredNorm();
    }

    bool near_edge(std::int32_t v, std::int32_t from, std::int32_t to) const {
        if (from > to) {
            std::swap(from, to);
        }
        const double s = along(v, from, to);
        const Vec3& a = surface_.at(from);
        return s > 0.0 && s < 1.0 && (a + s * (surface_.at(to) - a) - surface_.at(v)).norm() <= reach_;
    }

    bool over_face(std::int32_t v, const Triangle& c) const {
        const Vec3& a = surface_.at(c[0]);
        const Vec3& p = surface_.at(v);
        const Vec3 n = (surface_.at(c[1]) - a).cross(surface_.at(c[2]) - a);
        if (n.isZero() || std::abs(n.dot(p - a)) > reach_ * n.norm()) {
            return false;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& from = surface_.at(c[k]);
            if (n.dot((surface_.at(c[(k + 1) % 3]) - from).cross(p - from)) <= 0.0) {
                return false;
            }
        }
        return true;
    }

    /// Replaces all triangles to which something was snapped.
    void apply() {
        for (const auto& [t, snapped] : snapped_) {
            progress_.check();
            const Triangle c = surface_.triangle(t);
            PlanarPieces division(surface_.vertices(), c);
            for (std::size_t k = 0; k < 3; ++k) {
                add_on_edge(division, k, c[k], c[(k + 1) % 3], snapped.on_edge[k]);
            }
            for (const std::int32_t v : snapped.inside) {
                division.add_inside(v);
            }
            std::vector<Triangle> pieces = division.run();
            for (Triangle& piece : pieces) {
                for (std::int32_t& v : piece) {
                    v = root(v);
                }
            }
            surface_.replace(t, pieces, kMerge * reach_);
        }
        surface_.index_added();
    }

    /// Adds vertices in their order along an edge. The order is found from the lower end on, so that it is the same for
    /// both triangles of the edge.
    void add_on_edge(PlanarPieces& division, std::size_t k, std::int32_t from, std::int32_t to,
                     const std::vector<std::int32_t>& vertices) const {
        std::vector<std::pair<double, std::int32_t>> order;
        for (const std::int32_t v : vertices) {
            order.emplace_back(along(v, std::min(from, to), std::max(from, to)), v);
        }
        std::sort(order.begin(), order.end());
        if (from > to) {
            std::reverse(order.begin(), order.end());
        }
        for (const auto& [s, v] : order) {
            division.add_on_edge(k, from < to ? s : 1.0 - s, v);
        }
    }

    RoundedSurface& surface_;
    double reach_;
    const std::function<Vec3(const Vec3&)>& rounded_;
    const Progress& progress_;
    std::unordered_map<std::int32_t, std::int32_t> merged_;
    std::map<std::int32_t, Snapped> snapped_;  ///< by triangle
    std::size_t events_ = 0;
};

}  // namespace

std::vector<TrianglePair> contacts_of(const RoundedSurface& surface, const std::vector<std::int32_t>& triangles,
                                      const Progress& progress) {
    std::vector<TrianglePair> result;
    CancelPace pace(progress);
    for (const std::int32_t t : triangles) {
        pace.step();
        const Triangle& own = surface.triangle(t);
        surface.for_each_beside(t, [&](std::int32_t other) {
            const Triangle& c = surface.triangle(other);
            if (other == t || (has(c, own[0]) && has(c, own[1]) && has(c, own[2]))) {
                return;
            }
            if (mesh::contact(surface.vertices(), own, c) != mesh::Contact::None) {
                result.push_back({std::min(t, other), std::max(t, other)});
            }
        });
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::size_t snap_vertices(RoundedSurface& surface, const std::vector<TrianglePair>& contacts, double reach,
                          const std::function<Vec3(const Vec3&)>& rounded, const Progress& progress) {
    return SnapPass(surface, reach, rounded, progress).run(contacts);
}

}  // namespace mq::boolean

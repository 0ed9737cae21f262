// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/triangle_intersection.h"

#include <algorithm>
#include <array>

#include "base/predicates.h"

namespace mq::boolean {

namespace {

using Signs = std::array<int, 3>;

bool all(const Signs& signs, int value) {
    return signs[0] == value && signs[1] == value && signs[2] == value;
}

int count(const Signs& signs, int value) {
    return static_cast<int>(std::count(signs.begin(), signs.end(), value));
}

/// Where a point of the triangle's plane lies, from its side of each edge.
struct Place {
    enum Kind { Outside, Inside, OnEdge, AtVertex } kind = Outside;
    int index = -1;  ///< index of the vertex, or of the edge, which starts at vertex `index`
};

Place place_of(const Signs& sides) {
    if (count(sides, 1) > 0 && count(sides, -1) > 0) {
        return {};
    }
    const int zeros = count(sides, 0);
    if (zeros == 0) {
        return {Place::Inside, -1};
    }
    const auto first = static_cast<int>(std::find(sides.begin(), sides.end(), 0) - sides.begin());
    if (zeros == 1) {
        return {Place::OnEdge, first};
    }
    // On two edges the point is the vertex between them: edge i runs from vertex i.
    return {Place::AtVertex, sides[0] != 0 ? 2 : (sides[1] != 0 ? 0 : 1)};
}

/// One run of the intersection of two triangles.
class PairIntersection {
  public:
    PairIntersection(const Soup& soup, std::int32_t s, std::int32_t t, PointTable& points, Incidences& found)
        : soup_(soup), triangle_{s, t}, points_(points), found_(found) {}

    void run() {
        for (int own = 0; own < 2; ++own) {
            side_[own] = sides(own);
            if (all(side_[own], 1) || all(side_[own], -1)) {
                return;
            }
        }
        if (all(side_[0], 0)) {
            coplanar();
            return;
        }
        for (int own = 0; own < 2; ++own) {
            for (int k = 0; k < 3; ++k) {
                if (side_[own][k] == 0) {
                    vertex_in_plane(own, k);
                }
                if (side_[own][k] * side_[own][(k + 1) % 3] < 0) {
                    edge_through_plane(own, k);
                }
            }
        }
        add_segment();
    }

  private:
    const Triangle& corners(int own) const { return soup_.triangles[static_cast<std::size_t>(triangle_[own])]; }
    std::int32_t corner(int own, int k) const { return corners(own)[static_cast<std::size_t>(k % 3)]; }
    const Vec3& at(int own, int k) const { return soup_.vertices[static_cast<std::size_t>(corner(own, k))]; }
    EdgeKey edge(int own, int k) const { return edge_key(corner(own, k), corner(own, k + 1)); }
    bool is_corner(int own, std::int32_t v) const {
        return std::find(corners(own).begin(), corners(own).end(), v) != corners(own).end();
    }

    /// The signs of the vertices of triangle `own` against the other triangle's plane.
    Signs sides(int own) const {
        const int other = 1 - own;
        Signs result{};
        for (int k = 0; k < 3; ++k) {
            result[static_cast<std::size_t>(k)] =
                is_corner(other, corner(own, k)) ? 0
                                                 : mq::orient3d(at(other, 0), at(other, 1), at(other, 2), at(own, k));
        }
        return result;
    }

    int axis_of(int own) const { return projection_axis(at(own, 0), at(own, 1), at(own, 2)); }

    /// Records a point on an edge or in the inside of triangle `own`.
    void put(int own, const Place& place, std::int32_t point) {
        if (place.kind == Place::OnEdge) {
            found_.on_edge[edge(own, place.index)].push_back(point);
        } else if (place.kind == Place::Inside) {
            found_.in_face[triangle_[own]].push_back(point);
        }
    }

    /// A vertex of `own` in the plane of the other triangle.
    void vertex_in_plane(int own, int k) {
        const int other = 1 - own;
        const std::int32_t v = corner(own, k);
        if (is_corner(other, v)) {
            common_.push_back(v);
            return;
        }
        const int axis = axis_of(other);
        Signs around{};
        for (int i = 0; i < 3; ++i) {
            around[static_cast<std::size_t>(i)] = mq::orient2d(at(other, i), at(other, (i + 1) % 3), at(own, k), axis);
        }
        const Place place = place_of(around);
        if (place.kind != Place::Outside) {
            put(other, place, v);
            common_.push_back(v);
        }
    }

    /// Edge k of `own` has its ends on both sides of the other triangle's plane.
    void edge_through_plane(int own, int k) {
        const int other = 1 - own;
        Signs around{};
        for (int i = 0; i < 3; ++i) {
            around[static_cast<std::size_t>(i)] =
                mq::orient3d(at(own, k), at(own, (k + 1) % 3), at(other, i), at(other, (i + 1) % 3));
        }
        const Place place = place_of(around);
        const Place here{Place::OnEdge, k};
        if (place.kind == Place::Inside) {
            const std::int32_t p = points_.on_face(edge(own, k), triangle_[other]);
            put(own, here, p);
            put(other, place, p);
            common_.push_back(p);
        } else if (place.kind == Place::OnEdge) {
            const std::int32_t p =
                points_.on_edges(edge(own, k), edge(other, place.index), points_.plane(triangle_[other]));
            put(own, here, p);
            put(other, place, p);
            common_.push_back(p);
        } else if (place.kind == Place::AtVertex) {
            const std::int32_t v = corner(other, place.index);
            put(own, here, v);
            common_.push_back(v);
        }
    }

    /// All common points lie on one line: the segment joins its ends.
    void add_segment() {
        std::sort(common_.begin(), common_.end());
        common_.erase(std::unique(common_.begin(), common_.end()), common_.end());
        if (common_.size() < 2) {
            return;
        }
        int axis = 0;
        const Vec3 spread = points_.approx(common_[0]) - points_.approx(common_[1]);
        spread.cwiseAbs().maxCoeff(&axis);
        const auto before = [&](std::int32_t a, std::int32_t b) {
            return compare(points_.at(a), points_.at(b), axis) < 0;
        };
        const auto [low, high] = std::minmax_element(common_.begin(), common_.end(), before);
        for (int own = 0; own < 2; ++own) {
            found_.segments[triangle_[own]].push_back({*low, *high, triangle_[1 - own]});
        }
    }

    /// Both lie in one plane: vertices on the other triangle, and edges that cross.
    void coplanar() {
        const int axis = axis_of(0);
        std::array<std::array<Signs, 3>, 2> around;  // [own][vertex][edge of the other]
        for (int own = 0; own < 2; ++own) {
            for (int k = 0; k < 3; ++k) {
                for (int i = 0; i < 3; ++i) {
                    around[own][k][static_cast<std::size_t>(i)] =
                        mq::orient2d(at(1 - own, i), at(1 - own, (i + 1) % 3), at(own, k), axis);
                }
                if (!is_corner(1 - own, corner(own, k))) {
                    put(1 - own, place_of(around[own][k]), corner(own, k));
                }
            }
        }
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 3; ++i) {
                const bool parted =
                    around[0][k][i] * around[0][(k + 1) % 3][i] < 0 && around[1][i][k] * around[1][(i + 1) % 3][k] < 0;
                if (parted) {
                    edges_in_plane(axis, k, i);
                }
            }
        }
        if (insides_meet(axis, around)) {
            found_.overlapping.emplace_back(triangle_[0], triangle_[1]);
        }
    }

    /// Edge k of the first and edge i of the second cross in their common plane.
    void edges_in_plane(int axis, int k, int i) {
        const PlanePoints standing = standing_plane(at(1, i), at(1, (i + 1) % 3), axis);
        const std::int32_t p = points_.on_edges(edge(0, k), edge(1, i), standing);
        put(0, {Place::OnEdge, k}, p);
        put(1, {Place::OnEdge, i}, p);
    }

    /// No edge of either has the whole other triangle on its outer side.
    bool insides_meet(int axis, const std::array<std::array<Signs, 3>, 2>& around) const {
        for (int own = 0; own < 2; ++own) {
            const int turn = mq::orient2d(at(1 - own, 0), at(1 - own, 1), at(1 - own, 2), axis);
            for (std::size_t i = 0; i < 3; ++i) {
                if (turn * around[own][0][i] <= 0 && turn * around[own][1][i] <= 0 && turn * around[own][2][i] <= 0) {
                    return false;
                }
            }
        }
        return true;
    }

    const Soup& soup_;
    std::int32_t triangle_[2];
    PointTable& points_;
    Incidences& found_;
    std::array<Signs, 2> side_{};
    std::vector<std::int32_t> common_;
};

}  // namespace

int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 size = (b - a).cross(c - a).cwiseAbs();
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) { return size[i] > size[j]; });
    // The normal of a needle may be rounding error only: the exact test decides whether the projection has an area.
    for (const int axis : axes) {
        if (mq::orient2d(a, b, c, axis) != 0) {
            return axis;
        }
    }
    return axes[0];
}

void intersect(const Soup& soup, std::int32_t s, std::int32_t t, PointTable& points, Incidences& found) {
    PairIntersection(soup, s, t, points, found).run();
}

}  // namespace mq::boolean

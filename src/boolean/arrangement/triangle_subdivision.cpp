// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/triangle_subdivision.h"

#include <algorithm>
#include <unordered_map>

#include "base/error.h"
#include "base/predicates.h"
#include "boolean/exact/exact_constrained_triangulation.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::boolean {

namespace {

/// The state of one division: the plane's triangulation, and which point of the table each of its points is.
class Division {
  public:
    Division(const Soup& soup, std::int32_t first, const Incidences& found, const PointTable& points,
             const Progress* progress)
        : soup_(soup), found_(found), table_(points), progress_(progress), plane_(make_plane(first)) {}

    FaceDivision triangle(std::int32_t t) {
        const Triangle& c = corners(t);
        const int a = local(c[0]);
        const int b = local(c[1]);
        const int d = local(c[2]);
        plane_.start(a, b, d);
        for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t first = c[static_cast<std::size_t>(k)];
            const std::int32_t last = c[static_cast<std::size_t>((k + 1) % 3)];
            int from = local(first);
            const int to = local(last);
            put_on_edge(first, k);
            put_on_edge(last, k);
            for (const std::int32_t p : points_on(first, last)) {
                const int added = local(p);
                plane_.split_edge(from, to, added);
                put_on_edge(p, k);
                from = added;
            }
        }
        insert_inner(t);
        constrain_segments(t);
        plane_.improve();
        FaceDivision result;
        name_crossings(result);
        for (const std::array<int, 3>& piece : plane_.triangles()) {
            result.faces.push_back({{global(piece[0]), global(piece[1]), global(piece[2])}, {{t, 1}}});
        }
        return result;
    }

    FaceDivision cluster(const std::vector<std::int32_t>& triangles) {
        start_around(triangles);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const std::int32_t t = triangles[i];
            const Triangle& c = corners(t);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto edge = static_cast<std::int32_t>(3 * i + k);
                insert(c[k]);
                put_on_edge(c[k], edge);
                put_on_edge(c[(k + 1) % 3], edge);
                for (const std::int32_t p : points_on(c[k], c[(k + 1) % 3])) {
                    insert(p);
                    put_on_edge(p, edge);
                }
            }
            insert_inner(t);
        }
        for (const std::int32_t t : triangles) {
            constrain_edges(t);
        }
        for (const std::int32_t t : triangles) {
            constrain_segments(t);
        }
        plane_.improve();
        FaceDivision result;
        name_crossings(result);
        add_covered(triangles, result);
        return result;
    }

  private:
    const Triangle& corners(std::int32_t t) const { return soup_.triangles[static_cast<std::size_t>(t)]; }
    const Vec3& vertex(std::int32_t v) const { return soup_.vertices[static_cast<std::size_t>(v)]; }

    ExactConstrainedTriangulation make_plane(std::int32_t t) {
        const PlanePoints plane = table_.plane(t);
        axis_ = projection_axis(plane[0], plane[1], plane[2]);
        return ExactConstrainedTriangulation(plane, axis_, turn(t), progress_);
    }

    /// The plane's index of a point of the table.
    int local(std::int32_t point) {
        const auto [found, fresh] = local_.emplace(point, static_cast<int>(global_.size()));
        if (fresh) {
            plane_.add_point(table_.at(point));
            global_.push_back(point);
        }
        return found->second;
    }
    std::int32_t global(int point) const { return global_[static_cast<std::size_t>(point)]; }

    void insert(std::int32_t point) {
        if (local_.count(point) == 0) {
            const int added = local(point);
            const int at = plane_.insert(added);
            local_[point] = at;  // the point in this place: an earlier one, if there is one
        }
    }

    void insert_inner(std::int32_t t) {
        const auto inner = found_.in_face.find(t);
        if (inner != found_.in_face.end()) {
            for (const std::int32_t p : inner->second) {
                insert(p);
            }
        }
    }

    /// The points inside an edge, in order from a to b.
    std::vector<std::int32_t> points_on(std::int32_t a, std::int32_t b) const {
        const auto on = found_.on_edge.find(edge_key(a, b));
        if (on == found_.on_edge.end()) {
            return {};
        }
        std::vector<std::int32_t> list = on->second;
        int axis = 0;
        (vertex(b) - vertex(a)).cwiseAbs().maxCoeff(&axis);
        const int way = vertex(b)[axis] > vertex(a)[axis] ? 1 : -1;
        std::sort(list.begin(), list.end(), [&](std::int32_t p, std::int32_t q) {
            return p != q && way * compare(table_.at(p), table_.at(q), axis) < 0;
        });
        return list;
    }

    void constrain_segments(std::int32_t t) {
        const auto segments = found_.segments.find(t);
        if (segments == found_.segments.end()) {
            return;
        }
        for (const Segment& s : segments->second) {
            if (local_.count(s.from) == 0 || local_.count(s.to) == 0) {
                throw TopologyError(phrases::kInconsistentDivision);
            }
            if (on_common_edge(s.from, s.to)) {
                continue;
            }
            Line line;
            line.plane = table_.plane(s.other);
            plane_.constrain(local(s.from), local(s.to), plane_.add_line(line));
        }
    }

    void put_on_edge(std::int32_t point, std::int32_t edge) { edges_at_[point].push_back(edge); }

    /// Whether both points lie on one edge of the triangle or of the cluster: the segment between them is a piece of it
    /// already.
    bool on_common_edge(std::int32_t a, std::int32_t b) const {
        const auto at_a = edges_at_.find(a);
        const auto at_b = edges_at_.find(b);
        return at_a != edges_at_.end() && at_b != edges_at_.end() &&
               std::find_first_of(at_a->second.begin(), at_a->second.end(), at_b->second.begin(), at_b->second.end()) !=
                   at_a->second.end();
    }

    void constrain_edges(std::int32_t t) {
        const Triangle& c = corners(t);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = c[k];
            const std::int32_t b = c[(k + 1) % 3];
            Line line;
            line.edge = true;
            line.from = vertex(std::min(a, b));
            line.to = vertex(std::max(a, b));
            plane_.constrain(local(a), local(b), plane_.add_line(line));
        }
    }

    /// Begins with a triangle around all; its corners need not lie in the plane, which is only seen along the axis.
    void start_around(const std::vector<std::int32_t>& triangles) {
        Box box;
        for (const std::int32_t t : triangles) {
            for (const std::int32_t v : corners(t)) {
                box.add(vertex(v));
            }
        }
        const double size = box.largest_side();
        const Vec3 center = box.center();
        // Half the size of the enclosing triangle, in units of the triangles' box: more than large enough to hold all
        // of them.
        constexpr double kFar = 8.0;
        const double place[3][2] = {{-kFar, -kFar}, {kFar, -kFar}, {0.0, kFar}};
        int around[3];
        for (int k = 0; k < 3; ++k) {
            Vec3 p = center;
            p[(axis_ + 1) % 3] += place[k][0] * size;
            p[(axis_ + 2) % 3] += place[k][1] * size;
            around[k] = plane_.add_point(ExactPoint(p));
            global_.push_back(-1);
        }
        if (turn(triangles[0]) < 0) {
            std::swap(around[1], around[2]);
        }
        plane_.start(around[0], around[1], around[2]);
    }

    void name_crossings(FaceDivision& result) {
        const std::vector<ExactPoint>& all = plane_.points();
        for (std::size_t i = global_.size(); i < all.size(); ++i) {
            global_.push_back(table_.size() + static_cast<std::int32_t>(result.crossings.size()));
            result.crossings.push_back(all[i]);
        }
    }

    /// The edges of the triangles are constraints, so that a piece lies in a triangle or outside: inside where its
    /// corners do. Each point is tested once, not with every piece around it.
    void add_covered(const std::vector<std::int32_t>& triangles, FaceDivision& result) {
        std::vector<DividedFace> pieces;
        for (const std::array<int, 3>& piece : plane_.triangles()) {
            if (global(piece[0]) >= 0 && global(piece[1]) >= 0 && global(piece[2]) >= 0) {
                pieces.push_back({{piece[0], piece[1], piece[2]}, {}});
            }
        }
        const int turn_of_plane = turn(triangles[0]);
        std::vector<char> in;
        for (const std::int32_t t : triangles) {
            check_cancelled(progress_);
            const int way = turn(t) * turn_of_plane;
            mark_inside(t, way, in);
            for (DividedFace& piece : pieces) {
                if (std::all_of(piece.points.begin(), piece.points.end(),
                                [&](std::int32_t p) { return in[static_cast<std::size_t>(p)] != 0; })) {
                    piece.covers.push_back({t, way});
                }
            }
        }
        for (DividedFace& piece : pieces) {
            if (!piece.covers.empty()) {
                for (std::int32_t& p : piece.points) {
                    p = global(p);
                }
                result.faces.push_back(std::move(piece));
            }
        }
    }

    /// Marks the plane's points that lie in a closed triangle.
    void mark_inside(std::int32_t t, int way, std::vector<char>& in) {
        const Triangle& c = corners(t);
        const int a = local(c[0]);
        const int b = local(way > 0 ? c[1] : c[2]);
        const int d = local(way > 0 ? c[2] : c[1]);
        Box box;
        for (const std::int32_t v : c) {
            box.add(vertex(v));
        }
        const std::vector<ExactPoint>& all = plane_.points();
        in.assign(all.size(), 0);
        for (std::size_t p = 0; p < all.size(); ++p) {
            const Vec3 slack = Vec3::Constant(all[p].error());
            const Box around{box.low - slack, box.high + slack};
            in[p] = around.contains(all[p].approx()) && plane_.in_triangle(static_cast<int>(p), a, b, d);
        }
    }

    int turn(std::int32_t t) const {
        const Triangle& c = corners(t);
        return mq::orient2d(vertex(c[0]), vertex(c[1]), vertex(c[2]), axis_);
    }

    const Soup& soup_;
    const Incidences& found_;
    const PointTable& table_;
    const Progress* progress_;
    int axis_ = 0;
    ExactConstrainedTriangulation plane_;
    std::unordered_map<std::int32_t, int> local_;
    std::vector<std::int32_t> global_;
    /// The edges, 3 * triangle + k, on which a point of the table is known to lie.
    std::unordered_map<std::int32_t, std::vector<std::int32_t>> edges_at_;
};

}  // namespace

FaceDivision divide_triangle(const Soup& soup, std::int32_t triangle, const Incidences& found, const PointTable& points,
                             const Progress* progress) {
    return Division(soup, triangle, found, points, progress).triangle(triangle);
}

FaceDivision divide_cluster(const Soup& soup, const std::vector<std::int32_t>& triangles, const Incidences& found,
                            const PointTable& points, const Progress* progress) {
    return Division(soup, triangles[0], found, points, progress).cluster(triangles);
}

}  // namespace mq::boolean

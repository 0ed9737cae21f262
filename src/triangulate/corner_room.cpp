// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/corner_room.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/distance.h"
#include "mesh/triangle_tree.h"
#include "triangulate/corner_angle.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// The innermost shell is as large as there is room, since edges that touch each other part with their distance from the
// node: the wider they are apart where the innermost piece ends, the longer may be the pieces beyond it, and the easier
// is the way from its length to theirs. In lengths of the first pieces of the edges; one that is a whole CAD edge has a
// corner at its other end, too.
constexpr double kOfPiece = 1.01;
constexpr double kOfWholeEdge = 0.6;
// In distances from the node to the nearest vertex that is not part of the corner, and to an edge that passes by, both
// on a face beside the node: what only lies there in space, as nodes of pieces that are not joined do, is not in the
// way.
constexpr double kRoom = 0.9;
constexpr double kBesideNode = 3.0;
// An edge this near to the middle of an innermost piece, in lengths of the piece, calls for a shorter piece.
constexpr double kBesideEdge = 0.3;
constexpr int kMaxHalvings = 20;

std::vector<Vec3> points_of(const SurfaceMesh& mesh) {
    std::vector<Vec3> points;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        points.push_back(mesh.vertex(v).point);
    }
    return points;
}

// As triangles without area: all segments in their order.
std::vector<mesh::Triangle> borders_of(const SurfaceMesh& mesh) {
    std::vector<mesh::Triangle> borders;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const auto& ends = mesh.segment(s).vertices;
        borders.push_back({ends[0], ends[1], ends[1]});
    }
    return borders;
}

class RoomSearch {
  public:
    explicit RoomSearch(const SurfaceMesh& mesh)
        : mesh_(mesh), points_(points_of(mesh)), borders_(borders_of(mesh)), tree_(points_, borders_) {}

    // @param pieces the segments that leave the node, ascending.
    double innermost(int node, const std::vector<int>& pieces) const {
        const Vec3& p = mesh_.vertex(node).point;
        double radius = 1e300;
        Around around;
        for (const int s : pieces) {
            const auto& ends = mesh_.segment(s).vertices;
            const bool whole = mesh_.vertex(ends[0]).entity[0] == 0 && mesh_.vertex(ends[1]).entity[0] == 0;
            radius = std::min(radius, (whole ? kOfWholeEdge : kOfPiece) * (end_of(s, 1) - end_of(s, 0)).norm());
            if (mesh_.segment(s).uses.empty()) {
                continue;
            }
            around.edges.insert(mesh_.segment(s).edge);
            around.directions.push_back((end_of(s, ends[0] == node ? 1 : 0) - p).normalized());
            for (const SurfaceMesh::SegmentUse& use : mesh_.segment(s).uses) {
                around.faces.insert(face_of(use));
            }
        }
        radius = std::min(radius, kRoom * clear_of_vertices(node, around, radius / kRoom));
        return clear_of_other_edges(p, around, radius);
    }

  private:
    // A node's.
    struct Around {
        std::set<int> edges;
        std::set<int> faces;
        std::vector<Vec3> directions;  // in which its pieces leave
    };

    const Vec3& end_of(int segment, int end) const { return mesh_.vertex(mesh_.segment(segment).vertices[end]).point; }

    // The distance to the nearest vertex that is not part of the edges meeting in the node, at most `radius`.
    double clear_of_vertices(int node, const Around& around, double radius) const {
        const Vec3& p = mesh_.vertex(node).point;
        double nearest = radius;
        for (const int s : segments_beside(p, around, radius)) {
            for (const int v : mesh_.segment(s).vertices) {
                if (v != node && (mesh_.vertex(v).entity[0] == 0 || around.edges.count(mesh_.segment(s).edge) == 0)) {
                    nearest = std::min(nearest, (mesh_.vertex(v).point - p).norm());
                }
            }
        }
        return nearest;
    }

    // Edges that pass by and would encroach on the innermost pieces make these shorter: no cascade comes of that.
    double clear_of_other_edges(const Vec3& p, const Around& around, double radius) const {
        for (const int s : segments_beside(p, around, radius)) {
            if (around.edges.count(mesh_.segment(s).edge) > 0) {
                continue;
            }
            const auto room_at = [&](const Vec3& q) { return distance_to_segment(q, end_of(s, 0), end_of(s, 1)); };
            radius = std::min(radius, kBesideNode * room_at(p));
            for (const Vec3& d : around.directions) {
                for (int n = 0; n < kMaxHalvings && room_at(p + 0.5 * radius * d) < kBesideEdge * radius; ++n) {
                    radius *= 0.5;
                }
            }
        }
        return radius;
    }

    // Near the node and on a face beside it, ascending.
    std::vector<int> segments_beside(const Vec3& p, const Around& around, double radius) const {
        std::vector<int> segments;
        const Box box{p - Vec3::Constant(radius), p + Vec3::Constant(radius)};
        tree_.for_each_in_box(box, [&](std::int32_t s) {
            const auto& uses = mesh_.segment(s).uses;
            if (std::any_of(uses.begin(), uses.end(),
                            [&](const SurfaceMesh::SegmentUse& use) { return around.faces.count(face_of(use)) > 0; })) {
                segments.push_back(s);
            }
        });
        std::sort(segments.begin(), segments.end());
        return segments;
    }

    int face_of(const SurfaceMesh::SegmentUse& use) const {
        return mesh_.face_of(SurfaceMesh::triangle_of(use.half_edge));
    }

    const SurfaceMesh& mesh_;
    std::vector<Vec3> points_;
    std::vector<mesh::Triangle> borders_;
    mesh::TriangleTree tree_;
};

}  // namespace

// Of every node: chords can turn out narrower than the first of them were.
CornerRoom measure_room(const SurfaceMesh& mesh) {
    std::map<int, std::vector<int>> pieces;
    std::set<int> narrow;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const SurfaceMesh::Segment& segment = mesh.segment(s);
        for (int end = 0; end < 2; ++end) {
            const int v = segment.vertices[end];
            if (narrowest_corner(mesh, s, end).angle < kNarrowCorner) {
                narrow.insert(v);
            }
            if (mesh.vertex(v).entity[0] == 0 && (end == 0 || v != segment.vertices[0])) {
                pieces[v].push_back(s);
            }
        }
    }
    CornerRoom room{std::vector<double>(static_cast<std::size_t>(mesh.vertex_count()), 0.0),
                    {narrow.begin(), narrow.end()}};
    if (!pieces.empty()) {
        const RoomSearch search(mesh);
        for (const auto& [node, segments] : pieces) {
            room.innermost[static_cast<std::size_t>(node)] = search.innermost(node, segments);
        }
    }
    return room;
}

}  // namespace mq::triangulate

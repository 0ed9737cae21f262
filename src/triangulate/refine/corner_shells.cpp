// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/corner_shells.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/segment_distance.h"
#include "mesh/intersection/aabb_tree.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Radius of the innermost shell, in lengths of the first pieces of the edges that enclose a small input angle, or of
// all edges where there is none; an edge that is a single piece has a corner at its other end, too. It is as large as
// possible: tangent edges separate with their distance from the node, and the larger their distance at the end of the
// innermost piece, the longer may be the pieces beyond it, and the smaller is the ratio of both lengths.
constexpr double kOfPiece = 1.01;
constexpr int kMaxHalvings = 20;  // Bounds the halvings where an edge touches the piece.

std::vector<Vec3> points_of(const ClassifiedMesh& mesh) {
    std::vector<Vec3> points;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        points.push_back(mesh.vertex(v).point);
    }
    return points;
}

// Returns all segments in order, as triangles without area.
std::vector<mesh::Triangle> borders_of(const ClassifiedMesh& mesh) {
    std::vector<mesh::Triangle> borders;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const auto& ends = mesh.segment(s).vertices;
        borders.push_back({ends[0], ends[1], ends[1]});
    }
    return borders;
}

class ShellSearch {
  public:
    // @param narrow  the vertices of nodes with a small input angle
    ShellSearch(const ClassifiedMesh& mesh, const std::set<int>& narrow)
        : mesh_(mesh),
          narrow_(narrow),
          points_(points_of(mesh)),
          borders_(borders_of(mesh)),
          tree_(points_, borders_) {}

    // Returns the radius of the innermost shell, mm. @param pieces  the segments that leave the node, ascending.
    double innermost(int node, const std::vector<int>& pieces) const {
        const Vec3& p = mesh_.vertex(node).point;
        double radius = 1e300;
        Around around;
        for (const int s : pieces) {
            const auto& ends = mesh_.segment(s).vertices;
            const bool narrow = narrow_.count(node) == 0 || is_narrow(node, s);
            radius = std::min(radius, share_of_piece(s, narrow) * (end_of(s, 1) - end_of(s, 0)).norm());
            if (mesh_.segment(s).uses.empty()) {
                continue;
            }
            around.edges.insert(mesh_.segment(s).edge);
            if (narrow) {
                around.directions.push_back((end_of(s, ends[0] == node ? 1 : 0) - p).normalized());
            }
            for (const ClassifiedMesh::SegmentUse& use : mesh_.segment(s).uses) {
                around.faces.insert(face_of(use));
            }
        }
        radius = std::min(radius, RefinementTuning::kShellRoom *
                                      clear_of_vertices(node, around, radius / RefinementTuning::kShellRoom));
        return clear_of_other_edges(p, around, radius);
    }

  private:
    // The surroundings of a node.
    struct Around {
        std::set<int> edges;
        std::set<int> faces;
        std::vector<Vec3> directions;  // unit vectors along its pieces
    };

    // Returns the largest radius in lengths of a first piece. Edges beside the small input angles limit it by their
    // far nodes alone (clear_of_vertices), unless those have shells, too.
    double share_of_piece(int segment, bool narrow) const {
        const auto& ends = mesh_.segment(segment).vertices;
        if (narrow) {
            const bool whole = mesh_.vertex(ends[0]).entity[0] == 0 && mesh_.vertex(ends[1]).entity[0] == 0;
            return whole ? RefinementTuning::kShellOfWholeEdge : kOfPiece;
        }
        return narrow_.count(ends[0]) > 0 && narrow_.count(ends[1]) > 0 ? RefinementTuning::kShellBetweenTwo : 1e300;
    }

    bool is_narrow(int node, int segment) const {
        const int end = mesh_.segment(segment).vertices[0] == node ? 0 : 1;
        return narrowest_corner(mesh_, segment, end).angle < kNarrowCorner;
    }

    Vec3 end_of(int segment, int end) const { return mesh_.vertex(mesh_.segment(segment).vertices[end]).point; }

    // Returns the distance to the nearest vertex outside the edges that meet in the node, at most `radius`, mm.
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

    // Reduces the radius where edges that pass by would encroach on the innermost pieces; this causes no cascade.
    double clear_of_other_edges(const Vec3& p, const Around& around, double radius) const {
        for (const int s : segments_beside(p, around, radius)) {
            if (around.edges.count(mesh_.segment(s).edge) > 0) {
                continue;
            }
            const auto room_at = [&](const Vec3& q) { return distance_to_segment(q, end_of(s, 0), end_of(s, 1)); };
            radius = std::min(radius, RefinementTuning::kShellPassing * room_at(p));
            for (const Vec3& d : around.directions) {
                for (int n = 0;
                     n < kMaxHalvings && room_at(p + 0.5 * radius * d) < RefinementTuning::kShellBesideEdge * radius;
                     ++n) {
                    radius *= 0.5;
                }
            }
        }
        return radius;
    }

    // Returns the segments near the node on a face beside it, ascending.
    std::vector<int> segments_beside(const Vec3& p, const Around& around, double radius) const {
        std::vector<int> segments;
        const Box box{p - Vec3::Constant(radius), p + Vec3::Constant(radius)};
        tree_.for_each_in_box(box, [&](std::int32_t s) {
            const auto& uses = mesh_.segment(s).uses;
            if (std::any_of(uses.begin(), uses.end(), [&](const ClassifiedMesh::SegmentUse& use) {
                    return around.faces.count(face_of(use)) > 0;
                })) {
                segments.push_back(s);
            }
        });
        std::sort(segments.begin(), segments.end());
        return segments;
    }

    int face_of(const ClassifiedMesh::SegmentUse& use) const {
        return mesh_.face_of(ClassifiedMesh::triangle_of(use.half_edge));
    }

    const ClassifiedMesh& mesh_;
    const std::set<int>& narrow_;
    std::vector<Vec3> points_;
    std::vector<mesh::Triangle> borders_;
    mesh::AabbTree tree_;
};

}  // namespace

// Measures every node, since chords can enclose smaller angles later than the first ones do.
CornerShells corner_shells(const ClassifiedMesh& mesh) {
    std::map<int, std::vector<int>> pieces;
    std::set<int> narrow;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = mesh.segment(s);
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
    CornerShells shells{std::vector<double>(static_cast<std::size_t>(mesh.vertex_count()), 0.0),
                        {narrow.begin(), narrow.end()}};
    if (!pieces.empty()) {
        const ShellSearch search(mesh, narrow);
        for (const auto& [node, segments] : pieces) {
            shells.innermost[static_cast<std::size_t>(node)] = search.innermost(node, segments);
        }
    }
    return shells;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/cad_distance.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

#include "geometry/elementary/surface.h"

namespace mq::inspection {

using geometry::Answer;
using geometry::Answerer;
using geometry::Query;
using mesh::ClosestPoint;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// mm: points of a surface this near to the border of a face are on it.
constexpr double kBorder = 1e-9;
/// Vertices of the mesh lie on the faces; a projection farther off than this fraction of the deviation is not the
/// nearest.
constexpr double kNearEnough = 0.1;
/// Projections from different triangles of one face at most.
constexpr std::size_t kMostStarts = 24;

Vec3 weights_of(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const double square = normal.squaredNorm();
    if (!(square > 0.0)) {
        return {1.0, 0.0, 0.0};
    }
    const double at_b = (p - a).cross(c - a).dot(normal) / square, at_c = (b - a).cross(p - a).dot(normal) / square;
    return {1.0 - at_b - at_c, at_b, at_c};
}

/// The projections of the vertices of a face onto it: a walk from each vertex to its neighbours, for which its
/// parameters are a good guess.
/// @param enough  mm: what is farther off than this is sought on the whole face
std::vector<Answer> projections_of_neighbours(Answerer& answerer, int face, const std::vector<Vec3>& points,
                                              const std::vector<mesh::Triangle>& triangles, double enough) {
    const mesh::VertexStars stars(triangles, points.size());
    std::vector<Answer> answers(points.size());
    std::vector<char> known(points.size(), 0);
    const auto project = [&](std::size_t v, const Answer& beside) {
        Answer found;
        if (beside.found()) {
            found = answerer.answer(Query::face_nearest(face, points[v], beside.u, beside.v));
        }
        if (!found.found() || found.distance > enough) {
            const Answer global = answerer.answer(Query::face_nearest_global(face, points[v]));
            found = global.found() && (!found.found() || global.distance < found.distance) ? global : found;
        }
        answers[v] = found;
        known[v] = 1;
    };
    for (std::size_t first = 0; first < points.size(); ++first) {
        if (known[first] != 0) {
            continue;
        }
        project(first, Answer());
        std::vector<std::size_t> walk{first};
        for (std::size_t k = 0; k < walk.size(); ++k) {
            for (const std::uint32_t corner : stars[walk[k]]) {
                for (const std::int32_t v : triangles[corner / 3]) {
                    const auto next = static_cast<std::size_t>(v);
                    if (known[next] == 0) {
                        project(next, answers[walk[k]]);
                        walk.push_back(next);
                    }
                }
            }
        }
    }
    return answers;
}

double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

}  // namespace

CadDistance::CadDistance(geometry::Session& session, const MeshDistance& mesh, double deviation)
    : mesh_(mesh), topology_(session.topology()), deviation_(deviation), narrow_(deviation) {
    for (const geometry::Face& face : topology_.faces) {
        const char* const elementary[] = {"plane", "cylinder", "cone", "sphere", "torus"};
        is_elementary_.push_back(std::any_of(std::begin(elementary), std::end(elementary),
                                             [&](const char* kind) { return std::strcmp(kind, face.surface) == 0; }));
    }
    find_parameters(session);
    find_interior();
    divide_edges(session);
    sum_normals_at_nodes(session);
}

void CadDistance::find_parameters(geometry::Session& session) {
    const mesh::TriangleMesh& mesh = mesh_.mesh();
    uv_.resize(mesh.triangles.size(), {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()});
    normal_.resize(mesh.triangles.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
    std::vector<std::vector<std::int32_t>> of_face(topology_.faces.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        of_face[static_cast<std::size_t>(mesh.triangle_face[t])].push_back(static_cast<std::int32_t>(t));
    }
    for (std::size_t f = 0; f < of_face.size(); ++f) {
        for (const int edge : of_face[f].empty() ? topology_.edges_of(static_cast<int>(f)) : std::set<int>()) {
            narrow_ = std::max(narrow_, 4.0 * topology_.edges[static_cast<std::size_t>(edge)].tolerance);
        }
    }
    session.run_parallel(static_cast<int>(of_face.size()), [&](Answerer& answerer, int face) {
        session.check();
        find_parameters_of(answerer, face, of_face[static_cast<std::size_t>(face)]);
    });
}

void CadDistance::find_parameters_of(Answerer& answerer, int face, const std::vector<std::int32_t>& triangles) {
    const mesh::TriangleMesh& mesh = mesh_.mesh();
    std::vector<std::int32_t> vertices;
    for (const std::int32_t t : triangles) {
        vertices.insert(vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto place_of = [&](std::int32_t v) {
        return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    std::vector<mesh::Triangle> local;
    for (const std::int32_t t : triangles) {
        mesh::Triangle& corners = local.emplace_back();
        for (int i = 0; i < 3; ++i) {
            corners[i] = static_cast<std::int32_t>(place_of(mesh.triangles[t][i]));
        }
    }
    std::vector<Vec3> points;
    for (const std::int32_t v : vertices) {
        points.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
    }
    const std::vector<Answer> answers =
        projections_of_neighbours(answerer, face, points, local, kNearEnough * deviation_);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const auto t = static_cast<std::size_t>(triangles[k]);
        for (int i = 0; i < 3; ++i) {
            const Answer& at = answers[static_cast<std::size_t>(local[k][i])];
            uv_[t][i] = Vec2(at.u, at.v);
            normal_[t][i] = at.normal;
        }
        unwrap(face, uv_[t]);
    }
}

/// Puts the parameters of a triangle's corners on one turn of a periodic surface.
void CadDistance::unwrap(int face, std::array<Vec2, 3>& corners) const {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double period = topology_.faces[static_cast<std::size_t>(face)].period[static_cast<std::size_t>(axis)];
        for (std::size_t i = 1; i < 3 && period > 0.0; ++i) {
            corners[i][axis] = geometry::branch_nearest(corners[i][axis], corners[0][axis], period);
        }
    }
}

/// A triangle with all corners inside of its face has others of that face around it. As angles are bounded, those are
/// about as large, so that a fraction of its shortest edge is within the face.
void CadDistance::find_interior() {
    constexpr double kFraction = 0.2;
    const mesh::TriangleMesh& mesh = mesh_.mesh();
    interior_.resize(mesh.triangles.size(), 0.0F);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const mesh::Triangle& v = mesh.triangles[t];
        const bool inside =
            std::all_of(v.begin(), v.end(), [&](std::int32_t i) { return mesh.vertex_entity[i][0] == 2; });
        if (inside) {
            const Vec3 &a = mesh.vertices[v[0]], &b = mesh.vertices[v[1]], &c = mesh.vertices[v[2]];
            const double height = (b - a).cross(c - a).norm() / longest_edge(a, b, c);
            interior_[t] = static_cast<float>(kFraction * height);
        }
    }
}

void CadDistance::divide_edges(geometry::Session& session) {
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
        if (!topology_.edges[e].degenerate) {
            divide(session, static_cast<int>(e));
        }
    }
    if (!edge_segments_.empty()) {
        edge_tree_.emplace_back(edge_points_, edge_segments_);
    }
}

/// Divides an edge into pieces that deviate from it by no more than the mesh does.
void CadDistance::divide(geometry::Session& session, int edge) {
    constexpr int kPieces = 8;
    constexpr int kPiecesOfSpan = 2;
    constexpr int kMostPieces = 4096;
    const geometry::Edge& data = topology_.edges[static_cast<std::size_t>(edge)];
    int count = std::max(kPieces, kPiecesOfSpan * static_cast<int>(data.spans.bounds.size()));
    for (bool again = true; again;) {
        const auto at = [&](double i) { return data.t0 + (data.t1 - data.t0) * i / count; };
        geometry::Engine::Batch batch;
        for (int i = 0; i <= 2 * count; ++i) {
            batch.push_back(Query::edge_point(edge, at(0.5 * i)));
        }
        const geometry::Engine::Answers points = session.ask(std::move(batch));
        if (!std::all_of(points.begin(), points.end(), [](const Answer& a) { return a.found(); })) {
            return;
        }
        const auto point = [&](int i) -> const Vec3& { return points[static_cast<std::size_t>(i)].point; };
        double largest = 0.0;
        for (int i = 0; i < count; ++i) {
            largest = std::max(largest, (point(2 * i + 1) - 0.5 * (point(2 * i) + point(2 * i + 2))).norm());
        }
        again = largest > deviation_ && count < kMostPieces;
        if (again) {
            const double factor = std::clamp(1.1 * std::sqrt(largest / deviation_), 2.0, 64.0);
            count = std::min(kMostPieces, static_cast<int>(std::ceil(factor * count)));
            continue;
        }
        edge_deviation_ = std::max(edge_deviation_, 2.0 * largest);
        const auto first = static_cast<std::int32_t>(edge_points_.size());
        for (int i = 0; i <= count; ++i) {
            edge_points_.push_back(point(2 * i));
            if (i < count) {
                edge_segments_.push_back({first + i, first + i + 1, first + i + 1});
                pieces_.push_back({edge, at(i), at(i + 1)});
            }
        }
    }
}

/// The pseudonormals of nodes: the normals of their faces, weighted by the angles there. Those of triangles are right
/// at poles and cusps, too; but where narrow faces and short edges have none, a node has triangles of other faces than
/// its own.
void CadDistance::sum_normals_at_nodes(geometry::Session& session) {
    const mesh::TriangleMesh& mesh = mesh_.mesh();
    const std::size_t count = topology_.nodes.size();
    std::vector<std::set<int>> own(count), meshed(count);
    for (const geometry::EdgeUse& use : topology_.uses) {
        for (const int node : topology_.edges[static_cast<std::size_t>(use.edge)].nodes) {
            if (node >= 0) {
                own[static_cast<std::size_t>(node)].insert(use.face);
            }
        }
    }
    node_normal_.resize(count, Vec3::Zero());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const auto& [dimension, node] = mesh.vertex_entity[mesh.triangles[t][i]];
            if (dimension != 0) {
                continue;
            }
            const Vec3& apex = mesh.vertices[mesh.triangles[t][i]];
            const Vec3 a = mesh.vertices[mesh.triangles[t][(i + 1) % 3]] - apex;
            const Vec3 b = mesh.vertices[mesh.triangles[t][(i + 2) % 3]] - apex;
            const Vec3 plane = a.cross(b);
            // Where the surface has no normal, as at the apex of a cone, that of the triangle stands for it.
            const Vec3 normal = normal_[t][i].squaredNorm() > 0.5 ? normal_[t][i] : Vec3(plane.normalized());
            node_normal_[static_cast<std::size_t>(node)] += std::atan2(plane.norm(), a.dot(b)) * normal;
            meshed[static_cast<std::size_t>(node)].insert(mesh.triangle_face[t]);
        }
    }
    std::vector<Vec3> by_edges(count, Vec3::Zero());
    for (std::size_t f = 0; f < topology_.faces.size(); ++f) {
        for (const geometry::Loop& loop : topology_.faces[f].loops) {
            for (std::size_t k = 0; k < loop.uses.size(); ++k) {
                const Corner corner = corner_between(loop.uses[k], loop.uses[(k + 1) % loop.uses.size()]);
                if (corner.node >= 0 && own[corner.node] != meshed[corner.node]) {
                    by_edges[static_cast<std::size_t>(corner.node)] += weighted_normal(session, corner);
                }
            }
        }
    }
    for (std::size_t node = 0; node < count; ++node) {
        if (!by_edges[node].isZero(0.0)) {
            node_normal_[node] = by_edges[node];
        }
    }
}

/// The corner of a face where one use of its loop ends and the next one begins; node -1: there is none.
CadDistance::Corner CadDistance::corner_between(int before, int after) const {
    const auto end_of = [&](int use, bool last) {
        const geometry::EdgeUse& data = topology_.uses[static_cast<std::size_t>(use)];
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(data.edge)];
        const std::size_t end = data.forward == last ? 1 : 0;
        return std::pair(edge.degenerate ? -1 : edge.nodes[end], end == 1 ? edge.t1 : edge.t0);
    };
    const auto [last, end] = end_of(before, true);
    const auto [first, begin] = end_of(after, false);
    return {last == first ? first : -1, {before, after}, {end, begin}};
}

/// The normal of a face at a corner, as long as the angle between its edges.
Vec3 CadDistance::weighted_normal(geometry::Session& session, const Corner& corner) const {
    std::array<Vec3, 2> away;  // from the node, along the edges
    for (std::size_t i = 0; i < 2; ++i) {
        const geometry::EdgeUse& use = topology_.uses[static_cast<std::size_t>(corner.uses[i])];
        const bool ahead = use.forward == (i == 1);
        away[i] = (ahead ? 1.0 : -1.0) * session.ask(Query::edge_point(use.edge, corner.at[i])).normal;
    }
    const geometry::Face& face = topology_.faces[static_cast<std::size_t>(topology_.uses[corner.uses[1]].face)];
    const Vec3 normal = session.ask(Query::use_on_face(corner.uses[1], corner.at[1])).normal;
    // Uses have the face on their left in (u, v).
    const double side = (face.reversed ? -1.0 : 1.0) * normal.dot(away[1].cross(away[0]));
    const double angle = std::atan2(side, away[1].dot(away[0]));
    return (angle < 0.0 ? angle + 2.0 * M_PI : angle) * normal;
}

/// The search for the point of the model that is nearest to one point.
class CadDistance::Search {
  public:
    Search(const CadDistance& cad, Answerer& answerer, const Vec3& point)
        : cad_(cad), answerer_(answerer), point_(point) {}

    double least() const { return least_; }

    /// Projects the point onto the face of a triangle, from the triangle's point nearest to it.
    void project(const ClosestPoint& from) {
        const auto t = static_cast<std::size_t>(from.triangle);
        const mesh::TriangleMesh& mesh = cad_.mesh_.mesh();
        const mesh::Triangle& v = mesh.triangles[t];
        const Vec3 weights = weights_of(from.point, mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]);
        const Vec2 uv = weights[0] * cad_.uv_[t][0] + weights[1] * cad_.uv_[t][1] + weights[2] * cad_.uv_[t][2];
        const std::int32_t face = mesh.triangle_face[t];
        const Answer found = projected(face, uv, from.point);
        if (found.found() && found.distance < least_) {
            const double way = (found.point - from.point).norm();
            const int side = way < cad_.interior_[t] || !is_near_edge(found.point, way) ? 1 : side_of(face, found);
            const bool is_across = is_along_normal(found);
            // A search that ends at the bounds of a surface has found a point of an edge; at a crease inside of a face
            // the triangles say what is outside.
            if (side > 0 || (side == 0 && is_across)) {
                take(found, face, is_across ? found.normal : cad_.mesh_.pseudonormal(from.triangle, from.point));
            }
        }
    }

    /// Projects the point onto the faces of triangles, except from those near which a projection ended already.
    void project_all(const std::vector<ClosestPoint>& candidates) {
        for (const ClosestPoint& from : candidates) {
            if (from.distance <= least_ + cad_.deviation_ && !is_known(from)) {
                project(from);
            }
        }
    }

    /// Projects the point onto the pieces of edges that can be nearer than what is known.
    void project_on_edges(const std::vector<ClosestPoint>& candidates) {
        for (const ClosestPoint& from : candidates) {
            const double nearest = from.distance - cad_.edge_deviation_;
            if (nearest - cad_.narrow_ >= least_) {
                break;
            }
            const Piece& piece = cad_.pieces_[static_cast<std::size_t>(from.triangle)];
            const Answer found = nearest < least_
                                     ? answerer_.answer(Query::edge_nearest(
                                           piece.edge, point_, 0.5 * (piece.low + piece.high), piece.low, piece.high))
                                     : Answer();
            if (found.found() && found.distance < least_ * (1.0 - 1e-12)) {
                take(found, -1, Vec3::Zero());
                edge_ = piece.edge;
                parameter_ = found.t;
            }
            project_beside(piece, from.point);
        }
    }

    /// Projects the point onto the faces of a piece of an edge: where a face is narrower than the mesh tells apart, no
    /// triangle leads to it.
    void project_beside(const Piece& piece, const Vec3& from) {
        for (const int use : cad_.topology_.edges[static_cast<std::size_t>(piece.edge)].uses) {
            const std::int32_t face = cad_.topology_.uses[static_cast<std::size_t>(use)].face;
            if (is_known(face, from, cad_.narrow_)) {
                continue;
            }
            const Answer beside = answerer_.answer(Query::use_on_face(use, 0.5 * (piece.low + piece.high)));
            if (!beside.found()) {
                continue;
            }
            const Answer found = projected(face, Vec2(beside.u, beside.v), from);
            if (found.found() && found.distance < least_ && side_of(face, found) >= 0 && is_along_normal(found)) {
                take(found, face, found.normal);
            }
        }
    }

    SignedDistance result() {
        if (edge_ >= 0) {
            look_around_edge();
        }
        SignedDistance found = signed_distance(point_, nearest_, normal_);
        found.face = face_;
        return found;
    }

  private:
    struct Start {
        std::int32_t face;
        Vec3 begin;  ///< the triangle's point
        Vec3 end;    ///< its projection
    };

    void take(const Answer& found, std::int32_t face, const Vec3& normal) {
        least_ = found.distance;
        nearest_ = found.point;
        face_ = face;
        normal_ = normal;
        edge_ = -1;
    }

    /// The projection onto a face from parameters near a point.
    Answer projected(std::int32_t face, const Vec2& uv, const Vec3& from) {
        Answer found = answerer_.answer(Query::face_nearest(face, point_, uv.x(), uv.y()));
        starts_.push_back({face, from, found.found() ? found.point : from});
        return found;
    }

    /// Whether there may be an edge on the way from a point of a surface to a point of its face that is this far from
    /// it by the mesh. The modeler's own test takes longer than all else.
    bool is_near_edge(const Vec3& point, double way) const {
        const double reach = 2.0 * (way + cad_.deviation_) + cad_.edge_deviation_;
        return !cad_.edge_tree_.empty() && cad_.edge_tree_.front().any_within(point, reach, 0) >= 0;
    }

    /// 1 inside of a face, 0 on its border, -1 outside.
    int side_of(std::int32_t face, const Answer& found) const {
        const Answer side = answerer_.answer(Query::face_contains(face, found.u, found.v, kBorder));
        return side.found() ? side.side : -1;
    }

    /// Whether the way from the surface to the point is along its normal.
    bool is_along_normal(const Answer& found) const {
        constexpr double kAngle = 1e-6;
        const Vec3 way = point_ - found.point;
        const Vec3 aside = way - way.dot(found.normal) * found.normal;
        return found.normal.squaredNorm() > 0.5 && aside.norm() <= kAngle * (way.norm() + cad_.deviation_);
    }

    /// Whether a projection from a triangle would end where one did already.
    bool is_known(const ClosestPoint& from) const {
        const mesh::TriangleMesh& mesh = cad_.mesh_.mesh();
        const mesh::Triangle& v = mesh.triangles[static_cast<std::size_t>(from.triangle)];
        return is_known(mesh.triangle_face[static_cast<std::size_t>(from.triangle)], from.point,
                        longest_edge(mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]));
    }

    /// Whether a projection onto a face was begun, or ended, within a distance of a point.
    bool is_known(std::int32_t face, const Vec3& from, double within) const {
        std::size_t count = 0;
        for (const Start& start : starts_) {
            if (start.face == face) {
                const double apart = std::min((start.begin - from).norm(), (start.end - from).norm());
                if (cad_.is_elementary_[static_cast<std::size_t>(face)] != 0 || ++count == kMostStarts ||
                    apart <= within) {
                    return true;
                }
            }
        }
        return false;
    }

    /// The face and the normal at a point of an edge: the sum of the normals of its faces, or the node's at its ends.
    void look_around_edge() {
        constexpr double kEnd = 1e-9;
        const geometry::Edge& edge = cad_.topology_.edges[static_cast<std::size_t>(edge_)];
        const double end = kEnd * (edge.t1 - edge.t0);
        Vec3 sum = Vec3::Zero();
        for (const int use : edge.uses) {
            const Answer at = answerer_.answer(Query::use_on_face(use, parameter_));
            const std::int32_t face = cad_.topology_.uses[static_cast<std::size_t>(use)].face;
            sum += at.normal;
            face_ = face_ < 0 || face < face_ ? face : face_;
        }
        const int node = parameter_ <= edge.t0 + end ? edge.nodes[0] : parameter_ >= edge.t1 - end ? edge.nodes[1] : -1;
        const bool at_node = node >= 0 && !cad_.node_normal_[static_cast<std::size_t>(node)].isZero(0.0);
        normal_ = at_node ? cad_.node_normal_[static_cast<std::size_t>(node)] : sum;
    }

    const CadDistance& cad_;
    Answerer& answerer_;
    const Vec3 point_;
    std::vector<Start> starts_;
    double least_ = kInfinity;
    Vec3 nearest_ = Vec3::Zero();
    Vec3 normal_ = Vec3::Zero();
    std::int32_t face_ = -1;
    int edge_ = -1;  ///< the edge with the nearest point; -1: it is inside of a face
    double parameter_ = 0.0;
};

SignedDistance CadDistance::at(Answerer& answerer, const Vec3& point, std::int32_t guess, std::size_t& by_mesh) const {
    const ClosestPoint near = mesh_.nearest(point, guess);
    Search search(*this, answerer, point);
    search.project(near);
    const double reach = std::min(search.least(), near.distance + deviation_) + deviation_;
    thread_local std::vector<ClosestPoint> candidates;
    mesh_.tree().all_within(point, reach, candidates);
    search.project_all(candidates);
    if (!edge_tree_.empty()) {
        const double bound = std::min(search.least(), near.distance + deviation_) + edge_deviation_ + narrow_;
        edge_tree_.front().all_within(point, bound, candidates);
        search.project_on_edges(candidates);
    }
    if (!(search.least() <= near.distance + 2.0 * deviation_)) {
        ++by_mesh;
        return mesh_.at(point, near.triangle);
    }
    SignedDistance found = search.result();
    found.triangle = near.triangle;
    return found;
}

}  // namespace mq::inspection

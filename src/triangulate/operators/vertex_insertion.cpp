// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/vertex_insertion.h"

#include <algorithm>
#include <cmath>

#include "base/predicates.h"
#include "triangulate/operators/insertion_cavity.h"
#include "triangulate/operators/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;

constexpr int kMaxWalk = 100;  // Steps of a walk, which could cycle on a curved mesh.

struct Weights {
    double w[3];
};

Candidate weighted_site(const ClassifiedMesh& mesh, int triangle, const Weights& weights) {
    Candidate c;
    c.triangle = triangle;
    for (int i = 0; i < 3; ++i) {
        const int h = 3 * triangle + i;
        c.point += weights.w[i] * mesh.point_of(h);
        c.uv += weights.w[i] * mesh.site(mesh.site_of(h)).uv;
        c.reach = std::max(c.reach, side_length(mesh, h));
    }
    return c;
}

// Returns barycentric weights of the circumcentre, not yet divided by their sum, which is not above 0 for degenerate
// triangles.
Weights circumcentre_shares(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = (c - b).squaredNorm();
    const double lb = (a - c).squaredNorm();
    const double lc = (b - a).squaredNorm();
    const double wa = la * (lb + lc - la);
    const double wb = lb * (lc + la - lb);
    const double wc = lc * (la + lb - lc);
    return {{wa, wb, wc}};
}

Weights circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto [wa, wb, wc] = circumcentre_shares(a, b, c).w;
    const double sum = wa + wb + wc;
    return {{wa / sum, wb / sum, wc / sum}};
}

// Tests the ball around the circumcentre. The power of a point is its square plus a linear function, and vanishes at
// the corners: relative to p, with the centre as the sum of w x over the corners x, the power of p is 2 |centre|^2 -
// sum of w |x|^2. Both sides are multiplied by the square of the sum of the weights, which avoids the division.
bool in_circumsphere(const ClassifiedMesh& mesh, int triangle, const Vec3& p) {
    const Vec3 a = mesh.point_of(3 * triangle) - p;
    const Vec3 b = mesh.point_of(3 * triangle + 1) - p;
    const Vec3 c = mesh.point_of(3 * triangle + 2) - p;
    const auto [wa, wb, wc] = circumcentre_shares(a, b, c).w;
    const double squares = wa * a.squaredNorm() + wb * b.squaredNorm() + wc * c.squaredNorm();
    const double sum = wa + wb + wc;
    // Points count as inside the circumsphere of degenerate triangles.
    return !(sum > 0.0) || !(2.0 * (wa * a + wb * b + wc * c).squaredNorm() > sum * squares);
}

// Returns the three signed areas of p with the sides, projected along p's normal.
std::array<double, 3> side_areas(const ClassifiedMesh& mesh, int triangle, const SurfacePoint& p) {
    Vec3 up = p.normal;
    if (!(up.squaredNorm() > 0.0)) {
        up = doubled_area(mesh, triangle);
    }
    std::array<double, 3> areas{};
    for (int i = 0; i < 3; ++i) {
        const Vec3& a = mesh.point_of(3 * triangle + i);
        const Vec3& b = mesh.point_of(ClassifiedMesh::next(3 * triangle + i));
        areas[i] = (b - a).cross(p.point - a).dot(up);
    }
    return areas;
}

bool too_close(const ClassifiedMesh& mesh, int triangle, const Vec3& p, double least) {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if ((mesh.point_of(h) - p).norm() < least) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Candidate> circumcentre_site(const ClassifiedMesh& mesh, int triangle, int& blocking_segment) {
    const Vec3& a = mesh.point_of(3 * triangle);
    const Vec3& b = mesh.point_of(3 * triangle + 1);
    const Vec3& c = mesh.point_of(3 * triangle + 2);
    const int obtuse = obtuse_vertex(a, b, c);
    if (obtuse < 0) {
        return weighted_site(mesh, triangle, circumcentre(a, b, c));
    }
    const int opposite = ClassifiedMesh::next(3 * triangle + obtuse);
    blocking_segment = mesh.segment_of(opposite);
    if (blocking_segment >= 0) {
        return std::nullopt;
    }
    return weighted_site(mesh, ClassifiedMesh::triangle_of(mesh.twin(opposite)), {{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}});
}

Candidate off_centre_site(const ClassifiedMesh& mesh, int triangle, double angle) {
    const int h = shortest_side(mesh, triangle);
    const Vec3& a = mesh.point_of(h);
    const Vec3& b = mesh.point_of(ClassifiedMesh::next(h));
    const Vec3& c = mesh.point_of(ClassifiedMesh::prev(h));
    const Vec3 along = b - a;
    // The direction of the perpendicular bisector in the triangle's plane, towards the apex.
    Vec3 up = (c - a) - along * (along.dot(c - a) / along.squaredNorm());
    const double height = up.norm();
    Candidate result = edge_middle_site(mesh, h);
    if (!(height > 0.0)) {
        return result;  // no plane: the middle of the shortest edge is refused later as too close to its ends
    }
    const double half = 0.5 * along.norm();
    const double offset = along.dot(c - a) / along.squaredNorm() * along.norm() - half;
    const double centre = (height * height + offset * offset - half * half) / (2.0 * height);
    const double off_centre = half / std::tan(0.5 * OperatorTuning::kOffCentreSlack * angle);
    const double way = std::min(centre, off_centre);
    result.point += up * (way / height);
    result.reach = OperatorTuning::kMaxOffCentreLift * way;
    result.uv_is_near = false;
    return result;
}

Candidate edge_middle_site(const ClassifiedMesh& mesh, int h) {
    Weights w{{0.0, 0.0, 0.0}};
    w.w[h % 3] = 0.5;
    w.w[(h + 1) % 3] = 0.5;
    return weighted_site(mesh, ClassifiedMesh::triangle_of(h), w);
}

std::optional<SurfacePoint> surface_point(const Workspace& work, const Candidate& candidate, const Answer& nearest) {
    if (!nearest.found() || nearest.distance > candidate.reach) {
        return std::nullopt;
    }
    return SurfacePoint{work.grid.snap(nearest.point), Vec2(nearest.u, nearest.v), nearest.normal};
}

std::optional<SurfacePoint> surface_point(geometry::Answerer& answerer, const Workspace& work, const Candidate& c) {
    const int face = work.mesh.face_of(c.triangle);
    Answer answer = answerer.answer(Query::face_nearest(face, work.grid.to_shape(c.point), c.uv.x(), c.uv.y()));
    if (c.uv_is_near && (!answer.found() || answer.distance > c.reach)) {
        answer = answerer.answer(Query::face_point(face, c.uv.x(), c.uv.y()));
        answer.distance = (answer.point - work.grid.to_shape(c.point)).norm();
    }
    return surface_point(work, c, answer);
}

std::vector<std::optional<SurfacePoint>> surface_points(Workspace& work, const std::vector<Candidate>& candidates) {
    std::vector<std::optional<SurfacePoint>> result(candidates.size());
    work.session.for_chunks(candidates.size(), [&](geometry::Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            result[i] = surface_point(answerer, work, candidates[i]);
        }
    });
    return result;
}

Location locate(const ClassifiedMesh& mesh, int triangle, const SurfacePoint& p) {
    int t = triangle;
    for (int step = 0; step < kMaxWalk; ++step) {
        const std::array<double, 3> areas = side_areas(mesh, t, p);
        const int least = static_cast<int>(std::min_element(areas.begin(), areas.end()) - areas.begin());
        const int h = 3 * t + least;
        const bool on_segment = mesh.segment_of(h) >= 0;
        if (areas[least] >= 0.0) {
            return {t, -1};
        }
        if (on_segment) {
            return {t, mesh.segment_of(h)};
        }
        t = ClassifiedMesh::triangle_of(mesh.twin(h));
    }
    return {};
}

Surroundings surroundings_of(const ClassifiedMesh& mesh, int triangle, const Vec3& p) {
    Surroundings result;
    std::vector<int> queue{triangle};
    queue.reserve(32);
    for (std::size_t i = 0; i < queue.size() && queue.size() < OperatorTuning::kMaxVisit; ++i) {
        for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
            const int s = mesh.segment_of(h);
            result.nearest = std::min(result.nearest, (mesh.point_of(h) - p).norm());
            if (s >= 0) {
                if (encroached(mesh.point_of(h), mesh.point_of(ClassifiedMesh::next(h)), p)) {
                    result.encroached.push_back(s);
                }
                continue;
            }
            const int other = ClassifiedMesh::triangle_of(mesh.twin(h));
            if (std::find(queue.begin(), queue.end(), other) == queue.end() && in_circumsphere(mesh, other, p)) {
                queue.push_back(other);
            }
        }
    }
    result.triangles = std::move(queue);
    return result;
}

std::optional<Cause> insert_vertex(Workspace& work, int triangle, const SurfacePoint& p, std::vector<int>& touched,
                                   double aligned, std::optional<double> shortest) {
    ClassifiedMesh& mesh = work.mesh;
    if (too_close(mesh, triangle, p.point, shortest.value_or(work.shortest_allowed()))) {
        return work.too_short();
    }
    const double least = std::min(aligned, alignment(mesh, triangle));
    const InsertionCavity cavity = grow_cavity(mesh, 3 * triangle, false, {p.point, p.normal}, least);
    if (!cavity.complete) {
        return Cause::Fold;
    }
    if (!work.check_budget(2)) {
        return Cause::Budget;
    }
    const int face = mesh.face_of(triangle);
    const int site = mesh.add_site({mesh.add_vertex(p.point, {2, face}), p.uv, p.normal});
    const auto three = work.maxmin.split_triangle(triangle, site);
    touched.insert(touched.end(), three.begin(), three.end());
    const std::size_t before = touched.size() - 3;
    for (const int g : cavity.outside) {
        work.maxmin.swap(g, touched);
    }
    work.maxmin.restore_around(before, touched);
    work.angle_history.record(work);
    return std::nullopt;
}

std::vector<int> split_at(Workspace& work, int segment, double t, const Vec3& point, const geometry::Answer* on_faces) {
    ClassifiedMesh& mesh = work.mesh;
    const int vertex = mesh.add_vertex(point, {1, mesh.segment(segment).edge});
    std::vector<int> sites;
    for (std::size_t k = 0; k < mesh.segment(segment).uses.size(); ++k) {
        sites.push_back(mesh.add_site({vertex, Vec2(on_faces[k].u, on_faces[k].v), on_faces[k].normal}));
    }
    const int far = work.maxmin.split_segment(segment, vertex, t, sites);
    std::vector<int> halves;
    for (const int s : {segment, far}) {
        for (const ClassifiedMesh::SegmentUse& use : mesh.segment(s).uses) {
            halves.push_back(ClassifiedMesh::triangle_of(use.half_edge));
        }
    }
    return halves;
}

}  // namespace mq::triangulate

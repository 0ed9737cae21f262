// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/graded_fans.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "base/angle.h"
#include "base/predicates.h"
#include "triangulate/operators/cavity_replacement.h"
#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Fans with fewer triangles are found by refinement and mending, with fewer triangles around them.
constexpr int kFewest = 3;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

// Whether a point lies in a counter-clockwise triangle or on its boundary.
bool contains(const std::array<Vec2, 3>& triangle, const Vec2& p) {
    return orient2d(triangle[0], triangle[1], p) >= 0 && orient2d(triangle[1], triangle[2], p) >= 0 &&
           orient2d(triangle[2], triangle[0], p) >= 0;
}

struct FanShape {
    int triangles = 0;   // with equal angles; 0: there is no such fan
    double ratio = 1.0;  // by which each spoke is longer than the last one
};

// Returns the fan with the fewest triangles that fills an angle (radians) between sides of these lengths with all
// angles above the bound.
FanShape fan_between(double angle, double first, double last, double bound) {
    for (int n = 1; angle / n > bound; ++n) {
        const double top = angle / n;
        const double ratio = std::pow(last / first, 1.0 / n);
        const double far = std::atan2(std::sin(top), std::max(ratio, 1.0 / ratio) - std::cos(top));
        if (std::min({top, far, M_PI - top - far}) > bound) {
            return {n, ratio};
        }
    }
    return {};
}

/// The fan around one vertex between two pieces of edges, on one face, in the plane of the triangles that are there.
/// New vertices count as sites -1, -2, ... until the fan is written.
class GradedFan {
  public:
    GradedFan(Workspace& work, const std::vector<int>& star, double bound)
        : work_(work), mesh_(work.mesh), star_(star), bound_(bound), middle_(mesh_.point_of(star.front())) {
        Vec3 up = Vec3::Zero();
        for (const int h : star) {
            up += doubled_area(mesh_, ClassifiedMesh::triangle_of(h));
        }
        along_ = (mesh_.point_of(ClassifiedMesh::next(star.front())) - middle_).normalized();
        across_ = up.cross(along_).normalized();
        along_ = across_.cross(up).normalized();
    }

    /// Writes the fan, unless its surroundings leave no place for it.
    bool write(std::vector<int>& touched) {
        if (!place_vertices() || !find_cavity() || !fill_fan() || !fill_around() || !within_budget()) {
            return false;
        }
        apply(touched);
        return true;
    }

  private:
    struct PolygonCorner {
        Vec2 place;
        int site = -1;
    };

    Vec2 flat(const Vec3& p) const { return {(p - middle_).dot(along_), (p - middle_).dot(across_)}; }
    Vec2 flat_at(int h) const { return flat(mesh_.point_of(h)); }
    int first_end() const { return ClassifiedMesh::next(star_.front()); }
    int last_end() const { return ClassifiedMesh::prev(star_.back()); }

    bool place_vertices() {
        const Vec2 first = flat_at(first_end());
        const Vec2 last = flat_at(last_end());
        double sum = 0.0;
        for (const int h : star_) {
            sum += angle_at(mesh_, h);
        }
        double whole = std::atan2(cross(first, last), first.dot(last));
        whole += whole < 0.0 || sum > whole + M_PI ? 2.0 * M_PI : 0.0;
        FanShape shape;
        for (const double margin : {RefinementTuning::kFanMargin, RefinementTuning::kLeastFanMargin}) {
            shape = shape.triangles > 0 ? shape : fan_between(whole, first.norm(), last.norm(), bound_ + margin);
        }
        if (shape.triangles < kFewest) {
            return false;
        }
        std::vector<Candidate> candidates;
        for (int k = 1; k < shape.triangles; ++k) {
            const double turned = whole * k / shape.triangles;
            candidates.push_back(
                candidate(first.norm() * std::pow(shape.ratio, k) * Vec2(std::cos(turned), std::sin(turned))));
        }
        for (const auto& point : surface_points(work_, candidates)) {
            if (!point) {
                return false;
            }
            points_.push_back(*point);
        }
        return true;
    }

    // A place in the triangles of the star, which are continued beyond their far sides.
    Candidate candidate(const Vec2& place) const {
        const auto turns_to = [&](int h) {
            return cross(flat_at(ClassifiedMesh::next(h)), place) >= 0.0 &&
                   cross(place, flat_at(ClassifiedMesh::prev(h))) >= 0.0;
        };
        const auto found = std::find_if(star_.begin(), star_.end(), turns_to);
        const int h = found != star_.end() ? *found : star_.back();
        const int g = ClassifiedMesh::next(h);
        const int k = ClassifiedMesh::prev(h);
        const double area = cross(flat_at(g), flat_at(k));
        const double at_g = cross(place, flat_at(k)) / area;
        const double at_k = cross(flat_at(g), place) / area;
        const auto uv = [&](int half_edge) { return mesh_.site(mesh_.site_of(half_edge)).uv; };
        return {ClassifiedMesh::triangle_of(h),
                middle_ + at_g * (mesh_.point_of(g) - middle_) + at_k * (mesh_.point_of(k) - middle_),
                uv(h) + at_g * (uv(g) - uv(h)) + at_k * (uv(k) - uv(h)), false, place.norm()};
    }

    // Finds the triangles that the fan replaces, which have to form a disc.
    bool find_cavity() {
        std::vector<Vec2> far{flat_at(first_end())};
        for (const SurfacePoint& p : points_) {
            far.push_back(flat(p.point));
        }
        far.push_back(flat_at(last_end()));
        std::vector<int> triangles;
        for (const int h : star_) {
            triangles.push_back(ClassifiedMesh::triangle_of(h));
        }
        std::set<int> seen(triangles.begin(), triangles.end());
        for (std::size_t i = 0; i < triangles.size() && i < RefinementTuning::kMostUnderFan; ++i) {
            for (int h = 3 * triangles[i]; h < 3 * triangles[i] + 3; ++h) {
                const int t = mesh_.twin(h) < 0 ? -1 : ClassifiedMesh::triangle_of(mesh_.twin(h));
                if (t >= 0 && seen.insert(t).second && overlaps(t, far)) {
                    triangles.push_back(t);
                }
            }
        }
        disc_ = triangles.size() < RefinementTuning::kMostUnderFan ? disc_of(mesh_, triangles) : std::nullopt;
        return disc_.has_value();
    }

    // Whether a triangle lies under the fan in part, whose far ends are `far`, or has a vertex that is in its way.
    bool overlaps(int triangle, const std::vector<Vec2>& far) const {
        std::array<Vec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const int h = 3 * triangle + static_cast<int>(i);
            corners[i] = flat_at(h);
            if (in_the_way(h, far)) {
                return true;
            }
        }
        for (std::size_t k = 0; k + 1 < far.size(); ++k) {
            if ((k > 0 && contains(corners, far[k])) || cross_each_other(far[k], far[k + 1], corners[0], corners[1]) ||
                cross_each_other(far[k], far[k + 1], corners[1], corners[2]) ||
                cross_each_other(far[k], far[k + 1], corners[2], corners[0])) {
                return true;
            }
        }
        return false;
    }

    // Whether a vertex inside the face lies in the fan or near one of its vertices.
    bool in_the_way(int h, const std::vector<Vec2>& far) const {
        if (work_.maxmin.on_border(mesh_.vertex_of(h))) {
            return false;
        }
        const Vec2 p = flat_at(h);
        for (std::size_t k = 0; k + 1 < far.size(); ++k) {
            if (contains({Vec2::Zero(), far[k], far[k + 1]}, p) ||
                (k > 0 && (far[k] - p).norm() < RefinementTuning::kFanRoom * far[k].norm())) {
                return true;
            }
        }
        return false;
    }

    Corner corner_at(int site) const {
        if (site >= 0) {
            return corner_of(mesh_, site);
        }
        const SurfacePoint& p = points_[static_cast<std::size_t>(-1 - site)];
        return {p.point, p.normal};
    }

    // The squared sine of the smallest angle of a triangle; 0: it is inverted in the plane, or folds over the surface.
    double quality(int a, int b, int c) const {
        const Corner corners[3] = {corner_at(a), corner_at(b), corner_at(c)};
        const bool up = orient2d(flat(corners[0].point), flat(corners[1].point), flat(corners[2].point)) > 0;
        return up && alignment(corners[0], corners[1], corners[2]) >= kAlignedSwap
                   ? squared_sine_of_smallest_angle(corners[0].point, corners[1].point, corners[2].point)
                   : 0.0;
    }

    bool fill_fan() {
        const int middle = mesh_.site_of(star_.front());
        const int last = static_cast<int>(points_.size());
        for (int k = 0; k <= last; ++k) {
            const std::array<int, 3> sites{middle, k == 0 ? mesh_.site_of(first_end()) : -k,
                                           k == last ? mesh_.site_of(last_end()) : -1 - k};
            if (!(quality(sites[0], sites[1], sites[2]) > sine_squared_above(bound_))) {
                return false;
            }
            triangles_.push_back(sites);
        }
        return true;
    }

    // Fills the space between the fan and the rim of the cavity: cuts off the best ear as long as there is one.
    bool fill_around() {
        std::vector<PolygonCorner> polygon;
        const auto add = [&](int site) { polygon.push_back({flat(corner_at(site).point), site}); };
        std::map<int, int> next;  // by site on the rim
        for (const int side : disc_->rim) {
            next[mesh_.site_of(side)] = mesh_.site_of(ClassifiedMesh::next(side));
        }
        const int middle = mesh_.site_of(star_.front());
        for (int s = next[middle]; s != middle; s = next[s]) {
            add(s);
        }
        for (int k = static_cast<int>(points_.size()); k > 0; --k) {
            add(-k);
        }
        while (polygon.size() > 2) {
            std::size_t best = 0;
            double quality = 0.0;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const double here = quality_of_ear(polygon, i);
                if (here > quality) {
                    best = i;
                    quality = here;
                }
            }
            if (!(quality > 0.0)) {
                return false;
            }
            const std::size_t n = polygon.size();
            triangles_.push_back({polygon[(best + n - 1) % n].site, polygon[best].site, polygon[(best + 1) % n].site});
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
        }
        return true;
    }

    // As `quality`, for the triangle of a corner of the polygon and its neighbours; 0 also if it cannot be cut off.
    double quality_of_ear(const std::vector<PolygonCorner>& polygon, std::size_t i) const {
        const std::size_t n = polygon.size();
        const PolygonCorner& a = polygon[(i + n - 1) % n];
        const PolygonCorner& b = polygon[i];
        const PolygonCorner& c = polygon[(i + 1) % n];
        const double result = quality(a.site, b.site, c.site);
        const bool doubled = n > 3 && a.site >= 0 && c.site >= 0 &&
                             work_.maxmin.joined(mesh_.site(a.site).vertex, mesh_.site(c.site).vertex);
        const auto blocks = [&](const PolygonCorner& d) {
            return &d != &a && &d != &b && &d != &c && contains({a.place, b.place, c.place}, d.place);
        };
        return !(result > 0.0) || doubled || std::any_of(polygon.begin(), polygon.end(), blocks) ? 0.0 : result;
    }

    bool within_budget() {
        const std::size_t now = disc_->triangles.size();
        return triangles_.size() <= now || work_.check_budget(triangles_.size() - now);
    }

    void apply(std::vector<int>& touched) {
        const int face = mesh_.face_of(disc_->triangles.front());
        std::vector<int> sites;
        for (const SurfacePoint& p : points_) {
            sites.push_back(mesh_.add_site({mesh_.add_vertex(p.point, {2, face}), p.uv, p.normal}));
        }
        for (std::array<int, 3>& triangle : triangles_) {
            for (int& site : triangle) {
                site = site < 0 ? sites[static_cast<std::size_t>(-1 - site)] : site;
            }
        }
        withdraw_exemptions(work_, disc_->triangles);
        const std::size_t before = touched.size();
        const std::vector<int> added = work_.maxmin.replace(disc_->triangles, triangles_);
        touched.insert(touched.end(), added.begin(), added.end());
        work_.maxmin.restore_around(before, touched);
        close_gaps(work_, touched);
    }

    Workspace& work_;
    ClassifiedMesh& mesh_;
    const std::vector<int>& star_;
    double bound_;                               // radians
    Vec3 middle_;                                // the point around which the fan lies
    Vec3 along_ = Vec3::Zero();                  // unit vector in the plane of the fan, towards its first side
    Vec3 across_ = Vec3::Zero();                 // the other one, counter-clockwise from it
    std::vector<SurfacePoint> points_;           // the new vertices, counter-clockwise
    std::optional<Cavity> disc_;                 // the triangles that are replaced
    std::vector<std::array<int, 3>> triangles_;  // that replace them: sites
};

// Whether a triangle of the star fills a corner of the shape on this face.
bool in_narrow_corner(const ClassifiedMesh& mesh, const std::vector<int>& star) {
    return std::any_of(star.begin(), star.end(),
                       [&](int h) { return narrow_corner_of(mesh, ClassifiedMesh::triangle_of(h)) >= 0; });
}

}  // namespace

bool GradedFans::write_beside(int triangle, std::vector<int>& touched) {
    const ClassifiedMesh& mesh = work_.mesh;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const int middle = mesh.vertex_of(h);
        if (!work_.maxmin.on_border(middle)) {
            continue;
        }
        const std::vector<int> star = mesh.star(h);
        const int first = mesh.segment_of(star.front());
        const int last = mesh.segment_of(ClassifiedMesh::prev(star.back()));
        const std::array<int, 3> fan{middle, mesh.vertex_of(ClassifiedMesh::next(star.front())),
                                     mesh.vertex_of(ClassifiedMesh::prev(star.back()))};
        if (first >= 0 && last >= 0 && (ends_innermost_piece(first, middle) || ends_innermost_piece(last, middle)) &&
            tried_.count(fan) == 0 && !in_narrow_corner(mesh, star)) {
            tried_.insert(fan);
            if (GradedFan(work_, star, bound_).write(touched)) {
                return true;
            }
        }
    }
    return false;
}

void GradedFans::renumber(const NewIndices& renewed) {
    std::set<std::array<int, 3>> moved;
    for (std::array<int, 3> fan : tried_) {
        for (int& vertex : fan) {
            vertex = renewed.vertices[static_cast<std::size_t>(vertex)];
        }
        moved.insert(fan);
    }
    tried_ = std::move(moved);
}

// Whether the vertex is the end of an innermost piece away from its corner.
bool GradedFans::ends_innermost_piece(int segment, int vertex) const {
    int corner = -1;
    return segments_.is_terminal(segment, &corner) && corner != vertex;
}

}  // namespace mq::triangulate

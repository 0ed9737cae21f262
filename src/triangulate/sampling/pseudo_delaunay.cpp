// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/pseudo_delaunay.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "base/angle.h"
#include "base/key_set.h"
#include "triangulate/front/angular_sectors.h"
#include "triangulate/front/front_boundary.h"
#include "triangulate/front/front_fault.h"
#include "triangulate/sampling/tuning.h"
#include "triangulate/spacing/point_octree.h"

namespace mq::triangulate {

namespace {
using VertexUse = FaceMesh::VertexUse;

// Fraction of a ball's radius: vertices this close to the ball lie on it within rounding.
constexpr double kRound = 1e-9;
constexpr double kSees = 0.0;  // Least cosine between the normals of two vertices on one sheet of the surface.
// Least cosine between a triangle's normal and those at its corners if no other triangle fits (90 degrees), since the
// normal turns too much for the spacing.
constexpr double kTurnedLast = 0.0;

class Front {
  public:
    Front(const SamplingContext& context, int face, const FaceBoundary& border,
          const std::vector<FaceSampler::Candidate>& samples);

    FaceMesh run(const FaceMesh& coarse);

  private:
    struct Edge {
        int from;
        int to;
    };
    struct Option {
        int apex;
        double reach;  // signed distance of the ball's centre from the edge, towards the apex
        Vec3 centre;
    };

    // The conditions that a new triangle must meet.
    struct Pass {
        bool only_empty_balls;
        double turned;  // SamplingTuning::kTurned or kTurnedLast
    };

    void place_sites(const std::vector<FaceSampler::Candidate>& samples);
    void replace_normal(int site);
    std::vector<Option> options(const Edge& edge) const;
    std::optional<Option> option(const Edge& edge, int apex, const Vec3& up) const;
    bool empty(const Edge& edge, const Option& ball) const;
    bool fits(const Edge& edge, int apex, const Pass& pass) const;
    bool side_fits(int from, int to) const;
    bool crosses_front(int from, int to) const;
    bool advance(const Edge& edge, const Pass& pass);
    void add_triangle(int a, int b, int c);
    void close_or_open(int from, int to, int half_edge);
    void collect(FaceMesh& made) const;

    const Vec3& point(int s) const { return sites_[s].point; }
    const Vec3& normal(int s) const { return normals_[s]; }
    bool same_place(int a, int b) const { return point(a) == point(b); }
    bool sees(const Vec3& from, const Vec3& up, int s) const;
    // Whether the surface at the site faces the direction `up`; at an apex it faces every direction.
    bool faces(int s, const Vec3& up, double least) const {
        return !(sites_[s].normal.squaredNorm() > 0.0) || up.dot(normal(s)) > least;
    }

    const FaceBoundary& border_;
    const SamplingContext& context_;
    FrontBorder outline_;
    std::vector<VertexUse> sites_;
    std::vector<Vec3> normals_;    // never zero
    PointOctree index_;            // has the numbers of the sites
    std::vector<double> spacing_;  // by site, mm
    std::vector<AngularSectors> fans_;
    KeyMap<int> open_;                    // front edges: index of the piece of the border under them, or -1
    KeyMap<int> half_edge_;               // edges of triangles: their half-edge
    std::vector<std::vector<int>> next_;  // by site: ends of the open edges that begin there
    std::deque<Edge> queue_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<int> piece_;  // by half-edge, or -1
};

Front::Front(const SamplingContext& context, int face, const FaceBoundary& border,
             const std::vector<FaceSampler::Candidate>& samples)
    : border_(border),
      context_(context),
      outline_(border, context.session.topology().faces[face].reversed),
      sites_(border.sites) {
    place_sites(samples);
    for (const FrontBorder::Edge& e : outline_.edges()) {
        open_[ordered_key(e.from, e.to)] = e.piece;
        next_[e.from].push_back(e.to);
        queue_.push_back({e.from, e.to});
    }
}

void Front::place_sites(const std::vector<FaceSampler::Candidate>& samples) {
    spacing_ = outline_.scales();
    for (const FaceSampler::Candidate& c : samples) {
        sites_.push_back(c.site);
        spacing_.push_back(c.spacing);
    }
    for (std::size_t s = 0; s < sites_.size(); ++s) {
        index_.add(sites_[s].point, spacing_[s] > 0.0 ? spacing_[s] : context_.bounds.least);
        normals_.push_back(sites_[s].normal);
    }
    next_.resize(sites_.size());
    for (int s = 0; s < static_cast<int>(border_.sites.size()); ++s) {
        if (!(normals_[s].squaredNorm() > 0.0)) {
            replace_normal(s);
        }
    }
    for (std::size_t s = 0; s < sites_.size(); ++s) {
        fans_.emplace_back(normals_[s]);
        if (s < border_.sites.size()) {
            outline_.occupy_outside(static_cast<int>(s), fans_.back());
        }
    }
}

// At an apex: returns a direction from which all of the surface around it is visible, so that the angles around it add
// up to a full turn. This is the centre of the smallest ball around the normals there (Badoiu and Clarkson 2003);
// their mean would depend on the density of samples.
void Front::replace_normal(int site) {
    const double radius = SamplingTuning::kApexNeighbourhood * std::max(outline_.scales()[site], context_.bounds.least);
    std::vector<Vec3> around;
    index_.any_near(point(site), radius, [&](int s) {
        if ((point(s) - point(site)).norm() <= radius && sites_[s].normal.squaredNorm() > 0.0) {
            around.push_back(sites_[s].normal);
        }
        return false;
    });
    Vec3 centre = around.empty() ? Vec3::UnitZ() : around[0];
    for (int round = 1; round < SamplingTuning::kApexRounds && !around.empty(); ++round) {
        const Vec3 farthest = *std::max_element(around.begin(), around.end(), [&](const Vec3& a, const Vec3& b) {
            return (a - centre).squaredNorm() < (b - centre).squaredNorm();
        });
        centre += (farthest - centre) / (round + 1.0);
    }
    normals_[site] = centre.squaredNorm() > 0.0 ? Vec3(centre.normalized()) : Vec3(Vec3::UnitZ());
}

// Whether a site is on the same sheet as a point of the surface: its normal has about the same direction, and it rises
// over the tangent plane there little more than an arc between the two. Otherwise it belongs to the other side of a
// thin wall or to another turn of a thread.
bool Front::sees(const Vec3& from, const Vec3& up, int s) const {
    if (!(sites_[s].normal.squaredNorm() > 0.0)) {
        return true;
    }
    const Vec3 arm = point(s) - from;
    const double rise = std::asin(std::min(1.0, std::abs(arm.dot(up)) / (arm.norm() * up.norm())));
    return up.dot(normal(s)) > kSees &&
           (rise < SamplingTuning::kRise || rise < SamplingTuning::kRise + 0.5 * angle_between(up, normal(s)));
}

// Returns the ball through the edge and an apex on its left. Among all apexes the one with the smallest reach has a
// ball that is empty on that side.
std::optional<Front::Option> Front::option(const Edge& edge, int apex, const Vec3& up) const {
    const Vec3 along = point(edge.to) - point(edge.from);
    const double length = along.norm();
    const Vec3 middle = 0.5 * (point(edge.from) + point(edge.to));
    const Vec3 arm = point(apex) - middle;
    const Vec3 across = arm - along * (arm.dot(along) / (length * length));
    const double height = across.norm();
    if (!(height > kRound * length) || up.cross(along).dot(across) <= 0.0 || !sees(middle, up, apex)) {
        return std::nullopt;
    }
    const double reach = (arm.squaredNorm() - 0.25 * length * length) / (2.0 * height);
    return Option{apex, reach, middle + across * (reach / height)};
}

std::vector<Front::Option> Front::options(const Edge& edge) const {
    const Vec3 middle = 0.5 * (point(edge.from) + point(edge.to));
    const double length = (point(edge.to) - point(edge.from)).norm();
    const Vec3 up = normal(edge.from) + normal(edge.to);
    const double farthest = SamplingTuning::kSearchRadius * std::max({length, spacing_[edge.from], spacing_[edge.to]});
    std::vector<Option> found;
    double radius = length;
    for (;;) {
        found.clear();
        index_.any_near(middle, radius, [&](int s) {
            if (!outline_.merged(s) && !same_place(s, edge.from) && !same_place(s, edge.to) &&
                (point(s) - middle).squaredNorm() <= radius * radius) {
                if (const auto o = option(edge, s, up)) {
                    found.push_back(*o);
                }
            }
            return false;
        });
        std::sort(found.begin(), found.end(), [](const Option& a, const Option& b) {
            return a.reach != b.reach ? a.reach < b.reach : a.apex < b.apex;
        });
        const double needed = found.empty() ? 2.0 * radius : found[0].reach + std::hypot(found[0].reach, 0.5 * length);
        if (radius >= farthest || needed <= radius) {
            break;
        }
        radius = std::min(farthest, std::max(1.5 * radius, std::min(needed, 4.0 * radius)));
    }
    return found;
}

// The paper's test: whether no other vertex is in the ball.
bool Front::empty(const Edge& edge, const Option& ball) const {
    const double radius = (point(edge.from) - ball.centre).norm();
    const double inside = radius * (1.0 - kRound);
    const Vec3 middle = 0.5 * (point(edge.from) + point(edge.to));
    const Vec3 up = normal(edge.from) + normal(edge.to);
    return !index_.any_near(ball.centre, radius, [&](int s) {
        return (point(s) - ball.centre).squaredNorm() < inside * inside && !same_place(s, edge.from) &&
               !same_place(s, edge.to) && !same_place(s, ball.apex) && sees(middle, up, s);
    });
}

bool Front::side_fits(int from, int to) const {
    return open_.count(ordered_key(from, to)) != 0 ||
           (open_.count(ordered_key(to, from)) == 0 && half_edge_.count(ordered_key(from, to)) == 0 &&
            half_edge_.count(ordered_key(to, from)) == 0 && !crosses_front(from, to));
}

// Whether a triangle's normal agrees with those at its corners, it overlaps no others at its corners, and its sides
// cross no others.
bool Front::fits(const Edge& edge, int apex, const Pass& pass) const {
    const int corners[3] = {edge.from, edge.to, apex};
    const Vec3 own = (point(edge.to) - point(edge.from)).cross(point(apex) - point(edge.from)).normalized();
    for (int i = 0; i < 3; ++i) {
        const int s = corners[i];
        const Vec3 right = point(corners[(i + 1) % 3]) - point(s);
        const Vec3 left = point(corners[(i + 2) % 3]) - point(s);
        if (!faces(s, own, pass.turned) || !fans_[s].free(fans_[s].angle_of(right), fans_[s].angle_of(left))) {
            return false;
        }
    }
    return side_fits(edge.to, apex) && side_fits(apex, edge.from);
}

// Whether the side from a to b, projected along the normals at its ends, crosses an open edge on the same sheet of the
// surface.
bool Front::crosses_front(int a, int b) const {
    const Vec3 along = point(b) - point(a);
    const double length = along.norm();
    const Vec3 up = (normal(a) + normal(b)).normalized();
    const auto side = [&](const Vec3& p, const Vec3& q, const Vec3& r) { return (q - p).cross(r - p).dot(up); };
    const auto crosses = [&](int s, int t) {
        const Vec3 other = point(t) - point(s);
        const double s1 = side(point(a), point(b), point(s));
        const double s2 = side(point(a), point(b), point(t));
        const double s3 = side(point(s), point(t), point(a));
        const double s4 = side(point(s), point(t), point(b));
        if ((s1 > 0.0) == (s2 > 0.0) || (s3 > 0.0) == (s4 > 0.0)) {
            return false;
        }
        const Vec3 gap = point(a) + along * (s3 / (s3 - s4)) - point(s) - other * (s1 / (s1 - s2));
        return std::abs(gap.dot(up)) < SamplingTuning::kSheet * length;
    };
    return index_.any_near(point(a) + 0.5 * along, length, [&](int s) {
        return !same_place(s, a) && !same_place(s, b) && faces(s, up, kSees) &&
               std::any_of(next_[s].begin(), next_[s].end(),
                           [&](int t) { return !same_place(t, a) && !same_place(t, b) && crosses(s, t); });
    });
}

bool Front::advance(const Edge& edge, const Pass& pass) {
    const std::vector<Option> all = options(edge);
    for (std::size_t i = 0; i < std::min(all.size(), SamplingTuning::kCandidates); ++i) {
        if (pass.only_empty_balls && !empty(edge, all[i])) {
            break;  // later balls contain the same vertex, or this ball's apex
        }
        if (fits(edge, all[i].apex, pass)) {
            add_triangle(edge.from, edge.to, all[i].apex);
            return true;
        }
    }
    return false;
}

void Front::add_triangle(int a, int b, int c) {
    const int corners[3] = {a, b, c};
    const int t = static_cast<int>(triangles_.size());
    triangles_.push_back({a, b, c});
    for (int i = 0; i < 3; ++i) {
        const int s = corners[i];
        const int right = corners[(i + 1) % 3];
        AngularSectors& fan = fans_[s];
        fan.occupy(fan.angle_of(point(right) - point(s)), fan.angle_of(point(corners[(i + 2) % 3]) - point(s)));
        close_or_open(s, right, 3 * t + i);
    }
}

void Front::close_or_open(int from, int to, int half_edge) {
    half_edge_[ordered_key(from, to)] = half_edge;
    const auto found = open_.find(ordered_key(from, to));
    if (found == open_.end()) {
        open_[ordered_key(to, from)] = -1;
        next_[to].push_back(from);
        queue_.push_back({to, from});
        piece_.push_back(-1);
        return;
    }
    piece_.push_back(found->second);
    open_.erase(found);
    next_[from].erase(std::find(next_[from].begin(), next_[from].end(), to));
}

FaceMesh Front::run(const FaceMesh& coarse) {
    FaceMesh made;
    made.failure = outline_.failure();
    if (!made.failure.empty()) {
        return made;
    }
    CancelPace pace(context_.progress);
    std::deque<Edge> left;
    for (const Pass& pass :
         {Pass{true, SamplingTuning::kTurned}, Pass{false, SamplingTuning::kTurned}, Pass{false, kTurnedLast}}) {
        queue_.insert(queue_.end(), left.begin(), left.end());
        left.clear();
        while (!queue_.empty()) {
            pace.step();
            const Edge edge = queue_.front();
            queue_.pop_front();
            if (open_.count(ordered_key(edge.from, edge.to)) != 0 && !advance(edge, pass)) {
                left.push_back(edge);
            }
        }
    }
    if (!open_.empty()) {
        made.failure = "the front of triangles did not close: " + std::to_string(open_.size()) + " edges were left";
        return made;
    }
    collect(made);
    made.failure = fault_of_face(made, coarse, context_.session.topology());
    return made;
}

void Front::collect(FaceMesh& made) const {
    made.sites = sites_;
    made.triangles = triangles_;
    made.links.resize(triangles_.size());
    for (const FaceBoundary::Piece& p : border_.pieces) {
        made.borders.push_back({p.use, p.index});
    }
    for (int h = 0; h < static_cast<int>(piece_.size()); ++h) {
        FaceMesh::Link& link = made.links[h / 3][h % 3];
        link.border = piece_[h];
        if (link.border < 0) {
            const auto& t = triangles_[h / 3];
            link.half_edge = half_edge_.at(ordered_key(t[(h + 1) % 3], t[h % 3]));
        }
    }
    outline_.part_merged(made);
}

}  // namespace

FaceMesh triangulate_pseudo_delaunay(const SamplingContext& context, int face, const FaceBoundary& border,
                                     const std::vector<FaceSampler::Candidate>& samples, const FaceMesh& coarse) {
    return Front(context, face, border, samples).run(coarse);
}

}  // namespace mq::triangulate

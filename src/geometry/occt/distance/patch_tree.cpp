// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/distance/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostPoles = 26;  // poles of a row: OpenCASCADE's highest degree is 25
// If the squared distance is not convex, patches are halved down to this fraction of their distance from the point,
// seen from which such a patch is nearly one point; at a pole, on which the point lies, down to this fraction of the
// whole.
constexpr double kSmallBesideDistance = 0.05;
constexpr double kSmallBesideWhole = 1e-6;  // as a fraction of the whole

using Pole = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

Pole homogeneous(const gp_Pnt& p, double weight) {
    return {p.X() * weight, p.Y() * weight, p.Z() * weight, weight};
}

Vec3 in_space(const Pole& p) {
    return p.head<3>() / p[3];
}

/// A point of a polynomial in Bernstein's form with its first two derivatives.
struct Row {
    Pole value;
    Pole first = Pole::Zero();
    Pole second = Pole::Zero();
};

/// By de Casteljau's scheme. `poles` are used up.
Row row_at(Pole* poles, std::size_t degree, double t) {
    for (std::size_t level = degree; level > 2; --level) {
        for (std::size_t i = 0; i < level; ++i) {
            poles[i] += t * (poles[i + 1] - poles[i]);
        }
    }
    const auto n = static_cast<double>(degree);
    if (degree == 0) {
        return {poles[0]};
    }
    if (degree == 1) {
        return {poles[0] + t * (poles[1] - poles[0]), poles[1] - poles[0]};
    }
    const Pole a = poles[1] - poles[0];
    const Pole b = poles[2] - poles[1];
    const Pole first = a + t * (b - a);
    return {poles[0] + t * (a + first), n * first, n * (n - 1.0) * (b - a)};
}

}  // namespace

/// A point of a patch with its derivatives.
struct PatchTree::Jet {
    Vec3 point;
    Vec3 first[2];
    Vec3 second[3];  // ss, st, tt
};

PatchTree::PatchTree(const Handle(Geom_BSplineSurface) & surface, const ParameterBox& range) {
    const Handle(Geom_BSplineSurface) s = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    double u[2];
    double v[2];
    s->Bounds(u[0], u[1], v[0], v[1]);
    const Turn turns[2] = {{u[0], s->IsUPeriodic() ? u[1] - u[0] : 0.0}, {v[0], s->IsVPeriodic() ? v[1] - v[0] : 0.0}};
    s->SetUNotPeriodic();
    s->SetVNotPeriodic();
    s->IncreaseUMultiplicity(s->FirstUKnotIndex(), s->LastUKnotIndex(), s->UDegree());
    s->IncreaseVMultiplicity(s->FirstVKnotIndex(), s->LastVKnotIndex(), s->VDegree());
    degree_ = {static_cast<std::size_t>(s->UDegree()), static_cast<std::size_t>(s->VDegree())};
    const bool rational = s->IsURational() || s->IsVRational();  // else weights of a formerly periodic surface may be 0
    Net poles;
    for (int i = 1; i <= s->NbUPoles(); ++i) {
        for (int k = 1; k <= s->NbVPoles(); ++k) {
            poles.push_back(homogeneous(s->Pole(i, k), rational ? s->Weight(i, k) : 1.0));
        }
    }
    const KnotSpans spans{
        spans_in(s->UKnots(), s->UMultiplicities(), degree_[0], turns[0], range.low[0], range.high[0]),
        spans_in(s->VKnots(), s->VMultiplicities(), degree_[1], turns[1], range.low[1], range.high[1])};
    build(spans, poles, static_cast<std::size_t>(s->NbVPoles()));
}

PatchTree::PatchTree(const Handle(Geom_BSplineCurve) & curve, double from, double to) {
    const Handle(Geom_BSplineCurve) c = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    const Turn turn{c->FirstParameter(), c->IsPeriodic() ? c->Period() : 0.0};
    c->SetNotPeriodic();
    c->IncreaseMultiplicity(c->FirstUKnotIndex(), c->LastUKnotIndex(), c->Degree());
    degree_ = {static_cast<std::size_t>(c->Degree()), 0};
    Net poles;
    for (int i = 1; i <= c->NbPoles(); ++i) {
        poles.push_back(homogeneous(c->Pole(i), c->IsRational() ? c->Weight(i) : 1.0));
    }
    build({spans_in(c->Knots(), c->Multiplicities(), degree_[0], turn, from, to), {{{0.0, 1.0}, {0.0, 1.0}, 0}}}, poles,
          1);
}

/// Between knots whose multiplicity is the degree, the poles are those of a Bézier patch.
std::vector<PatchTree::Span> PatchTree::spans_in(const TColStd_Array1OfReal& knots,
                                                 const TColStd_Array1OfInteger& multiplicities, std::size_t degree,
                                                 const Turn& first, double from, double to) {
    const double slack = 1e-12 * std::max(std::abs(from), std::abs(to));
    std::vector<Span> spans;
    const auto add = [&](double turn) {
        std::size_t knots_so_far = 0;
        for (int i = knots.Lower(); i < knots.Upper(); ++i) {
            knots_so_far += static_cast<std::size_t>(multiplicities(i));
            const Span span{{knots(i) + turn, knots(i + 1) + turn},
                            {std::max(from, knots(i) + turn), std::min(to, knots(i + 1) + turn)},
                            knots_so_far - degree - 1};
            // The outer knots of splines that do not end in a pole are no borders of spans.
            if (knots_so_far > degree && static_cast<std::size_t>(multiplicities(i + 1)) >= degree &&
                span.range[1] - span.range[0] > slack) {
                spans.push_back(span);
            }
        }
    };
    if (!(first.period > 0.0)) {
        add(0.0);
        return spans;
    }
    const double turn = first.period * std::floor((from - first.low) / first.period);
    add(turn);
    add(turn + first.period);
    return spans;
}

void PatchTree::build(const KnotSpans& spans, const Net& poles, std::size_t columns) {
    if (spans[0].empty() || spans[1].empty()) {
        return;
    }
    nodes_.reserve(2 * spans[0].size() * spans[1].size());
    nodes_.emplace_back();
    group(0, spans, {0, spans[0].size(), 0, spans[1].size()}, poles, columns);
    least_radius_ = kSmallBesideWhole * nodes_.front().radius;
}

/// Halves the block of spans until it has one span.
void PatchTree::group(std::size_t node, const KnotSpans& spans, const Block& block, const Net& poles,
                      std::size_t columns) {
    const std::size_t counts[2] = {block[1] - block[0], block[3] - block[2]};
    if (counts[0] == 1 && counts[1] == 1) {
        fill(nodes_[node], {&spans[0][block[0]], &spans[1][block[2]]}, poles, columns);
        return;
    }
    const std::size_t child = nodes_.size();
    nodes_.resize(child + 2);
    nodes_[node].child = child;
    const std::size_t along = counts[1] > counts[0] ? 2 : 0;
    Block halves[2] = {block, block};
    halves[0][along + 1] = halves[1][along] = (block[along] + block[along + 1]) / 2;
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < 2; ++i) {
        group(child + i, spans, halves[i], poles, columns);
        const Node& half = nodes_[child + i];
        for (int corner = 0; corner < 8; ++corner) {
            box.extend(half.axes * Vec3((corner & 1) != 0 ? half.most.x() : half.least.x(),
                                        (corner & 2) != 0 ? half.most.y() : half.least.y(),
                                        (corner & 4) != 0 ? half.most.z() : half.least.z()));
        }
    }
    nodes_[node].least = box.min();
    nodes_[node].most = box.max();
    nodes_[node].middle = box.center();
    nodes_[node].radius = 0.5 * box.diagonal().norm();
}

void PatchTree::fill(Node& node, const std::array<const Span*, 2>& spans, const Net& poles, std::size_t columns) const {
    for (std::size_t i = 0; i <= degree_[0]; ++i) {
        for (std::size_t k = 0; k <= degree_[1]; ++k) {
            node.net.push_back(poles[(spans[0]->pole + i) * columns + spans[1]->pole + k]);
        }
    }
    for (std::size_t along = 0; along < 2; ++along) {
        const Span& span = *spans[along];
        node.low[along] = span.range[0];
        node.high[along] = span.range[1];
        if (span.range[1] < span.knots[1]) {
            node.net = cut(node.net, along, (span.range[1] - span.knots[0]) / (span.knots[1] - span.knots[0])).front();
        }
        if (span.range[0] > span.knots[0]) {
            node.net = cut(node.net, along, (span.range[0] - span.knots[0]) / (span.range[1] - span.knots[0])).back();
        }
    }
    set_box(node);
}

/// The two halves of a patch, by de Casteljau's scheme.
std::array<PatchTree::Net, 2> PatchTree::cut(const Net& net, std::size_t along, double fraction) const {
    const std::size_t degree = degree_[along];
    const std::size_t rows = degree_[1 - along] + 1;
    const std::size_t step = along == 0 ? degree_[1] + 1 : 1;
    const std::size_t row_step = along == 0 ? 1 : degree_[1] + 1;
    std::array<Net, 2> parts{net, net};
    for (std::size_t r = 0; r < rows; ++r) {
        Homogeneous* low = parts[0].data() + r * row_step;
        Homogeneous* high = parts[1].data() + r * row_step;
        for (std::size_t level = 1; level <= degree; ++level) {
            for (std::size_t i = 0; i + level <= degree; ++i) {
                high[i * step] += fraction * (high[(i + 1) * step] - high[i * step]);
            }
            low[level * step] = high[0];
        }
    }
    return parts;
}

/// Sets a box around the poles, in the direction of the patch.
void PatchTree::set_box(Node& node) const {
    const std::size_t row = degree_[1] + 1;
    const std::size_t step[2] = {row, 1};
    Vec3 across[2] = {Vec3::Zero(), Vec3::Zero()};
    double length[2] = {0.0, 0.0};  // lengths of the polygons of poles: a patch may end where it begins
    for (std::size_t i = 0; i <= degree_[0]; ++i) {
        for (std::size_t k = 0; k <= degree_[1]; ++k) {
            for (std::size_t d = 0; d < 2; ++d) {
                if ((d == 0 ? i : k) < degree_[d]) {
                    const std::size_t at = i * row + k;
                    const Vec3 leg = in_space(node.net[at + step[d]]) - in_space(node.net[at]);
                    across[d] += leg / static_cast<double>(degree_[1 - d] + 1);
                    length[d] += leg.norm() / static_cast<double>(degree_[1 - d] + 1);
                }
            }
        }
    }
    node.longer = length[1] > length[0] ? 1 : 0;
    const Vec3 along = across[node.longer];
    Vec3 normal = along.cross(across[1 - node.longer]);
    if (!(normal.squaredNorm() > 0.0)) {
        normal = along.unitOrthogonal();
    }
    node.axes.setIdentity();
    if (along.squaredNorm() > 0.0) {
        node.axes.col(0) = along.normalized();
        node.axes.col(2) = normal.normalized();
        node.axes.col(1) = node.axes.col(2).cross(node.axes.col(0));
    }
    Eigen::AlignedBox3d box;
    for (const Homogeneous& pole : node.net) {
        box.extend(node.axes.transpose() * in_space(pole));
    }
    node.least = box.min();
    node.most = box.max();
    node.middle = node.axes * box.center();
    node.radius = 0.5 * box.diagonal().norm();
    set_reach(node);
}

double PatchTree::Node::square_distance(const Vec3& p) const {
    const Vec3 q = axes.transpose() * p;
    return (least - q).cwiseMax(q - most).cwiseMax(0.0).squaredNorm();
}

/// The poles of a derivative of the given order in each parameter. None where it is zero.
PatchTree::Net PatchTree::derived(Net net, const std::array<std::size_t, 2>& times) const {
    std::size_t degree[2] = {degree_[0], degree_[1]};
    for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t k = 0; k < times[d]; ++k) {
            if (degree[d] == 0) {
                return {};
            }
            const std::size_t row = degree[1] + 1;
            const std::size_t step = d == 0 ? row : 1;
            const auto factor = static_cast<double>(degree[d]--);
            Net next;
            for (std::size_t i = 0; i <= degree[0]; ++i) {
                for (std::size_t j = 0; j <= degree[1]; ++j) {
                    next.emplace_back(factor * (net[i * row + j + step] - net[i * row + j]));
                }
            }
            net = std::move(next);
        }
    }
    return net;
}

/// With r = S - p the second derivatives of r^2 / 2 are J^T J + r S''. They are positive definite where |r| times a
/// bound on S'' is below the square of the least stretch of J. From S = A / w and S_s = (A_s - S w_s) / w follow
/// bounds on the derivatives of S by the differences of the poles of A and w, with the origin in the patch.
void PatchTree::set_reach(Node& node) const {
    double light = kInfinity;
    double heavy = 0.0;
    for (const Homogeneous& pole : node.net) {
        light = std::min(light, pole[3]);
        heavy = std::max(heavy, pole[3]);
    }
    const double usual = 0.5 * (light + heavy);
    Net net = node.net;
    for (Homogeneous& pole : net) {
        pole.head<3>() -= pole[3] * node.middle;
        pole /= usual;
    }
    light /= usual;
    const double uneven = 1.0 - light;
    const std::size_t parameters = degree_[1] > 0 ? 2 : 1;
    Vec3 mean[2] = {Vec3::Zero(), Vec3::Zero()};
    double length[2];
    double error[2];      // largest deviation of the first derivatives from their mean
    double of_weight[2];  // largest first derivatives
    for (std::size_t d = 0; d < parameters; ++d) {
        const Net found = derived(net, {d == 0 ? 1U : 0U, d == 1 ? 1U : 0U});
        for (const Homogeneous& f : found) {
            mean[d] += f.head<3>() / static_cast<double>(found.size());
        }
        length[d] = mean[d].norm();
        double spread = 0.0;
        of_weight[d] = 0.0;
        for (const Homogeneous& f : found) {
            spread = std::max(spread, (f.head<3>() - mean[d]).norm());
            of_weight[d] = std::max(of_weight[d], std::abs(f[3]));
        }
        error[d] = (spread + node.radius * of_weight[d] + length[d] * uneven) / light;
        if (!(length[d] > 0.0)) {
            return;
        }
    }
    const auto second = [&](std::size_t a, std::size_t b) {
        double point = 0.0;
        double weight = 0.0;
        for (const Homogeneous& f : derived(net, {a == b ? 2U * (1U - a) : 1U, a == b ? 2U * a : 1U})) {
            point = std::max(point, f.head<3>().norm());
            weight = std::max(weight, std::abs(f[3]));
        }
        const double turning = (length[a] + error[a]) * of_weight[b] + (length[b] + error[b]) * of_weight[a];
        return (point + turning + node.radius * weight) / light / (length[a] * length[b]);
    };
    double stretch = 1.0 - error[0] / length[0];
    double bend = second(0, 0);
    if (parameters == 2) {
        const double aligned = std::abs(mean[0].dot(mean[1])) / (length[0] * length[1]);
        stretch = std::sqrt(std::max(0.0, 1.0 - aligned)) - std::hypot(error[0] / length[0], error[1] / length[1]);
        bend = std::hypot(bend, second(1, 1), std::sqrt(2.0) * second(0, 1));
    }
    if (stretch > 0.0) {
        node.reach = bend > 0.0 ? stretch * stretch / bend : kInfinity;
    }
}

void PatchTree::divide(std::size_t node) {
    const std::size_t along = nodes_[node].longer;
    std::array<Net, 2> parts = cut(nodes_[node].net, along, 0.5);
    const std::size_t child = nodes_.size();
    nodes_.resize(child + 2);
    Node& parent = nodes_[node];
    parent.child = child;
    parent.net = Net();
    const double middle = 0.5 * (parent.low[along] + parent.high[along]);
    for (std::size_t i = 0; i < 2; ++i) {
        Node& part = nodes_[child + i];
        part.net = std::move(parts[i]);
        part.low = parent.low;
        part.high = parent.high;
        (i == 0 ? part.high : part.low)[along] = middle;
        set_box(part);
    }
}

PatchTree::Jet PatchTree::at(const Net& net, const double (&s)[2]) const {
    std::array<Homogeneous, kMostPoles> of_row[3];  // value and derivatives along t
    std::array<Homogeneous, kMostPoles> poles;
    for (std::size_t i = 0; i <= degree_[0]; ++i) {
        std::copy_n(net.begin() + static_cast<std::ptrdiff_t>(i * (degree_[1] + 1)), degree_[1] + 1, poles.begin());
        const Row row = row_at(poles.data(), degree_[1], s[1]);
        of_row[0][i] = row.value;
        of_row[1][i] = row.first;
        of_row[2][i] = row.second;
    }
    const Row value = row_at(of_row[0].data(), degree_[0], s[0]);
    const Row first = row_at(of_row[1].data(), degree_[0], s[0]);
    const Row second = row_at(of_row[2].data(), degree_[0], s[0]);
    // S = A / w: the derivatives of A = S w by the product rule, solved for those of S.
    const double w = 1.0 / value.value[3];
    const double ws = value.first[3];
    const double wt = first.value[3];
    Jet j;
    j.point = value.value.head<3>() * w;
    j.first[0] = (value.first.head<3>() - j.point * ws) * w;
    j.first[1] = (first.value.head<3>() - j.point * wt) * w;
    j.second[0] = (value.second.head<3>() - 2.0 * ws * j.first[0] - value.second[3] * j.point) * w;
    j.second[1] = (first.first.head<3>() - wt * j.first[0] - ws * j.first[1] - first.first[3] * j.point) * w;
    j.second[2] = (second.value.head<3>() - 2.0 * wt * j.first[1] - second.value[3] * j.point) * w;
    return j;
}

/// One step towards the minimum of r^2 / 2, along the tangents where that is not convex. A parameter that stands at a
/// bound and would be driven out of it stays.
Vec2 PatchTree::step_from(const Jet& j, const Vec3& r, const Projection& projection, Vec2& gradient) {
    gradient = Vec2(r.dot(j.first[0]), r.dot(j.first[1]));
    Vec2 curvature(j.first[0].squaredNorm() + r.dot(j.second[0]), j.first[1].squaredNorm() + r.dot(j.second[2]));
    double mixed = j.first[0].dot(j.first[1]) + r.dot(j.second[1]);
    bool free[2];
    for (int d = 0; d < 2; ++d) {
        free[d] = j.first[d].squaredNorm() > 0.0 && !(projection.s[d] <= 0.0 && gradient[d] >= 0.0) &&
                  !(projection.s[d] >= 1.0 && gradient[d] <= 0.0);
    }
    const bool convex = free[0] && free[1] ? curvature[0] > 0.0 && curvature[0] * curvature[1] > mixed * mixed
                                           : curvature[free[0] ? 0 : 1] > 0.0;
    if (!convex) {
        curvature = Vec2(j.first[0].squaredNorm(), j.first[1].squaredNorm());
        mixed = 0.0;
    }
    if (free[0] && free[1]) {
        return Vec2(mixed * gradient[1] - curvature[1] * gradient[0],
                    mixed * gradient[0] - curvature[0] * gradient[1]) /
               (curvature[0] * curvature[1] - mixed * mixed);
    }
    return {free[0] ? -gradient[0] / curvature[0] : 0.0, free[1] ? -gradient[1] / curvature[1] : 0.0};
}

/// Newton's method within the patch.
PatchTree::Projection PatchTree::newton(const Net& net, const Vec3& p) const {
    constexpr int kNewtonSteps = 50;               // bounds the search: the step need not converge
    constexpr int kHalvings = 20;                  // the last trial is a millionth of the step
    constexpr double kLeastStep = 1e-14;           // as a fraction of the patch
    constexpr double kLeastGain = 1e-14;           // as a fraction of the squared distance
    constexpr double kCoordinateRounding = 1e-15;  // relative rounding error of coordinates
    const double rounding = kCoordinateRounding * kCoordinateRounding * p.squaredNorm();
    Projection projection{{0.5, degree_[1] > 0 ? 0.5 : 0.0}, 0.0};
    Jet j = at(net, projection.s);
    projection.square = (j.point - p).squaredNorm();
    for (int i = 0; i < kNewtonSteps; ++i) {
        Vec2 gradient;
        Vec2 move = step_from(j, j.point - p, projection, gradient);
        if (-gradient.dot(move) <= kLeastGain * projection.square + rounding) {
            return projection;
        }
        bool better = false;
        double moved = 0.0;
        for (int halving = 0; halving < kHalvings && !better; ++halving, move *= 0.5) {
            const double next[2] = {std::clamp(projection.s[0] + move[0], 0.0, 1.0),
                                    std::clamp(projection.s[1] + move[1], 0.0, 1.0)};
            moved = std::max(std::abs(next[0] - projection.s[0]), std::abs(next[1] - projection.s[1]));
            if (!(moved > kLeastStep)) {
                return projection;
            }
            const Jet there = at(net, next);
            const double square = (there.point - p).squaredNorm();
            better = square < projection.square;
            if (better) {
                projection = {{next[0], next[1]}, square};
                j = there;
            }
        }
        if (!better) {
            return projection;
        }
    }
    return projection;
}

bool PatchTree::settled(const Node& node, const Vec3& p, double square_of_box) const {
    return (p - node.middle).norm() + node.radius <= node.reach ||
           node.radius * node.radius <= kSmallBesideDistance * kSmallBesideDistance * square_of_box ||
           node.radius <= least_radius_;
}

double PatchTree::nearest(const Vec3& point, double square, const Counts& counts) {
    open_.clear();
    const auto further = [](const auto& a, const auto& b) { return a.first > b.first; };
    const auto open = [&](std::size_t node) {
        const double least = nodes_[node].square_distance(point);
        if (least < square) {
            open_.emplace_back(least, node);
            std::push_heap(open_.begin(), open_.end(), further);
        }
    };
    if (!nodes_.empty()) {
        open(0);
    }
    while (!open_.empty() && open_.front().first < square) {
        const auto [least, node] = open_.front();
        std::pop_heap(open_.begin(), open_.end(), further);
        open_.pop_back();
        if (nodes_[node].child == 0) {
            if (settled(nodes_[node], point, least)) {
                const Node& patch = nodes_[node];
                const Projection projection = newton(patch.net, point);
                if (projection.square < square &&
                    counts(patch.low[0] + projection.s[0] * (patch.high[0] - patch.low[0]),
                           patch.low[1] + projection.s[1] * (patch.high[1] - patch.low[1]))) {
                    square = projection.square;
                }
                continue;
            }
            divide(node);
        }
        open(nodes_[node].child);
        open(nodes_[node].child + 1);
    }
    return square;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/edge_sampler.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

// Largest distance between knots, in spacings: while curvatures are measured, and while arc lengths are integrated.
// Tuned on the corpus.
constexpr double kMeasured = 2.0;
constexpr double kSummed = 0.5;  // In spacings, while arc lengths are integrated. Tuned on the corpus.
constexpr int kMaxRounds = 24;   // Bounds the halvings of the interval between two knots. Tuned on the corpus.
// Fraction of a spacing by which the number of pieces may be rounded down to a whole number. Tuned on the corpus.
constexpr double kStretch = 0.25;

}  // namespace

EdgeSampler::EdgeSampler(geometry::Session& session, const EdgeDiscretisation& chains, const SpacingBounds& bounds,
                         SpacingField& field)
    : session_(session), bounds_(bounds), field_(field) {
    const int edges = static_cast<int>(session.topology().edges.size());
    knots_.resize(edges);
    for (int e = 0; e < edges; ++e) {
        if (!chains.chain(e).collapsed) {
            knots_[e] = evaluate(e, chains.chain(e).t);
            measure_spacing(e, knots_[e]);
        }
    }
    for (int round = 0; round < kMaxRounds && halve(too_long(kMeasured), false); ++round) {
    }
    for (int e = 0; e < edges; ++e) {
        limit_by_length(e);
        for (const Knot& knot : knots_[e]) {
            field_.add(knot.point, knot.spacing);
        }
    }
}

EdgeSampler::Knots EdgeSampler::evaluate(int edge, const std::vector<double>& parameters) {
    Engine::Batch batch;
    for (const double t : parameters) {
        batch.push_back(Query::edge_point(edge, t));
    }
    Knots knots;
    for (const Answer& a : session_.ask(std::move(batch))) {
        if (a.found()) {
            knots.push_back({parameters[knots.size()], a.point, a.normal, bounds_.most});
        }
    }
    return knots.size() == parameters.size() ? knots : Knots{};
}

// Measures the curvature of the edge itself, from neighbouring knots, and of all faces that use it.
void EdgeSampler::measure_spacing(int edge, Knots& knots) {
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double length = (knots[i + 1].point - knots[i].point).norm();
        const double angle = angle_between(knots[i].tangent, knots[i + 1].tangent);
        const double spacing = length > 0.0 ? spacing_for(angle / length, bounds_) : bounds_.most;
        knots[i].spacing = std::min(knots[i].spacing, spacing);
        knots[i + 1].spacing = std::min(knots[i + 1].spacing, spacing);
    }
    const geometry::Topology& topology = session_.topology();
    for (const int u : topology.edges[edge].uses) {
        Engine::Batch places;
        for (const Knot& knot : knots) {
            places.push_back(Query::use_on_face(u, knot.t));
        }
        Engine::Batch batch;
        for (const Answer& a : session_.ask(std::move(places))) {
            batch.push_back(Query::face_curvatures(topology.uses[u].face, a.u, a.v));
        }
        const Engine::Answers answers = session_.ask(std::move(batch));
        for (std::size_t i = 0; i < knots.size(); ++i) {
            if (answers[i].status == geometry::Status::Ok) {
                knots[i].spacing = std::min(knots[i].spacing, spacing_for(answers[i].u, bounds_));
            }
        }
    }
}

std::vector<EdgeSampler::Interval> EdgeSampler::too_long(double share) const {
    std::vector<Interval> found;
    for (int e = 0; e < static_cast<int>(knots_.size()); ++e) {
        for (std::size_t i = 0; i + 1 < knots_[e].size(); ++i) {
            const Knot& a = knots_[e][i];
            const Knot& b = knots_[e][i + 1];
            if ((b.point - a.point).norm() > share * std::min(a.spacing, b.spacing)) {
                found.push_back({e, i});
            }
        }
    }
    return found;
}

// Inserts a knot in the middle of every interval by arc length, with the spacing of the field or a newly measured one.
bool EdgeSampler::halve(const std::vector<Interval>& intervals, bool by_field) {
    Engine::Batch batch;
    for (const Interval& interval : intervals) {
        const Knots& knots = knots_[interval.edge];
        batch.push_back(Query::edge_middle(interval.edge, knots[interval.index].t, knots[interval.index + 1].t));
    }
    const Engine::Answers answers = session_.ask(std::move(batch));
    bool any = false;
    for (std::size_t i = 0; i < intervals.size();) {
        const int edge = intervals[i].edge;
        Knots& knots = knots_[edge];
        std::vector<double> middles;
        for (; i < intervals.size() && intervals[i].edge == edge; ++i) {
            const double low = knots[intervals[i].index].t;
            const double high = knots[intervals[i].index + 1].t;
            if (answers[i].found() && answers[i].t > low && answers[i].t < high) {
                middles.push_back(answers[i].t);
            }
        }
        Knots fresh = evaluate(edge, middles);
        any = any || !fresh.empty();
        for (Knot& knot : fresh) {
            knot.spacing = by_field ? field_.at(knot.point, bounds_.most) : bounds_.most;
        }
        knots.insert(knots.end(), fresh.begin(), fresh.end());
        std::sort(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.t < b.t; });
        if (!by_field) {
            measure_spacing(edge, knots);
        }
    }
    return any;
}

// Beside an edge shorter than the spacing, only triangles of its size can have good angles.
void EdgeSampler::limit_by_length(int edge) {
    Knots& knots = knots_[edge];
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        length += (knots[i + 1].point - knots[i].point).norm();
    }
    for (Knot& knot : knots) {
        knot.spacing = std::max(bounds_.least, std::min(knot.spacing, length));
    }
}

void EdgeSampler::resample(EdgeDiscretisation& chains) {
    for (Knots& knots : knots_) {
        for (Knot& knot : knots) {
            knot.spacing = field_.at(knot.point, bounds_.most);
        }
    }
    for (int round = 0; round < kMaxRounds && halve(too_long(kSummed), true); ++round) {
    }
    for (int e = 0; e < static_cast<int>(knots_.size()); ++e) {
        if (knots_[e].size() >= 2) {
            const auto& nodes = session_.topology().edges[e].nodes;
            chains.resample(session_, e, iso_metric(knots_[e], nodes[0] == nodes[1] ? 3 : 1));
        }
    }
}

// Returns parameters at equal fractions of the integral of ds / spacing.
std::vector<double> EdgeSampler::iso_metric(const Knots& knots, int least_pieces) const {
    std::vector<double> sum{0.0};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double length = (knots[i + 1].point - knots[i].point).norm();
        sum.push_back(sum.back() + 0.5 * length * (1.0 / knots[i].spacing + 1.0 / knots[i + 1].spacing));
    }
    const int pieces = std::max(least_pieces, static_cast<int>(std::ceil(sum.back() - kStretch)));
    std::vector<double> inner;
    std::size_t i = 0;
    for (int k = 1; k < pieces; ++k) {
        const double wanted = sum.back() * k / pieces;
        while (i + 2 < knots.size() && sum[i + 1] < wanted) {
            ++i;
        }
        const double part = (wanted - sum[i]) / std::max(sum[i + 1] - sum[i], 1e-300);
        inner.push_back(knots[i].t + std::clamp(part, 0.0, 1.0) * (knots[i + 1].t - knots[i].t));
    }
    return inner;
}

}  // namespace mq::triangulate

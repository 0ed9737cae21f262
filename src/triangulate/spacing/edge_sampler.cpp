// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/edge_sampler.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/spacing/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

}  // namespace

EdgeSampler::EdgeSampler(geometry::Session& session, const EdgeDiscretisation& chains, const SpacingBounds& bounds,
                         SpacingField& field)
    : session_(session), bounds_(bounds), field_(field) {
    const int edges = static_cast<int>(session.topology().edges.size());
    samples_.resize(edges);
    for (int e = 0; e < edges; ++e) {
        if (!chains.chain(e).collapsed) {
            samples_[e] = evaluate(e, chains.chain(e).t);
            measure_spacing(e, samples_[e]);
        }
    }
    for (int round = 0; round < SpacingTuning::kMaxEdgeRounds && halve(too_long(SpacingTuning::kEdgeMeasured), false);
         ++round) {
    }
    for (int e = 0; e < edges; ++e) {
        limit_by_length(e);
        for (const EdgeSample& sample : samples_[e]) {
            field_.add(sample.point, sample.spacing);
        }
    }
}

EdgeSampler::EdgeSamples EdgeSampler::evaluate(int edge, const std::vector<double>& parameters) {
    Engine::Batch batch;
    for (const double t : parameters) {
        batch.push_back(Query::edge_point(edge, t));
    }
    EdgeSamples samples;
    for (const Answer& a : session_.ask(std::move(batch))) {
        if (a.found()) {
            samples.push_back({parameters[samples.size()], a.point, a.normal, bounds_.most});
        }
    }
    return samples.size() == parameters.size() ? samples : EdgeSamples{};
}

// Measures the curvature of the edge itself, from neighbouring samples, and of all faces that use it.
void EdgeSampler::measure_spacing(int edge, EdgeSamples& samples) {
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double length = (samples[i + 1].point - samples[i].point).norm();
        const double angle = angle_between(samples[i].tangent, samples[i + 1].tangent);
        const double spacing = length > 0.0 ? spacing_for(angle / length, bounds_) : bounds_.most;
        samples[i].spacing = std::min(samples[i].spacing, spacing);
        samples[i + 1].spacing = std::min(samples[i + 1].spacing, spacing);
    }
    const geometry::Topology& topology = session_.topology();
    for (const int u : topology.edges[edge].uses) {
        Engine::Batch places;
        for (const EdgeSample& sample : samples) {
            places.push_back(Query::use_on_face(u, sample.t));
        }
        Engine::Batch batch;
        for (const Answer& a : session_.ask(std::move(places))) {
            batch.push_back(Query::face_curvatures(topology.uses[u].face, a.u, a.v));
        }
        const Engine::Answers answers = session_.ask(std::move(batch));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (answers[i].status == geometry::Status::Ok) {
                samples[i].spacing = std::min(samples[i].spacing, spacing_for(answers[i].u, bounds_));
            }
        }
    }
}

std::vector<EdgeSampler::Interval> EdgeSampler::too_long(double share) const {
    std::vector<Interval> found;
    for (int e = 0; e < static_cast<int>(samples_.size()); ++e) {
        for (std::size_t i = 0; i + 1 < samples_[e].size(); ++i) {
            const EdgeSample& a = samples_[e][i];
            const EdgeSample& b = samples_[e][i + 1];
            if ((b.point - a.point).norm() > share * std::min(a.spacing, b.spacing)) {
                found.push_back({e, i});
            }
        }
    }
    return found;
}

// Inserts a sample in the middle of every interval by arc length, with the spacing of the field or a newly measured
// one.
bool EdgeSampler::halve(const std::vector<Interval>& intervals, bool by_field) {
    Engine::Batch batch;
    for (const Interval& interval : intervals) {
        const EdgeSamples& samples = samples_[interval.edge];
        batch.push_back(Query::edge_middle(interval.edge, samples[interval.index].t, samples[interval.index + 1].t));
    }
    const Engine::Answers answers = session_.ask(std::move(batch));
    bool any = false;
    for (std::size_t i = 0; i < intervals.size();) {
        const int edge = intervals[i].edge;
        EdgeSamples& samples = samples_[edge];
        std::vector<double> middles;
        for (; i < intervals.size() && intervals[i].edge == edge; ++i) {
            const double low = samples[intervals[i].index].t;
            const double high = samples[intervals[i].index + 1].t;
            if (answers[i].found() && answers[i].t > low && answers[i].t < high) {
                middles.push_back(answers[i].t);
            }
        }
        EdgeSamples fresh = evaluate(edge, middles);
        any = any || !fresh.empty();
        for (EdgeSample& sample : fresh) {
            sample.spacing = by_field ? field_.at(sample.point, bounds_.most) : bounds_.most;
        }
        samples.insert(samples.end(), fresh.begin(), fresh.end());
        std::sort(samples.begin(), samples.end(), [](const EdgeSample& a, const EdgeSample& b) { return a.t < b.t; });
        if (!by_field) {
            measure_spacing(edge, samples);
        }
    }
    return any;
}

// Beside an edge shorter than the spacing, only triangles of its size can have good angles.
void EdgeSampler::limit_by_length(int edge) {
    EdgeSamples& samples = samples_[edge];
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        length += (samples[i + 1].point - samples[i].point).norm();
    }
    for (EdgeSample& sample : samples) {
        sample.spacing = std::max(bounds_.least, std::min(sample.spacing, length));
    }
}

void EdgeSampler::resample(EdgeDiscretisation& chains) {
    for (EdgeSamples& samples : samples_) {
        for (EdgeSample& sample : samples) {
            sample.spacing = field_.at(sample.point, bounds_.most);
        }
    }
    for (int round = 0; round < SpacingTuning::kMaxEdgeRounds && halve(too_long(SpacingTuning::kEdgeSummed), true);
         ++round) {
    }
    for (int e = 0; e < static_cast<int>(samples_.size()); ++e) {
        if (samples_[e].size() >= 2) {
            const auto& nodes = session_.topology().edges[e].nodes;
            chains.resample(session_, e, iso_metric(samples_[e], nodes[0] == nodes[1] ? 3 : 1));
        }
    }
}

// Returns parameters at equal fractions of the integral of ds / spacing.
std::vector<double> EdgeSampler::iso_metric(const EdgeSamples& samples, int least_pieces) const {
    std::vector<double> sum{0.0};
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double length = (samples[i + 1].point - samples[i].point).norm();
        sum.push_back(sum.back() + 0.5 * length * (1.0 / samples[i].spacing + 1.0 / samples[i + 1].spacing));
    }
    const int pieces = std::max(least_pieces, static_cast<int>(std::ceil(sum.back() - SpacingTuning::kStretch)));
    std::vector<double> inner;
    std::size_t i = 0;
    for (int k = 1; k < pieces; ++k) {
        const double wanted = sum.back() * k / pieces;
        while (i + 2 < samples.size() && sum[i + 1] < wanted) {
            ++i;
        }
        const double part = (wanted - sum[i]) / std::max(sum[i + 1] - sum[i], 1e-300);
        inner.push_back(samples[i].t + std::clamp(part, 0.0, 1.0) * (samples[i + 1].t - samples[i].t));
    }
    return inner;
}

}  // namespace mq::triangulate

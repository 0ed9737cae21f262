// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/cad_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mq::geometry {

namespace {

// Points in each span of a curve: the least number that tells an undulation in one span from a straight line.
constexpr int kInCurve = 3;
constexpr int kInSurface = 2;  // points in each span of a surface along each parameter, up to cubics
/// Degree above which a span gets as many points as its degree.
constexpr int kCubic = 3;
// Points of a face in one direction at most, for 2 MB and 40 ms; surfaces with more spans are sampled more coarsely.
constexpr std::size_t kMostParameters = 256;

// `in_each` parameters in each span, ascending.
std::vector<double> parameters_in(const KnotSpans& spans, int in_each) {
    std::vector<double> parameters;
    for (std::size_t i = 1; i < spans.bounds.size(); ++i) {
        for (int k = 0; k < in_each; ++k) {
            const double part = (k + 0.5) / in_each;
            parameters.push_back((1.0 - part) * spans.bounds[i - 1] + part * spans.bounds[i]);
        }
    }
    return parameters;
}

// Drops parameters evenly if there are too many.
std::vector<double> thinned(std::vector<double> parameters) {
    if (parameters.size() <= kMostParameters) {
        return parameters;
    }
    std::vector<double> fewer;
    for (std::size_t i = 0; i < kMostParameters; ++i) {
        fewer.push_back(parameters[i * parameters.size() / kMostParameters]);
    }
    return fewer;
}

// The lengths of a face along u and v, mm: of curves from side to side, the longest of five.
std::array<double, 2> lengths_of(Session& session, int face, const std::array<KnotSpans, 2>& spans) {
    // Curves measured in each direction.
    constexpr int kPlaces = 5;
    const auto at = [&](int direction, int i) {
        const std::vector<double>& bounds = spans[static_cast<std::size_t>(direction)].bounds;
        return bounds.front() + (i + 0.5) / kPlaces * (bounds.back() - bounds.front());
    };
    Engine::Batch batch;
    for (int i = 0; i < kPlaces; ++i) {
        for (int k = 0; k < kPlaces; ++k) {
            batch.push_back(Query::face_point(face, at(0, i), at(1, k)));
        }
    }
    const Engine::Answers answers = session.ask(std::move(batch));
    std::array<double, 2> longest{0.0, 0.0};
    for (int i = 0; i < kPlaces; ++i) {
        std::array<double, 2> length{0.0, 0.0};
        for (int k = 1; k < kPlaces; ++k) {
            const auto add = [&](std::size_t direction, int from, int to) {
                if (answers[from].found() && answers[to].found()) {
                    length[direction] += (answers[to].point - answers[from].point).norm();
                }
            };
            add(0, kPlaces * (k - 1) + i, kPlaces * k + i);
            add(1, kPlaces * i + k - 1, kPlaces * i + k);
        }
        for (std::size_t direction = 0; direction < 2; ++direction) {
            longest[direction] = std::max(longest[direction], length[direction]);
        }
    }
    return longest;
}

}  // namespace

std::vector<std::optional<Vec3>> CadSamples::points_of(Engine::Batch batch) {
    std::vector<std::optional<Vec3>> points;
    points.reserve(batch.size());
    for (const Answer& answer : session_.ask(std::move(batch))) {
        points.push_back(answer.found() ? std::optional<Vec3>(answer.point - grid_.origin()) : std::nullopt);
    }
    return points;
}

const CadSamples::OfEdge& CadSamples::of_edge(int edge) {
    if (const auto known = edges_.find(edge); known != edges_.end()) {
        return known->second;
    }
    OfEdge& result = edges_[edge];
    const KnotSpans& spans = session_.topology().edges[static_cast<std::size_t>(edge)].spans;
    result.t = parameters_in(spans, std::max(kInCurve, spans.degree));
    Engine::Batch batch;
    for (const double t : result.t) {
        batch.push_back(Query::edge_point(edge, t));
    }
    result.points = points_of(std::move(batch));
    return result;
}

const CadSamples::OfFace& CadSamples::of_face(int face) {
    if (const auto known = faces_.find(face); known != faces_.end()) {
        return known->second;
    }
    OfFace& result = faces_[face];
    const std::array<KnotSpans, 2>& spans = session_.topology().faces[static_cast<std::size_t>(face)].spans;
    const std::array<double, 2> lengths = lengths_of(session_, face, spans);
    std::array<double, 2> steps{};
    std::array<int, 2> in_each{};
    for (std::size_t k = 0; k < 2; ++k) {
        in_each[k] = spans[k].degree > kCubic ? spans[k].degree : kInSurface;
        steps[k] = lengths[k] / (in_each[k] * static_cast<double>(spans[k].bounds.size() - 1));
    }
    for (std::size_t k = 0; k < 2; ++k) {
        // Triangles are about as long as wide: points that lie farther apart in one direction would miss them.
        const double finer = steps[1 - k] > 0.0 ? std::ceil(0.5 * steps[k] / steps[1 - k]) : 1.0;
        in_each[k] *= static_cast<int>(std::clamp(finer, 1.0, static_cast<double>(kMostParameters)));
        result.uv[k] = thinned(parameters_in(spans[k], in_each[k]));
    }
    Engine::Batch batch;
    for (const double u : result.uv[0]) {
        for (const double v : result.uv[1]) {
            batch.push_back(Query::face_point(face, u, v));
        }
    }
    result.points = points_of(std::move(batch));
    return result;
}

void CadSamples::between(int edge, double from, double to, const std::function<void(const Vec3&)>& see) {
    const OfEdge& known = of_edge(edge);
    const auto first = std::upper_bound(known.t.begin(), known.t.end(), std::min(from, to)) - known.t.begin();
    const auto last = std::lower_bound(known.t.begin(), known.t.end(), std::max(from, to)) - known.t.begin();
    for (auto i = static_cast<std::size_t>(first); static_cast<std::ptrdiff_t>(i) < last; ++i) {
        if (known.points[i]) {
            see(*known.points[i]);
        }
    }
}

void CadSamples::inside(int face, const std::array<Vec2, 3>& uv, const std::function<void(const Vec3&)>& see) {
    if (!has_spans(face)) {
        return;
    }
    const OfFace& known = of_face(face);
    const auto [low, high] = std::minmax({uv[0].x(), uv[1].x(), uv[2].x()});
    const auto first = std::lower_bound(known.uv[0].begin(), known.uv[0].end(), low) - known.uv[0].begin();
    for (auto i = static_cast<std::size_t>(first); i < known.uv[0].size() && known.uv[0][i] <= high; ++i) {
        const double u = known.uv[0][i];
        double from = std::numeric_limits<double>::infinity();
        double to = -from;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2& a = uv[k];
            const Vec2& b = uv[(k + 1) % 3];
            if (a.x() == b.x() || (u - a.x()) * (u - b.x()) > 0.0) {
                continue;
            }
            const double part = (u - a.x()) / (b.x() - a.x());
            const double v = (1.0 - part) * a.y() + part * b.y();
            from = std::min(from, v);
            to = std::max(to, v);
        }
        const auto lowest = std::lower_bound(known.uv[1].begin(), known.uv[1].end(), from) - known.uv[1].begin();
        for (auto k = static_cast<std::size_t>(lowest); k < known.uv[1].size() && known.uv[1][k] <= to; ++k) {
            if (const auto& p = known.points[i * known.uv[1].size() + k]) {
                see(*p);
            }
        }
    }
}

}  // namespace mq::geometry

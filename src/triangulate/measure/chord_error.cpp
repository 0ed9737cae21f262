// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/chord_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "triangulate/measure/backward_distance.h"
#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/measure/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Answerer;
using geometry::Query;
using geometry::Session;

// Fractions of a segment's length at which a curve is measured beside its farthest point.
constexpr std::initializer_list<double> kBesideCurve{-0.15, 0.15};
constexpr std::initializer_list<double> kBesideClose{-0.05, 0.05};  // if its distance is close to the tolerance

void include(Distance& result, double distance, const Vec3& point, bool avoidable) {
    if (distance >= result.distance) {
        result.distance = distance;
        result.point = point;
        result.recalled = false;
    }
    if (avoidable) {
        result.avoidable = std::max(result.avoidable, distance);
    }
}

// Adds the answer about a point of a piece to its distance. `unavoidable`: distance in mm between the point and the CAD
// model that no mesh can avoid.
void include_answer(Distance& result, const Answer& answer, const Vec3& point, double unavoidable, double tolerance) {
    if (answer.found()) {
        include(result, answer.distance, point, answer.distance - unavoidable > MeasureTuning::kAvoidable * tolerance);
    }
}

bool close(const Distance& measured, double tolerance) {
    return measured.distance > MeasureTuning::kClose * tolerance && measured.distance <= tolerance;
}

// Interpolates between ends that deviate from the face by a and b, mm. If both are below the tolerance, no deviation
// is unavoidable.
double unavoidable(double a, double b, double at, double tolerance) {
    return std::max(a, b) > tolerance ? (1.0 - at) * a + at * b : 0.0;
}

Vec3 between(const Vec3& a, const Vec3& b, double at) {
    return (1.0 - at) * a + at * b;
}

// Returns the fraction of the distance from one end to the other at which the largest distance was measured.
double part_of_the_way(const Vec3& from, const Vec3& to, const Distance& measured) {
    const Vec3 along = to - from;
    return measured.recalled ? 0.5 : (measured.point - from).dot(along) / along.squaredNorm();
}

}  // namespace

const ChordErrorCache::Known& ChordErrorCache::known(int half_edge) const {
    static const Known kNothing;
    const auto number = static_cast<std::size_t>(work_.mesh.number_of(half_edge));
    return number < known_.size() ? known_[number] : kNothing;
}

// Needs room for all edges in known_.
void ChordErrorCache::keep(int half_edge, double tolerance, const Distance& distance) {
    Known& known = known_[static_cast<std::size_t>(work_.mesh.number_of(half_edge))];
    known.tolerance = static_cast<float>(tolerance);
    known.distance = static_cast<float>(distance.distance);
    known.avoidable = static_cast<float>(distance.avoidable);
}

ChordErrorCache::Measured ChordErrorCache::measured(int half_edge) const {
    const int s = work_.mesh.segment_of(half_edge);
    const Known& k = known(s >= 0 ? half_edge_of(s) : half_edge);
    Measured result{k.tolerance, k.distance, k.avoidable, k.height, {}};
    const auto found = offsets_.find(ends_key(half_edge));
    if (s >= 0 && found != offsets_.end()) {
        result.offset = found->second;
    }
    return result;
}

void ChordErrorCache::set_measured(int half_edge, const Measured& measured) {
    const int s = work_.mesh.segment_of(half_edge);
    known_.resize(static_cast<std::size_t>(work_.mesh.number_count()));
    known_[static_cast<std::size_t>(work_.mesh.number_of(s >= 0 ? half_edge_of(s) : half_edge))] = {
        measured.tolerance, measured.distance, measured.avoidable, measured.height};
    if (s >= 0 && measured.tolerance >= 0.0F) {
        offsets_[ends_key(half_edge)] = measured.offset;
    }
}

void ChordErrorCache::adopt(const ChordErrorCache& other, int first) {
    for (int h = 0; h < other.work_.mesh.half_edge_count(); ++h) {
        set_measured(first + h, other.measured(h));
    }
}

void ChordErrorCache::renumber(const NewIndices& renewed) {
    move_to_indices(renewed.sites, site_offsets_, -1.0);
    move_to_indices(renewed.edges, known_, {});
    KeyMap<Offset> moved;
    for (const auto& [ends, offset] : offsets_) {
        const int a = renewed.vertices[ends >> 32];
        const int b = renewed.vertices[ends & 0xFFFFFFFFU];
        if (a >= 0 && b >= 0) {
            moved[pair_key(a, b)] = offset;
        }
    }
    offsets_ = std::move(moved);
}

std::uint64_t ChordErrorCache::ends_key(int half_edge) const {
    return pair_key(work_.mesh.vertex_of(half_edge), work_.mesh.vertex_of(ClassifiedMesh::next(half_edge)));
}

void ChordErrorCache::forget(int half_edge) {
    const int s = work_.mesh.segment_of(half_edge);
    const auto number = static_cast<std::size_t>(work_.mesh.number_of(s >= 0 ? half_edge_of(s) : half_edge));
    if (number < known_.size()) {
        known_[number] = {};
    }
}

std::vector<Distance> ChordErrorCache::of_segments(const std::vector<int>& segments, double tolerance) {
    std::vector<Distance> results(segments.size());
    const ClassifiedMesh& mesh = work_.mesh;
    // Returns the offset of the point at a fraction of the segment's length from the curve.
    const auto measure = [&](Answerer& answerer, std::size_t i, double at) {
        const ClassifiedMesh::Segment& s = mesh.segment(segments[i]);
        const Vec3 p = between(mesh.vertex(s.vertices[0]).point, mesh.vertex(s.vertices[1]).point, at);
        const double guess = (1.0 - at) * s.t[0] + at * s.t[1];
        const Answer foot = answerer.answer(Query::edge_nearest(s.edge, work_.grid.to_shape(p), guess, s.t[0], s.t[1]));
        include_answer(results[i], foot, p, 0.0, tolerance);
        const Vec3 way = foot.found() ? Vec3(work_.grid.to_shape(p) - foot.point) : Vec3::Zero();
        return Offset{way.x(), way.y(), way.z()};
    };
    std::vector<std::optional<Offset>> ways(segments.size());
    work_.session.for_chunks(segments.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (!recall(half_edge_of(segments[i]), results[i])) {
                ways[i] = measure(answerer, i, 0.5);
            }
        }
    });
    std::vector<std::size_t> unsettled;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const ClassifiedMesh::Segment& s = mesh.segment(segments[i]);
        if (ways[i]) {
            offsets_[pair_key(s.vertices[0], s.vertices[1])] = *ways[i];
        }
        if (!settled(half_edge_of(segments[i]), tolerance) && results[i].distance <= tolerance) {
            const BackwardDistance back = backward_distance(work_, s.edge, {mesh.vertex(s.vertices[0]).point, s.t[0]},
                                                            {mesh.vertex(s.vertices[1]).point, s.t[1]});
            include(results[i], back.distance, back.nearest, back.distance > MeasureTuning::kAvoidable * tolerance);
            unsettled.push_back(i);
        }
    }
    // Measures pieces whose distance is close to the tolerance but does not exceed it.
    const auto measure_beside = [&](Answerer& answerer, std::size_t i, double near,
                                    const std::initializer_list<double>& places) {
        if (results[i].distance > tolerance || results[i].distance <= near * tolerance) {
            return;
        }
        const auto& v = mesh.segment(segments[i]).vertices;
        const double farthest = part_of_the_way(mesh.vertex(v[0]).point, mesh.vertex(v[1]).point, results[i]);
        for (const double aside : places) {
            measure(answerer, i, std::clamp(farthest + aside, 0.0, 1.0));
        }
    };
    work_.session.for_chunks(unsettled.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k) {
            measure_beside(answerer, unsettled[k], MeasureTuning::kWorthAskingCurve, kBesideCurve);
            measure_beside(answerer, unsettled[k], MeasureTuning::kClose, kBesideClose);
        }
    });
    known_.resize(static_cast<std::size_t>(work_.mesh.number_count()));
    for (std::size_t i = 0; i < segments.size(); ++i) {
        keep(half_edge_of(segments[i]), tolerance, results[i]);
    }
    return results;
}

std::vector<Distance> ChordErrorCache::of_edges(const std::vector<int>& half_edges, double tolerance) {
    std::vector<Distance> results(half_edges.size());
    known_.resize(static_cast<std::size_t>(work_.mesh.number_count()));
    measure_sites(half_edges);
    std::vector<std::vector<SurfaceProjection>> far((half_edges.size() + Session::kChunk - 1) / Session::kChunk);
    work_.session.for_chunks(half_edges.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (auto foot = measure_edge(answerer, half_edges[i], tolerance, results[i])) {
                far[from / Session::kChunk].push_back({i, std::move(*foot)});
            }
            keep(half_edges[i], tolerance, results[i]);
        }
    });
    projections_.clear();
    for (const std::vector<SurfaceProjection>& of_chunk : far) {
        projections_.insert(projections_.end(), of_chunk.begin(), of_chunk.end());
    }
    return results;
}

// Changes what is known of this edge only: several threads may measure different ones.
// @return the projection of its middle, if it was queried and exceeds the tolerance
std::optional<Answer> ChordErrorCache::measure_edge(Answerer& answerer, int half_edge, double tolerance,
                                                    Distance& result) {
    const ClassifiedMesh& mesh = work_.mesh;
    const int next = ClassifiedMesh::next(half_edge);
    const Vec3& a = mesh.point_of(half_edge);
    const Vec3& b = mesh.point_of(next);
    const auto measure = [&](double at) {
        const Vec3 p = between(a, b, at);
        const Vec2 uv = (1.0 - at) * mesh.site(mesh.site_of(half_edge)).uv + at * mesh.site(mesh.site_of(next)).uv;
        Answer foot =
            answerer.answer(Query::face_nearest(mesh.face_of(half_edge / 3), work_.grid.to_shape(p), uv.x(), uv.y()));
        include_answer(result, foot, p, unavoidable(offset(half_edge), offset(next), at, tolerance), tolerance);
        return foot;
    };
    std::optional<Answer> far;
    if (!recall(half_edge, result)) {
        Answer foot = measure(0.5);
        keep_height(half_edge, between(a, b, 0.5), foot);
        if (foot.found() && foot.distance > tolerance) {
            far = std::move(foot);
        }
    }
    if (settled(half_edge, tolerance)) {
        return far;
    }
    const EdgePeak peak = edge_peak(mesh, half_edge);
    if (peak.at != 0.5 && peak.height > MeasureTuning::kWorthAsking * tolerance) {
        measure(peak.at);
    }
    if (close(result, tolerance)) {
        const double farthest = part_of_the_way(a, b, result);
        measure(farthest - MeasureTuning::kAside);
        measure(farthest + MeasureTuning::kAside);
    }
    return far;
}

// Stores the signed height of an edge's middle over its surface.
void ChordErrorCache::keep_height(int half_edge, const Vec3& middle, const Answer& foot) {
    const double side = (work_.grid.to_shape(middle) - foot.point).dot(foot.normal);
    known_[static_cast<std::size_t>(work_.mesh.number_of(half_edge))].height =
        foot.found() ? static_cast<float>(std::copysign(foot.distance, side)) : 0.0F;
}

// Whether everything has been measured for this tolerance.
bool ChordErrorCache::settled(int half_edge, double tolerance) const {
    return known(half_edge).tolerance == static_cast<float>(tolerance);
}

// @return whether any measurement of the edge is stored.
bool ChordErrorCache::recall(int half_edge, Distance& result) const {
    const Known& before = known(half_edge);
    if (before.tolerance < 0.0F) {
        return false;
    }
    result.distance = static_cast<double>(before.distance);
    result.avoidable = static_cast<double>(before.avoidable);
    result.recalled = true;
    return true;
}

// Measures the deviation of both ends of half-edges from the surface. Vertices inside faces are on their surface.
void ChordErrorCache::measure_sites(const std::vector<int>& half_edges) {
    constexpr double kAsked = -2.0;  // Marks sites in the present batch; other negative values mean not measured.
    const ClassifiedMesh& mesh = work_.mesh;
    site_offsets_.resize(mesh.site_count(), -1.0);
    geometry::Engine::Batch batch;
    std::vector<int> sites;
    for (const int half_edge : half_edges) {
        for (const int h : {half_edge, ClassifiedMesh::next(half_edge)}) {
            const int site = mesh.site_of(h);
            if (site_offsets_[site] != -1.0) {
                continue;
            }
            if (mesh.vertex(mesh.vertex_of(h)).entity[0] == 2) {
                site_offsets_[site] = 0.0;
            } else {
                site_offsets_[site] = kAsked;
                sites.push_back(site);
                const Vec2& uv = mesh.site(site).uv;
                batch.push_back(Query::face_point(mesh.face_of(h / 3), uv.x(), uv.y()));
            }
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Vec3 p = work_.grid.to_shape(mesh.vertex(mesh.site(sites[i]).vertex).point);
        site_offsets_[sites[i]] = answers[i].found() ? (answers[i].point - p).norm() : 0.0;
    }
}

double ChordErrorCache::height(int half_edge) const {
    if (work_.mesh.segment_of(half_edge) < 0) {
        return static_cast<double>(known(half_edge).height);
    }
    const auto found = offsets_.find(ends_key(half_edge));
    if (found == offsets_.end()) {
        return 0.0;
    }
    const Vec3& a = work_.mesh.site(work_.mesh.site_of(half_edge)).normal;
    const Vec3& b = work_.mesh.site(work_.mesh.site_of(ClassifiedMesh::next(half_edge))).normal;
    const Offset& way = found->second;
    return Vec3(way[0], way[1], way[2]).dot((a + b).normalized());
}

// Returns the heights of the surface over the sides of a triangle.
TriangleHeights ChordErrorCache::heights(int first_half_edge) const {
    const ClassifiedMesh& mesh = work_.mesh;
    TriangleHeights result;
    for (int k = 0; k < 3; ++k) {
        const int h = first_half_edge + k;
        result.middles[k] = -height(h);
        result.skews[k] = side_skew(mesh.site(mesh.site_of(h)), mesh.site(mesh.site_of(ClassifiedMesh::next(h))));
    }
    return result;
}

std::vector<Distance> ChordErrorCache::of_triangles(const std::vector<int>& triangles, double tolerance) {
    constexpr int kWorthAThread = 1024;  // Triangles whose sample points take about half a millisecond.
    std::vector<Distance> results(triangles.size());
    std::vector<int> sides;
    for (const int t : triangles) {
        sides.insert(sides.end(), {3 * t, 3 * t + 1});
    }
    measure_sites(sides);
    work_.session.for_chunks(triangles.size(), [&](Answerer& answerer, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            measure_triangle(answerer, triangles[i], tolerance, results[i]);
        }
    });
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (results[i].distance <= tolerance) {
            work_.span_points.compute_on_face(work_.mesh.face_of(triangles[i]));
        }
    }
    for_chunks(static_cast<int>(triangles.size()), kWorthAThread, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        if (results[i].distance <= tolerance) {
            measure_backward(triangles[i], tolerance, results[i]);
        }
    });
    return results;
}

// Changes nothing else: several threads may measure triangles.
void ChordErrorCache::measure_triangle(Answerer& answerer, int triangle, double tolerance, Distance& result) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const int h = 3 * triangle;
    const auto measure = [&](const std::array<double, 3>& weights) {
        Vec3 p = Vec3::Zero();
        Vec2 uv = Vec2::Zero();
        double unavoidable = 0.0;
        double farthest = 0.0;
        for (int k = 0; k < 3; ++k) {
            p += weights[k] * mesh.point_of(h + k);
            uv += weights[k] * mesh.site(mesh.site_of(h + k)).uv;
            unavoidable += weights[k] * offset(h + k);
            farthest = std::max(farthest, offset(h + k));
        }
        const Answer foot =
            answerer.answer(Query::face_nearest(mesh.face_of(triangle), work_.grid.to_shape(p), uv.x(), uv.y()));
        include_answer(result, foot, p, farthest > tolerance ? unavoidable : 0.0, tolerance);
    };
    const TriangleHeights over = heights(h);
    if (!(over.bound() > MeasureTuning::kWorthAsking * tolerance)) {
        return;
    }
    const TrianglePeak peak = triangle_peak(over);
    if (!(peak.height > MeasureTuning::kWorthAsking * tolerance)) {
        return;
    }
    measure(peak.weights);
    if (!close(result, tolerance)) {
        return;
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
        std::array<double, 3> weights = peak.weights;
        for (double& w : weights) {
            w *= 1.0 - MeasureTuning::kAsideOfPeak;
        }
        weights[corner] += MeasureTuning::kAsideOfPeak;
        measure(weights);
    }
}

void ChordErrorCache::measure_backward(int triangle, double tolerance, Distance& result) {
    for_each_cad_sample_over(work_, triangle, [&](const CadSampleOverTriangle& p) {
        double unavoidable = 0.0;
        double farthest = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double off = std::max(0.0, offset(3 * p.triangle + k));
            unavoidable += p.weights[k] * off;
            farthest = std::max(farthest, off);
        }
        unavoidable = farthest > tolerance ? unavoidable : 0.0;
        include(result, p.distance, p.below, p.distance - unavoidable > MeasureTuning::kAvoidable * tolerance);
    });
}

}  // namespace mq::triangulate

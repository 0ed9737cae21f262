// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/chord_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "triangulate/measure/backward_distance.h"
#include "triangulate/measure/deviation_estimate.h"
#include "triangulate/measure/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;
using geometry::Session;

// Fractions of a segment's length at which a curve is measured beside its farthest point.
constexpr std::initializer_list<double> kBesideCurve{-0.15, 0.15};
constexpr std::initializer_list<double> kBesideClose{-0.05, 0.05};  // The same where it is close to the tolerance.

void take_into(Distance& result, double distance, const Vec3& point, bool avoidable) {
    if (distance >= result.distance) {
        result.distance = distance;
        result.point = point;
        result.recalled = false;
    }
    if (avoidable) {
        result.avoidable = std::max(result.avoidable, distance);
    }
}

// Collects closest-point queries, each for one of the measured pieces, into batches.
class ProjectionBatch {
  public:
    ProjectionBatch(Workspace& work, std::vector<Distance>& results, double tolerance)
        : work_(work), results_(results), tolerance_(tolerance) {}

    // `unavoidable`: distance in mm between the point and the CAD model that no mesh can avoid.
    void add(std::size_t piece, const Vec3& point, Query query, double unavoidable = 0.0) {
        if (batch_.empty()) {
            batch_.reserve(std::min(kFull + 8, results_.size() - piece));
        }
        batch_.push_back(query);
        asked_.push_back({piece, point, unavoidable});
    }
    bool full() const { return batch_.size() >= kFull; }

    // Passes every answer to `see(piece, point, answer)` after adding it to the results.
    template <typename See>
    void ask(See see) {
        const geometry::Engine::Answers answers = work_.session.ask(std::move(batch_));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            Distance& result = results_[asked_[i].piece];
            if (answers[i].found()) {
                take_into(result, answers[i].distance, asked_[i].point,
                          answers[i].distance - asked_[i].unavoidable > MeasureTuning::kAvoidable * tolerance_);
            }
            see(asked_[i].piece, asked_[i].point, answers[i]);
        }
        batch_.clear();
        asked_.clear();
        work_.progress.check();
    }

  private:
    // A piece may add a few more queries, and the batch still fits the caches.
    static constexpr std::size_t kFull = Session::kPiece - 8;
    struct Asked {
        std::size_t piece;
        Vec3 point;
        double unavoidable;
    };
    Workspace& work_;
    std::vector<Distance>& results_;
    double tolerance_;
    geometry::Engine::Batch batch_;
    std::vector<Asked> asked_;
};

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

void ChordErrorCache::keep(int half_edge, double tolerance, const Distance& distance) {
    known_.resize(static_cast<std::size_t>(work_.mesh.number_count()));
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

void ChordErrorCache::take(int half_edge, const Measured& measured) {
    const int s = work_.mesh.segment_of(half_edge);
    known_.resize(static_cast<std::size_t>(work_.mesh.number_count()));
    known_[static_cast<std::size_t>(work_.mesh.number_of(s >= 0 ? half_edge_of(s) : half_edge))] = {
        measured.tolerance, measured.distance, measured.avoidable, measured.height};
    if (s >= 0 && measured.tolerance >= 0.0F) {
        offsets_[ends_key(half_edge)] = measured.offset;
    }
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
    ProjectionBatch questions(work_, results, tolerance);
    const auto add = [&](std::size_t i, double at) {
        const ClassifiedMesh::Segment& s = mesh.segment(segments[i]);
        const Vec3 p = between(mesh.vertex(s.vertices[0]).point, mesh.vertex(s.vertices[1]).point, at);
        const double guess = (1.0 - at) * s.t[0] + at * s.t[1];
        questions.add(i, p, Query::edge_nearest(s.edge, work_.grid.to_part(p), guess, s.t[0], s.t[1]));
    };
    const auto remember = [&](std::size_t i, const Vec3& p, const Answer& foot) {
        const auto& v = mesh.segment(segments[i]).vertices;
        const Vec3 way = foot.found() ? Vec3(work_.grid.to_part(p) - foot.point) : Vec3::Zero();
        offsets_[pair_key(v[0], v[1])] = {way.x(), way.y(), way.z()};
    };
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!recall(half_edge_of(segments[i]), results[i])) {
            add(i, 0.5);
        }
        if (questions.full()) {
            questions.ask(remember);
        }
    }
    questions.ask(remember);
    // Measures pieces whose distance is close to the tolerance but does not exceed it.
    const auto add_beside = [&](std::size_t i, double near, const std::initializer_list<double>& places) {
        if (settled(half_edge_of(segments[i]), tolerance) || results[i].distance > tolerance ||
            results[i].distance <= near * tolerance) {
            return;
        }
        const auto& v = mesh.segment(segments[i]).vertices;
        const double farthest = part_of_the_way(mesh.vertex(v[0]).point, mesh.vertex(v[1]).point, results[i]);
        for (const double aside : places) {
            add(i, std::clamp(farthest + aside, 0.0, 1.0));
        }
    };
    const auto ignore = [](std::size_t, const Vec3&, const Answer&) {};
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!settled(half_edge_of(segments[i]), tolerance) && results[i].distance <= tolerance) {
            const ClassifiedMesh::Segment& s = mesh.segment(segments[i]);
            const BackwardDistance back = backward_distance(work_, s.edge, {mesh.vertex(s.vertices[0]).point, s.t[0]},
                                                            {mesh.vertex(s.vertices[1]).point, s.t[1]});
            take_into(results[i], back.distance, back.nearest, back.distance > MeasureTuning::kAvoidable * tolerance);
        }
        add_beside(i, MeasureTuning::kWorthAskingCurve, kBesideCurve);
    }
    questions.ask(ignore);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        add_beside(i, MeasureTuning::kClose, kBesideClose);
    }
    questions.ask(ignore);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        keep(half_edge_of(segments[i]), tolerance, results[i]);
    }
    return results;
}

std::vector<Distance> ChordErrorCache::of_edges(const std::vector<int>& half_edges, double tolerance) {
    std::vector<Distance> results(half_edges.size());
    const ClassifiedMesh& mesh = work_.mesh;
    known_.resize(static_cast<std::size_t>(mesh.number_count()));
    ProjectionBatch questions(work_, results, tolerance);
    std::vector<char> middle_seen(half_edges.size(), 0);
    const auto add = [&](std::size_t i, double at) {
        const int h = half_edges[i];
        const int next = ClassifiedMesh::next(h);
        const Vec3 p = between(mesh.point_of(h), mesh.point_of(next), at);
        const Vec2 uv = (1.0 - at) * mesh.site(mesh.site_of(h)).uv + at * mesh.site(mesh.site_of(next)).uv;
        questions.add(i, p, Query::face_nearest(mesh.face_of(h / 3), work_.grid.to_part(p), uv.x(), uv.y()),
                      unavoidable(offset(h), offset(next), at, tolerance));
    };
    const auto remember = [&](std::size_t i, const Vec3& p, const Answer& foot) {
        if (middle_seen[i] == 0) {
            middle_seen[i] = 1;
            keep_height(half_edges[i], p, foot);
            if (foot.found() && foot.distance > tolerance) {
                feet_.push_back({i, foot});
            }
        }
    };
    feet_.clear();
    measure_sites(half_edges);
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
        if (recall(half_edges[i], results[i])) {
            middle_seen[i] = 1;
        } else {
            add(i, 0.5);
        }
        if (settled(half_edges[i], tolerance)) {
            continue;
        }
        const EdgePeak peak = edge_peak(mesh, half_edges[i]);
        if (peak.at != 0.5 && peak.height > MeasureTuning::kWorthAsking * tolerance) {
            add(i, peak.at);
        }
        if (questions.full()) {
            questions.ask(remember);
        }
    }
    questions.ask(remember);
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
        if (!settled(half_edges[i], tolerance) && close(results[i], tolerance)) {
            const int h = half_edges[i];
            const double farthest = part_of_the_way(mesh.point_of(h), mesh.point_of(mesh.next(h)), results[i]);
            add(i, farthest - MeasureTuning::kAside);
            add(i, farthest + MeasureTuning::kAside);
        }
        if (questions.full()) {
            questions.ask(remember);
        }
    }
    questions.ask(remember);
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
        keep(half_edges[i], tolerance, results[i]);
    }
    return results;
}

// Stores the signed height of an edge's middle over its surface.
void ChordErrorCache::keep_height(int half_edge, const Vec3& middle, const Answer& foot) {
    const double side = (work_.grid.to_part(middle) - foot.point).dot(foot.normal);
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
        const Vec3 p = work_.grid.to_part(mesh.vertex(mesh.site(sites[i]).vertex).point);
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
    std::vector<Distance> results(triangles.size());
    const ClassifiedMesh& mesh = work_.mesh;
    ProjectionBatch questions(work_, results, tolerance);
    const auto ignore = [](std::size_t, const Vec3&, const Answer&) {};
    std::vector<int> sides;
    for (const int t : triangles) {
        sides.insert(sides.end(), {3 * t, 3 * t + 1});
    }
    measure_sites(sides);
    std::vector<TrianglePeak> peaks;
    const auto add = [&](std::size_t i, const std::array<double, 3>& weights) {
        const int h = 3 * triangles[i];
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
        questions.add(i, p, Query::face_nearest(mesh.face_of(h / 3), work_.grid.to_part(p), uv.x(), uv.y()),
                      farthest > tolerance ? unavoidable : 0.0);
        if (questions.full()) {
            questions.ask(ignore);
        }
    };
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const int h = 3 * triangles[i];
        const TriangleHeights over = heights(h);
        peaks.push_back(over.bound() > MeasureTuning::kWorthAsking * tolerance ? triangle_peak(over) : TrianglePeak{});
        if (peaks[i].height > MeasureTuning::kWorthAsking * tolerance) {
            add(i, peaks[i].weights);
        }
    }
    questions.ask(ignore);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!close(results[i], tolerance)) {
            continue;
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::array<double, 3> weights = peaks[i].weights;
            for (double& w : weights) {
                w *= 1.0 - MeasureTuning::kAsideOfPeak;
            }
            weights[corner] += MeasureTuning::kAsideOfPeak;
            add(i, weights);
        }
    }
    questions.ask(ignore);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (results[i].distance <= tolerance) {
            see_way_back(triangles[i], tolerance, results[i]);
        }
    }
    return results;
}

void ChordErrorCache::see_way_back(int triangle, double tolerance, Distance& result) {
    for_each_cad_sample_over(work_, triangle, [&](const CadSampleOverTriangle& p) {
        double unavoidable = 0.0;
        double farthest = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double off = std::max(0.0, offset(3 * p.triangle + k));
            unavoidable += p.weights[k] * off;
            farthest = std::max(farthest, off);
        }
        unavoidable = farthest > tolerance ? unavoidable : 0.0;
        take_into(result, p.distance, p.below, p.distance - unavoidable > MeasureTuning::kAvoidable * tolerance);
    });
}

}  // namespace mq::triangulate

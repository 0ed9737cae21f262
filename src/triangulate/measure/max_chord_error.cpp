// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/max_chord_error.h"

#include <algorithm>
#include <limits>

#include "triangulate/measure/distance_probes.h"
#include "triangulate/measure/projection.h"

namespace mq::triangulate {

namespace {

// Cached distances have single precision: those above this fraction of the largest one are measured again.
constexpr double kSinglePrecision = 1.0 - 1e-6;

// Pieces measured at a time: the results for all would be larger than the mesh.
constexpr std::size_t kMeasuredAtOnce = 8192;

struct Pieces {
    std::vector<int> segments;
    std::vector<int> sides;  // first half-edges of the segments
    LargeVector<int> edges;
    LargeVector<int> triangles;
};

// Calls `see` for blocks of pieces.
template <typename See>
void in_blocks(const LargeVector<int>& pieces, const See& see) {
    for (std::size_t from = 0; from < pieces.size(); from += kMeasuredAtOnce) {
        const int* const first = pieces.data() + from;
        see(std::vector<int>(first, first + std::min(kMeasuredAtOnce, pieces.size() - from)));
    }
}

// Collects all pieces except those that are measured from several faces.
Pieces pieces_of(const Workspace& work) {
    const ClassifiedMesh& mesh = work.mesh;
    const auto spanning = [&](int t) { return work.spanning.count(t) > 0; };
    Pieces pieces;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        if (!mesh.segment(s).uses.empty()) {
            pieces.segments.push_back(s);
            pieces.sides.push_back(mesh.segment(s).uses.front().half_edge);
        }
    }
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int other = mesh.twin(h);
        // Both sides of a removed smooth edge have their own sites; edges between two spanning triangles are measured
        // with these.
        if (other > h && !(spanning(h / 3) && spanning(other / 3))) {
            pieces.edges.push_back(spanning(h / 3) ? other : h);
        }
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (!spanning(t)) {
            pieces.triangles.push_back(t);
        }
    }
    return pieces;
}

// Returns the largest distance of the triangles in `work.spanning` from the faces near them.
MaxChordError max_distance_of_spanning(Workspace& work) {
    MaxChordError worst;
    const ClassifiedMesh& mesh = work.mesh;
    for (const auto& [triangle, span] : work.spanning) {
        const Vec3& a = mesh.point_of(3 * triangle);
        const Vec3& b = mesh.point_of(3 * triangle + 1);
        const Vec3& c = mesh.point_of(3 * triangle + 2);
        std::vector<Vec3> points;
        sample_triangle(a, b, c, points);
        sample_edge(a, b, points);
        sample_edge(b, c, points);
        sample_edge(c, a, points);
        const std::vector<SurfaceProjection> feet = project_onto(work, points, span.sheets);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (feet[i].found() && (worst.triangle < 0 || feet[i].distance > worst.distance)) {
                worst = {feet[i].distance, triangle, work.grid.to_shape(points[i])};
            }
        }
    }
    return worst;
}

// Tracks the largest of the distances passed to it.
class Farthest {
  public:
    Farthest(Workspace& work, ChordErrorCache& measure)
        : work_(work), measure_(measure), worst_(max_distance_of_spanning(work)) {}

    const MaxChordError& worst() const { return worst_; }

    void see_triangles(const LargeVector<int>& all, double tolerance) {
        in_blocks(all, [&](const std::vector<int>& triangles) {
            const std::vector<Distance> distances = measure_.of_triangles(triangles, tolerance);
            for (std::size_t i = 0; i < distances.size(); ++i) {
                see(distances[i], triangles[i]);
            }
        });
    }

    void see_edges(const LargeVector<int>& all, double tolerance) {
        double largest = worst_.distance;
        std::vector<Recalled> recalled;
        in_blocks(all, [&](const std::vector<int>& edges) {
            see_all(edges, edges, measure_.of_edges(edges, tolerance), largest, recalled);
        });
        see_again(recalled, largest, [&](const std::vector<int>& far) { return measure_.of_edges(far, tolerance); });
    }

    void see_segments(const Pieces& pieces, double tolerance) {
        double largest = worst_.distance;
        std::vector<Recalled> recalled;
        see_all(pieces.segments, pieces.sides, measure_.of_segments(pieces.segments, tolerance), largest, recalled);
        see_again(recalled, largest, [&](const std::vector<int>& far) { return measure_.of_segments(far, tolerance); });
    }

  private:
    void see(const Distance& distance, int triangle) {
        if (worst_.triangle < 0 || distance.distance > worst_.distance) {
            worst_ = {distance.distance, triangle, work_.grid.to_shape(distance.point),
                      distance.avoidable < distance.distance};
        }
    }

    // A cached distance, which lacks its point.
    struct Recalled {
        double distance;
        int piece;
        int side;
    };

    // Passes the measured distances on, and keeps the cached distances that may be the largest.
    void see_all(const std::vector<int>& pieces, const std::vector<int>& sides, const std::vector<Distance>& distances,
                 double& largest, std::vector<Recalled>& recalled) {
        for (const Distance& distance : distances) {
            largest = std::max(largest, distance.distance);
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!distances[i].recalled) {
                see(distances[i], sides[i] / 3);
            } else if (distances[i].distance >= kSinglePrecision * largest) {
                recalled.push_back({distances[i].distance, pieces[i], sides[i]});
            }
        }
    }

    // Measures the largest of the cached distances again.
    template <typename Again>
    void see_again(const std::vector<Recalled>& recalled, double largest, const Again& again) {
        std::vector<int> far;
        std::vector<int> far_sides;
        for (const Recalled& piece : recalled) {
            if (piece.distance >= kSinglePrecision * largest) {
                far.push_back(piece.piece);
                far_sides.push_back(piece.side);
                measure_.forget(piece.side);
            }
        }
        const std::vector<Distance> once_more = again(far);
        for (std::size_t i = 0; i < far.size(); ++i) {
            see(once_more[i], far_sides[i] / 3);
        }
    }

    Workspace& work_;
    ChordErrorCache& measure_;
    MaxChordError worst_;
};

}  // namespace

MaxChordError measure_chord_height(Workspace& work, ChordErrorCache& measure, double asked) {
    const Pieces pieces = pieces_of(work);
    Farthest farthest(work, measure);
    if (!(asked > 0.0)) {  // without a tolerance, the largest distance at the middles selects where else to measure
        // No tolerance: only the middles are measured.
        constexpr double kMiddlesOnly = std::numeric_limits<double>::infinity();
        farthest.see_segments(pieces, kMiddlesOnly);
        farthest.see_edges(pieces.edges, kMiddlesOnly);
        asked = farthest.worst().distance;
    }
    farthest.see_segments(pieces, asked);
    farthest.see_edges(pieces.edges, asked);
    farthest.see_triangles(pieces.triangles, asked);
    return farthest.worst();
}

}  // namespace mq::triangulate

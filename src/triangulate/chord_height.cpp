// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/chord_height.h"

#include <algorithm>
#include <limits>

#include "triangulate/relics.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// Distances that were kept in single precision: those nearer to the largest than this are measured again.
constexpr double kSinglePrecision = 1.0 - 1e-6;

struct Pieces {
    std::vector<int> segments;
    std::vector<int> sides;  // of the segments: their first half-edges
    std::vector<int> edges;
    std::vector<int> triangles;
};

// All but those that are measured from several faces.
Pieces pieces_of(const Workspace& work) {
    const SurfaceMesh& mesh = work.mesh;
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
        // Along a released edge the sides have sites of their own; where both may lie on several faces, see above.
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

// The farthest of all that it is shown.
class Farthest {
  public:
    Farthest(Workspace& work, ChordMeasure& measure)
        : work_(work), measure_(measure), worst_(farthest_spanning(work)) {}

    const ChordHeight& worst() const { return worst_; }

    void see_triangles(const std::vector<int>& triangles, double tolerance) {
        const std::vector<Distance> distances = measure_.of_triangles(triangles, tolerance);
        for (std::size_t i = 0; i < distances.size(); ++i) {
            see(distances[i], triangles[i]);
        }
    }

    void see_edges(const std::vector<int>& edges, double tolerance) {
        see_all(edges, edges, measure_.of_edges(edges, tolerance),
                [&](const std::vector<int>& far) { return measure_.of_edges(far, tolerance); });
    }

    void see_segments(const Pieces& pieces, double tolerance) {
        see_all(pieces.segments, pieces.sides, measure_.of_segments(pieces.segments, tolerance),
                [&](const std::vector<int>& far) { return measure_.of_segments(far, tolerance); });
    }

  private:
    void see(const Distance& distance, int triangle) {
        if (worst_.triangle < 0 || distance.distance > worst_.distance) {
            worst_ = {distance.distance, triangle, work_.grid.to_part(distance.point),
                      distance.avoidable < distance.distance};
        }
    }

    // What was measured before is measured again where it may be the farthest, for its point.
    template <typename Again>
    void see_all(const std::vector<int>& pieces, const std::vector<int>& sides, const std::vector<Distance>& distances,
                 Again again) {
        double largest = worst_.distance;
        for (const Distance& distance : distances) {
            largest = std::max(largest, distance.distance);
        }
        std::vector<int> far;
        std::vector<int> far_sides;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!distances[i].recalled) {
                see(distances[i], sides[i] / 3);
            } else if (distances[i].distance >= kSinglePrecision * largest) {
                far.push_back(pieces[i]);
                far_sides.push_back(sides[i]);
                measure_.forget(sides[i]);
            }
        }
        const std::vector<Distance> once_more = again(far);
        for (std::size_t i = 0; i < far.size(); ++i) {
            see(once_more[i], far_sides[i] / 3);
        }
    }

    Workspace& work_;
    ChordMeasure& measure_;
    ChordHeight worst_;
};

}  // namespace

ChordHeight measure_chord_height(Workspace& work, ChordMeasure& measure, double asked) {
    const Pieces pieces = pieces_of(work);
    Farthest farthest(work, measure);
    if (!(asked > 0.0)) {  // then what the middles show says where else to look
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

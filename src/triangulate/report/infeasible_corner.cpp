// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/infeasible_corner.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/segment_distance.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

// Places on an edge where its innermost piece may end: four for each halving of its length.
constexpr int kPlaces = 48;
constexpr double kPlacesPerHalf = 4.0;  // Places for each halving; see above.
// Margin of the proof: an edge that turns by 10 degrees leaves slightly more than half a turn beside it.
constexpr double kProven = 1.25;

// Returns the largest ratio of lengths across half a turn: `n` triangles have equal angles at their common corner, the
// bound at the longer of the two sides there, and the remaining angle at the other.
double largest_step(double bound) {
    double largest = 1.0;
    for (int n = 1; n * bound <= M_PI; ++n) {
        largest = std::max(largest, std::pow(std::sin(bound + M_PI / n) / std::sin(bound), n));
    }
    return largest;
}

}  // namespace

std::optional<double> InfeasibleCorner::at(int vertex) {
    const auto known = found_.find(vertex);
    return known != found_.end() ? known->second : found_.emplace(vertex, find(vertex)).first->second;
}

std::optional<double> InfeasibleCorner::find(int vertex) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const auto way = [&](int segment, int end) {
        const ClassifiedMesh::Segment& s = mesh.segment(segment);
        return Way{s.edge, (s.t[1 - end] > s.t[end]) ? 0 : 1};
    };
    for (int s = 0; s < mesh.segment_count(); ++s) {
        for (int end = 0; end < 2; ++end) {
            if (mesh.segment(s).vertices[end] != vertex) {
                continue;
            }
            for (const NarrowCorner& corner : corners_at(mesh, s, end)) {
                const int other_end = mesh.segment(corner.segment).vertices[0] == vertex ? 0 : 1;
                if (corner.angle < bound_ &&
                    least_step(way(s, end), way(corner.segment, other_end)) > kProven * largest_step(bound_)) {
                    return corner.angle;
                }
            }
        }
    }
    return std::nullopt;
}

// Returns points on the edge from the far end to the node; none if a point is not found.
std::vector<Vec3> InfeasibleCorner::points_on(const Way& way) const {
    const geometry::Edge& edge = work_.session.topology().edges[static_cast<std::size_t>(way.edge)];
    const double from = way.end == 0 ? edge.t0 : edge.t1;
    const double to = way.end == 0 ? edge.t1 : edge.t0;
    geometry::Engine::Batch batch;
    for (int k = 0; k <= kPlaces; ++k) {
        batch.push_back(Query::edge_point(way.edge, from + (to - from) * std::exp2(-k / kPlacesPerHalf)));
    }
    batch.push_back(Query::edge_point(way.edge, from));
    std::vector<Vec3> points;
    for (const geometry::Answer& answer : work_.session.ask(std::move(batch))) {
        if (!answer.found()) {
            return {};
        }
        points.push_back(answer.point);
    }
    return points;
}

// Returns the least ratio of lengths, wherever the innermost piece ends except at the far end, which is another
// corner.
double InfeasibleCorner::least_step(const Way& way, const Way& other) const {
    const std::vector<Vec3> points = points_on(way);
    const std::vector<Vec3> beside = points_on(other);
    double least = 1e300;
    if (points.empty() || beside.empty()) {
        return 0.0;
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        double distance = 1e300;
        for (std::size_t k = 0; k + 1 < beside.size(); ++k) {
            distance = std::min(distance, distance_to_segment(points[i], beside[k], beside[k + 1]));
        }
        const double length = (points[i] - points.back()).norm();
        least = std::min(least, length * std::tan(bound_) / std::max(2.0 * distance, 1e-300) - 0.5);
    }
    return least;
}

}  // namespace mq::triangulate

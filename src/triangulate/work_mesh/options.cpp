// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/options.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace mq::triangulate {

namespace {

void check_length(const char* name, double value) {
    if (!std::isfinite(value) || value < 0.0) {
        throw InvalidInput(std::string(name) + " is " + std::to_string(value) +
                           ": it must be a number of at least 0 mm");
    }
}

// Length below which an edge is a detail, as a fraction of the shape's size, where neither a tolerance nor edge lengths
// are asked for.
constexpr double kDetailOfShape = 1e-5;

}  // namespace

double TriangulateOptions::chord_height_of(const Box& box) const {
    return chord_height > 0.0 ? chord_height : chord_height_relative * box.largest_side();
}

// The mesh of the paper keeps all edges.
double TriangulateOptions::detail_of(const Box& box) const {
    if (insertion == Insertion::Circumcentre) {
        return 0.0;
    }
    std::vector<double> asked{chord_height_of(box), max_edge};
    for (const LocalSize& size : local_sizes) {
        asked.push_back(size.max_edge);
    }
    asked.erase(std::remove(asked.begin(), asked.end(), 0.0), asked.end());
    if (asked.empty()) {
        return kDetailOfShape * box.largest_side();
    }
    return std::min(kLargestDetail * box.largest_side(),
                    kDetailOfWhatIsAsked * *std::min_element(asked.begin(), asked.end()));
}

void TriangulateOptions::validate() const {
    if (!(min_angle >= 0.0 && min_angle <= 34.0)) {
        throw InvalidInput("min_angle is " + std::to_string(min_angle) +
                           " degrees: it must be at least 0, which is no bound, and at most 34; 25 to 30 is usual");
    }
    check_length("chord_height", chord_height);
    check_length("chord_height_relative", chord_height_relative);
    check_length("max_edge", max_edge);
    check_length("min_edge", min_edge);
    if (!(edges_per_circle == 0.0 || (edges_per_circle >= 3.0 && std::isfinite(edges_per_circle)))) {
        throw InvalidInput("edges_per_circle is " + std::to_string(edges_per_circle) +
                           ": it must be at least 3, or 0 for no bound; 12 to 36 is usual");
    }
    if (!(growth == 0.0 || (growth > 1.0 && std::isfinite(growth)))) {
        throw InvalidInput("growth_rate is " + std::to_string(growth) +
                           ": it must be greater than 1, or 0 for no bound; 1.2 to 2 is usual");
    }
    if (chord_height > 0.0 && chord_height_relative > 0.0) {
        throw InvalidInput("chord_height and chord_height_relative are both given: choose one");
    }
    if (!(feature_angle > 0.0 && feature_angle <= 40.0)) {
        throw InvalidInput("feature_angle is " + std::to_string(feature_angle) +
                           " degrees: it must be above 0 and at most 40; 10 is usual");
    }
    if (keep_edges == KeepEdges::Feature && !keeps_bounds()) {
        throw InvalidInput("keep_edges = feature needs refinement: use the method refine, or refine_samples");
    }
    if (max_edge > 0.0 && min_edge > max_edge) {
        throw InvalidInput("min_edge is larger than max_edge");
    }
    if (threads < 0) {
        throw InvalidInput("threads is " + std::to_string(threads) + ": it must be at least 0");
    }
}

}  // namespace mq::triangulate

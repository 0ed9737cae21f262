// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/options.h"

#include <algorithm>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "option_ranges.h"

namespace mq::triangulate {

namespace {

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
    if (detail > 0.0) {
        return detail;
    }
    std::vector<double> asked{chord_height_of(box), max_edge};
    for (const LocalSize& size : local_sizes) {
        asked.push_back(size.max_edge);
    }
    if (size_field != nullptr) {
        asked.push_back(size_field->least_in(box));
    }
    asked.erase(std::remove(asked.begin(), asked.end(), 0.0), asked.end());
    if (asked.empty()) {
        return kDetailOfShape * box.largest_side();
    }
    return std::min(kLargestDetail * box.largest_side(),
                    kDetailOfWhatIsAsked * *std::min_element(asked.begin(), asked.end()));
}

geometry::CornerCuts TriangulateOptions::corner_cuts() const {
    if (corners == Corners::Auto) {
        return keeps_bounds() && min_angle > 0.0 ? geometry::CornerCuts::Infeasible : geometry::CornerCuts::None;
    }
    return corners == Corners::Cut ? geometry::CornerCuts::All : geometry::CornerCuts::None;
}

void TriangulateOptions::validate() const {
    using namespace ranges::triangulate;
    if (min_angle != 0.0) {  // no bound
        kMinAngle.require(min_angle);
    }
    kChordHeight.require(chord_height);
    kChordHeightRelative.require(chord_height_relative);
    kMaxEdge.require(max_edge);
    kMinEdge.require(min_edge);
    kEdgesPerCircle.require(edges_per_circle);
    kGrowthRate.require(growth);
    kFeatureAngle.require(feature_angle);
    kThreads.require(threads);
    if (chord_height > 0.0 && chord_height_relative > 0.0) {
        throw InvalidInput(phrases::kTwoBounds,
                           {{"length", in_mm(chord_height)}, {"number", in_digits(chord_height_relative, 4)}});
    }
    if (keep_edges == KeepEdges::Feature && !keeps_bounds()) {
        throw InvalidInput(phrases::kFeatureNeedsRefinement);
    }
    if (order == Order::WorstFirst && insertion != Insertion::Circumcentre) {
        throw InvalidInput(phrases::kOrderNeedsCircumcentre);
    }
    if (max_edge > 0.0 && min_edge > max_edge) {
        throw InvalidInput(phrases::kMinAboveMax, {{"length", in_mm(min_edge)}, {"length2", in_mm(max_edge)}});
    }
}

}  // namespace mq::triangulate

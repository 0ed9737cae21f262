// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/memory.h"

#include <algorithm>
#include <tuple>

namespace mq::triangulate {

namespace {

// A mesh that is so many times finer or coarser than asked for is a start as good as any.
constexpr double kMuchTheSame = 1.25;

// What a mesh is asked to be, without the chord height, which counts in mm, and the local sizes, which count by face.
auto demands(const Options& o) {
    return std::make_tuple(o.min_angle, o.max_edge, o.min_edge, o.edges_per_circle, o.growth, o.insertion, o.keep_edges,
                           o.feature_angle, o.method);
}

}  // namespace

bool Memory::serves(const Options& now, double chord_now, double resolution_now) const {
    return demands(options) == demands(now) && resolution_now <= resolution &&
           std::max(chord, chord_now) <= kMuchTheSame * std::min(chord, chord_now);
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/crossing_removal.h"

#include <utility>

#include "boolean/boolean.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {

void remove_crossings(UniformResult& result, double tolerance, Progress& progress) {
    if (mesh::verify(result.mesh.vertices, result.mesh.triangles, nullptr, 1, &progress).passed()) {
        return;
    }
    BooleanOptions options;
    options.tolerance = tolerance;
    options.oriented = true;
    BooleanResult sound = boolean({&result.mesh}, Expression::chain(Operation::Union, 1), options, &progress);
    std::vector<std::array<std::int32_t, 2>> source;
    source.reserve(sound.triangle_source.size());
    result.retained = 0;
    for (const auto& [operand, triangle] : sound.triangle_source) {
        source.push_back(operand < 0 ? std::array<std::int32_t, 2>{-1, -1}
                                     : result.triangle_source[static_cast<std::size_t>(triangle)]);
        result.retained += source.back()[0] >= 0 ? 1 : 0;
    }
    result.crossing_pairs = sound.crossing_pairs;
    result.mesh = std::move(sound.mesh);
    result.triangle_source = std::move(source);
    result.seconds.insert(result.seconds.end(), sound.seconds.begin(), sound.seconds.end());
}

}  // namespace mq::boolean

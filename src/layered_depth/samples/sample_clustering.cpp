// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/sample_clustering.h"

#include <utility>

namespace mq::layered_depth {

std::vector<std::uint32_t> count_samples(const OperandSet& pair, const std::vector<LayeredDepthSet>& operands) {
    std::vector<std::uint32_t> samples(pair.triangles.size(), 0);
    for (const LayeredDepthSet& operand : operands) {
        for (const LayeredDepthImage& direction : operand) {
            for (const std::int32_t code : direction.code) {
                ++samples[code < 0 ? ~code : code];
            }
        }
    }
    return samples;
}

std::vector<std::uint8_t> triangles_beyond(const OperandSet& pair, const SampleGrid& grid) {
    std::vector<std::uint8_t> point_beyond(pair.points.size());
    for (std::size_t p = 0; p < pair.points.size(); ++p) {
        const Vec3 g = grid.to_grid(pair.points[p]);
        point_beyond[p] = g.minCoeff() < 0.0 || g.maxCoeff() > grid.cells() ? 1 : 0;
    }
    std::vector<std::uint8_t> beyond(pair.triangles.size());
    for (std::size_t t = 0; t < beyond.size(); ++t) {
        const auto& [a, b, c] = pair.triangles[t];
        beyond[t] = point_beyond[a] | point_beyond[b] | point_beyond[c];
    }
    return beyond;
}

std::vector<std::int32_t> cluster(const OperandSet& pair, const std::vector<std::uint32_t>& samples,
                                  const std::vector<std::uint8_t>& beyond) {
    const auto count = static_cast<std::int32_t>(pair.triangles.size());
    std::vector<std::int32_t> region(count, -1);
    std::vector<std::int32_t> at_point(pair.points.size(), -1);
    std::vector<std::int32_t> missed;
    const auto label = [&](std::int32_t t) {
        for (const std::int32_t p : pair.triangles[t]) {
            if (at_point[p] < 0) {
                at_point[p] = region[t];
            }
        }
    };
    for (std::int32_t t = 0; t < count; ++t) {
        if (beyond[t] != 0) {
            continue;
        }
        if (samples[t] > 0) {
            region[t] = t;
            label(t);
        } else {
            missed.push_back(t);
        }
    }
    std::vector<std::int32_t> reached, rest;
    do {
        reached.clear();
        rest.clear();
        for (const std::int32_t t : missed) {
            for (const std::int32_t p : pair.triangles[t]) {
                if (at_point[p] >= 0) {
                    region[t] = at_point[p];
                    break;
                }
            }
            (region[t] >= 0 ? reached : rest).push_back(t);
        }
        for (const std::int32_t t : reached) {
            label(t);
        }
        std::swap(missed, rest);
    } while (!reached.empty());
    return region;
}

}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/triangle_retention.h"

namespace mq::layered_depth {

namespace {

/// Decides for each sampled triangle whether it is retained, by its own samples alone.
std::vector<Retention> fate_of_sampled(const std::vector<std::uint32_t>& samples, const CombinedSet& combined) {
    std::vector<std::array<std::uint32_t, 2>> kept(samples.size(), {0, 0});
    for (const CombinedDepth& direction : combined) {
        for (const std::int32_t source : direction.source) {
            ++kept[CombinedDepth::triangle(source)][CombinedDepth::reversed(source) ? 1 : 0];
        }
    }
    std::vector<Retention> fate(samples.size(), Retention::Removed);
    for (std::size_t t = 0; t < samples.size(); ++t) {
        if (samples[t] > 0 && kept[t][0] == samples[t]) {
            fate[t] = Retention::Kept;
        } else if (samples[t] > 0 && kept[t][1] == samples[t]) {
            fate[t] = Retention::KeptReversed;
        }
    }
    return fate;
}

}  // namespace

std::vector<Retention> classify(const OperandSet& pair, const std::vector<std::uint32_t>& samples,
                                const std::vector<std::int32_t>& region, const CombinedSet& combined) {
    const std::vector<Retention> own = fate_of_sampled(samples, combined);
    const auto fate_of_region = [&](std::size_t t) {
        const bool gone = region[t] < 0 || pair.is_gap(static_cast<std::int32_t>(t));
        return gone ? Retention::Removed : own[region[t]];
    };
    // Marks triangles without a decision. The border is widened by one ring: points between triangles with different
    // decisions belong to it.
    constexpr std::uint8_t kUnseen = 255;
    std::vector<std::uint8_t> at_point(pair.points.size(), kUnseen);
    for (std::size_t t = 0; t < pair.triangles.size(); ++t) {
        const Retention fate = fate_of_region(t);
        for (const std::int32_t p : pair.triangles[t]) {
            if (at_point[p] == kUnseen) {
                at_point[p] = static_cast<std::uint8_t>(fate);
            } else if (at_point[p] != static_cast<std::uint8_t>(fate)) {
                at_point[p] = static_cast<std::uint8_t>(Retention::Removed);
            }
        }
    }
    std::vector<std::uint8_t> ring(pair.triangles.size(), 0);
    for (std::size_t t = 0; t < pair.triangles.size(); ++t) {
        for (const std::int32_t p : pair.triangles[t]) {
            if (region[t] >= 0 && at_point[p] == static_cast<std::uint8_t>(Retention::Removed)) {
                ring[region[t]] = 1;
            }
        }
    }
    std::vector<Retention> fate(pair.triangles.size(), Retention::Removed);
    for (std::size_t t = 0; t < fate.size(); ++t) {
        if (region[t] >= 0 && ring[region[t]] == 0) {
            fate[t] = fate_of_region(t);
        }
    }
    return fate;
}

}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/filled_volume.h"

#include <array>
#include <optional>
#include <utility>

#include "base/error.h"

namespace mq::curve {

namespace {

/// Parts of the usual grading, one a filling.
constexpr std::array<double, 3> kGradingParts{1.0, 0.5, 0.2};

FilledVolume fill_once(Surface& surface, const geometry::Topology& topology, double grading_part, Progress& progress,
                       StageClock& clock) {
    progress.stage("filling", 0.5, 0.6);
    Volume volume = fill_solids(surface, topology, grading_part, progress);
    clock.end("filling");
    progress.stage("repairing the volume", 0.6, 0.95);
    const VolumeRepairs repairs = repair_volume(volume, progress);
    clock.end("repairing the volume");
    return {std::move(volume), repairs};
}

}  // namespace

FilledVolume fill_and_repair(Surface& surface, const geometry::Topology& topology, Progress& progress,
                             StageClock& clock) {
    const Surface bare = surface;
    std::optional<FilledVolume> best = fill_once(surface, topology, kGradingParts[0], progress, clock);
    Surface best_surface(surface.shapes.order());
    int fillings = 1;
    for (std::size_t i = 1; i < kGradingParts.size() && best->repairs.invalid_after > 0; ++i) {
        best_surface = std::exchange(surface, bare);
        ++fillings;
        std::optional<FilledVolume> next;
        try {
            next.emplace(fill_once(surface, topology, kGradingParts[i], progress, clock));
        } catch (const GeometryError&) {
            // There is a filling already, whose invalid elements the report names.
        }
        if (!next || next->repairs.invalid_after >= best->repairs.invalid_after) {
            surface = std::move(best_surface);
            break;
        }
        best.emplace(std::move(*next));
    }
    best->fillings = fillings;
    return std::move(*best);
}

}  // namespace mq::curve

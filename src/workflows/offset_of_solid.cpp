// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/offset_of_solid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "base/stopwatch.h"

namespace mq::workflows {

namespace {

std::string empty_offset(double distance) {
    std::array<char, 120> text;
    std::snprintf(text.data(), text.size(),
                  "the result is empty: no point of the solid is %.4g mm away from its surface", std::abs(distance));
    return text.data();
}

BooleanSurface reported(offset::OffsetResult&& found, const BooleanSurface& solid, const offset::OffsetOptions& options,
                        const WorkBefore& before, const Stopwatch& watch, Progress& progress) {
    BooleanSurface result;
    result.mesh = std::move(found.mesh);
    if (!solid.mesh.triangle_face.empty()) {
        for (const std::int32_t t : found.triangle_source) {
            result.mesh.triangle_face.push_back(solid.mesh.triangle_face[static_cast<std::size_t>(t)]);
        }
    }
    result.triangle_source.assign(result.mesh.triangles.size(), {-1, -1});
    BooleanReport& figures = result.figures;
    figures.error_bound = found.error_bound;
    figures.tolerance_asked = options.tolerance;
    figures.reconstructed = result.mesh.triangles.size();
    figures.self_intersections = 0;
    figures.seconds = std::move(found.seconds);
    complete_report(result, before, empty_offset(options.distance), progress);
    figures.cpu_seconds = before.cpu_seconds + watch.cpu();
    result.report = figures;
    return result;
}

}  // namespace

BooleanSurface offset_of_solid(const BooleanSurface& solid, const offset::OffsetOptions& options,
                               const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    return reported(offset::offset(solid.mesh, options, progress), solid, options, before, watch, progress);
}

BooleanSurface thickened_walls(const BooleanSurface& solid, const std::vector<char>& left_out,
                               const offset::OffsetOptions& options, const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    return reported(offset::thicken(solid.mesh, left_out, options, progress), solid, options, before, watch, progress);
}

}  // namespace mq::workflows

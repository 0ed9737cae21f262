// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/offset_of_solid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "offset/contoured/contoured_offset.h"
#include "offset/trimmed/opening_extension.h"

namespace mq::workflows {

namespace {

std::string empty_offset(double distance) {
    std::array<char, 120> text;
    std::snprintf(text.data(), text.size(),
                  "the result is empty: no point of the solid is %.4g mm away from its surface", std::abs(distance));
    return text.data();
}

BooleanSurface reported(boolean::OffsetResult&& found, const BooleanSurface& solid,
                        const boolean::OffsetOptions& options, const WorkBefore& before, const Stopwatch& watch,
                        Progress& progress) {
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
    figures.crossing_pairs = found.crossing_pairs;
    figures.self_intersections = 0;
    figures.seconds = std::move(found.seconds);
    complete_report(result, before, empty_offset(options.distance), progress);
    figures.cpu_seconds = before.cpu_seconds + watch.cpu();
    result.report = figures;
    return result;
}

/// The options with the normals of the solid's corners; triangles that were appended to the solid's own have none.
boolean::OffsetOptions by_normals_of(const BooleanSurface& solid, boolean::OffsetOptions options) {
    options.corner_normals = solid.corner_normals;
    if (!options.corner_normals.empty()) {
        options.corner_normals.resize(3 * solid.mesh.triangles.size(), Vec3::Zero());
    }
    return options;
}

/// Takes the trimmed raw offset if few of its triangles cross. Else it makes the contour of the distance, which takes
/// longer in general, but not for features smaller than the distance. If both miss the tolerance, or the contour fails,
/// the one with the smaller bound is taken.
template <typename Trimmed, typename Contoured>
boolean::OffsetResult first_within(const boolean::OffsetOptions& options, const Trimmed& trimmed,
                                   const Contoured& contoured) {
    const Stopwatch watch;
    std::optional<boolean::OffsetResult> first;
    try {
        first = trimmed(options);
        if (first->error_bound <= options.tolerance) {
            return std::move(*first);
        }
    } catch (const TopologyError&) {
        // The contour's answer on the same surface counts.
    }
    StageTimes seconds = first ? first->seconds : StageTimes{{"trimming the raw offset", watch.wall()}};
    boolean::OffsetResult second;
    try {
        second = contoured(options);
    } catch (const Error&) {
        if (!first) {
            throw;
        }
        return std::move(*first);  // its bound says that it misses the tolerance
    }
    seconds.insert(seconds.end(), second.seconds.begin(), second.seconds.end());
    if (first && first->error_bound <= second.error_bound) {
        second = std::move(*first);
    }
    second.seconds = std::move(seconds);
    return second;
}

}  // namespace

BooleanSurface offset_of_solid(const BooleanSurface& solid, const boolean::OffsetOptions& options,
                               const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    boolean::OffsetResult found = first_within(
        by_normals_of(solid, options),
        [&](const boolean::OffsetOptions& how) { return boolean::offset(solid.mesh, how, progress); },
        [&](const boolean::OffsetOptions& how) { return offset::contoured_offset(solid.mesh, how, progress); });
    return reported(std::move(found), solid, options, before, watch, progress);
}

std::optional<BooleanSurface> hollow_beyond_openings(const BooleanSurface& solid, const std::vector<char>& open,
                                                     const boolean::OffsetOptions& options, const WorkBefore& before,
                                                     Progress& progress) {
    options.validate();
    constexpr double kFlat = 0.1;  // fraction of the tolerance
    BooleanSurface extended;
    std::optional<mesh::TriangleMesh> mesh =
        boolean::extend_openings(solid.mesh, open, {options.distance, kFlat * options.tolerance});
    if (!mesh) {
        return std::nullopt;
    }
    extended.mesh = std::move(*mesh);
    extended.corner_normals = solid.corner_normals;
    boolean::OffsetOptions inward = options;
    inward.distance = -options.distance;
    inward.tolerance = (1.0 - kFlat) * options.tolerance;
    WorkBefore extending = before;
    extending.error_bound += kFlat * options.tolerance;
    return offset_of_solid(extended, inward, extending, progress);
}

BooleanSurface thickened_walls(const BooleanSurface& solid, const std::vector<char>& left_out,
                               const boolean::OffsetOptions& options, const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    boolean::OffsetResult found = first_within(
        by_normals_of(solid, options),
        [&](const boolean::OffsetOptions& how) { return boolean::thicken(solid.mesh, left_out, how, progress); },
        [&](const boolean::OffsetOptions& how) {
            return offset::contoured_walls(solid.mesh, left_out, how, progress);
        });
    return reported(std::move(found), solid, options, before, watch, progress);
}

}  // namespace mq::workflows

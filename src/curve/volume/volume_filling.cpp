// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/volume_filling.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/error.h"

namespace mq::curve {

namespace {

/// Factors of the usual grading, one for each filling.
constexpr std::array<double, 3> kGradingParts{1.0, 0.5, 0.2};

/// Whether other vertices inside can help: not where all invalid elements lie on folded triangles of the surface, which
/// fold any tetrahedron on them.
bool refilling_may_help(const FilledTetrahedralMesh& filled) {
    if (filled.repairs.invalid_after == 0) {
        return false;
    }
    const TetrahedralMesh& volume = filled.volume;
    const FoldedTriangles folded(volume.surface);
    return std::any_of(volume.tetrahedra.begin(), volume.tetrahedra.end(), [&](const Tetrahedron& t) {
        return t.alive && !(t.quality > 0.0) && !folded.has_face_of(t.corners);
    });
}

FilledTetrahedralMesh fill_once(CurvedSurface& surface, const geometry::Topology& topology, double grading_factor,
                                Progress& progress, StageClock& clock) {
    progress.stage("filling", 0.5, 0.6);
    TetrahedralMesh volume = fill_solids(surface, topology, grading_factor, progress);
    clock.end("filling");
    progress.stage("repairing the volume", 0.6, 0.95);
    const VolumeRepairs repairs = repair_volume(volume, progress);
    clock.end("repairing the volume");
    std::vector<std::string> notes;
    for (const std::string& solid : volume.filled_by_own_mesher) {
        notes.push_back("filled by our own mesher, as Netgen failed: " + solid);
    }
    return {std::move(volume), repairs, 1, std::move(notes)};
}

}  // namespace

FilledTetrahedralMesh best_filling(CurvedSurface& surface, const Filler& filler) {
    const CurvedSurface bare = surface;
    std::optional<FilledTetrahedralMesh> best = filler(surface, kGradingParts[0]);
    CurvedSurface best_surface(surface.shapes.order());
    int fillings = 1;
    std::string failure;
    for (std::size_t i = 1; i < kGradingParts.size() && refilling_may_help(*best); ++i) {
        best_surface = std::exchange(surface, bare);
        ++fillings;
        std::optional<FilledTetrahedralMesh> next;
        try {
            next.emplace(filler(surface, kGradingParts[i]));
        } catch (const GeometryError& error) {
            failure = error.what();
        }
        if (!next || next->repairs.invalid_after >= best->repairs.invalid_after) {
            surface = std::move(best_surface);
            break;
        }
        best.emplace(std::move(*next));
    }
    best->fillings = fillings;
    if (fillings > 1) {
        best->notes.push_back("elements stayed invalid: the solids were filled " + std::to_string(fillings) +
                              " times, with ever more vertices inside, and the best is kept" +
                              (failure.empty() ? "" : "; the last filling failed: " + failure));
    }
    return std::move(*best);
}

FilledTetrahedralMesh fill_and_repair(CurvedSurface& surface, const geometry::Topology& topology, Progress& progress,
                                      StageClock& clock) {
    return best_filling(surface, [&](CurvedSurface& bare, double grading_factor) {
        return fill_once(bare, topology, grading_factor, progress, clock);
    });
}

}  // namespace mq::curve

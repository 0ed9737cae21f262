// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/remeshing/volume_filling.h"

#include <optional>
#include <utility>

#include "curve/volume/remeshing/local_remeshing.h"

namespace mq::curve {

FilledTetrahedralMesh fill_and_repair(CurvedSurface& surface, const geometry::Topology& topology, Progress& progress,
                                      StageClock& clock) {
    progress.stage("filling", 0.5, 0.6);
    std::optional<TetrahedralMesh> volume(fill_solids(surface, topology, progress));
    std::vector<std::string> notes;
    for (const std::string& solid : volume->filled_by_own_mesher) {
        notes.push_back("filled by our own mesher, as Netgen failed: " + solid);
    }
    clock.end("filling");
    progress.stage("repairing the volume", 0.6, 0.95);
    VolumeRepairs repairs = repair_volume(*volume, progress);
    clock.end("repairing the volume");
    LocalRemeshing remeshing;
    remesh_and_repair(volume, surface, RepairScope::Poor, remeshing, progress);
    repairs.cavities = static_cast<int>(remeshing.cavities);
    repairs.invalid_after = static_cast<int>(volume->invalid());
    clock.end("remeshing around invalid elements");
    return {*std::move(volume), repairs, std::move(notes)};
}

}  // namespace mq::curve

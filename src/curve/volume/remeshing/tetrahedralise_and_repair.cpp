// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/remeshing/tetrahedralise_and_repair.h"

#include <optional>
#include <utility>

#include "curve/surface/node_placement.h"
#include "curve/volume/remeshing/local_remeshing.h"

namespace mq::curve {

RepairedTetrahedralMesh tetrahedralise_and_repair(geometry::Session& session, CurvedSurface& surface,
                                                  Progress& progress, StageTimer& clock, const SizeField* field) {
    progress.stage("filling", 0.5, 0.6);
    std::optional<elements::CurvedShapes> quadratic;
    if (surface.shapes.order() != 2) {
        quadratic = edges_of_second_order(session, surface);
    }
    std::optional<TetrahedralMesh> volume(
        tetrahedralise_solids(surface, quadratic ? *quadratic : surface.shapes, session.topology(), progress, field));
    clock.end("filling");
    progress.stage("repairing the volume", 0.6, 0.95);
    VolumeRepairs repairs = repair_volume(*volume, progress);
    clock.end("repairing the volume");
    LocalRemeshing remeshing;
    remesh_and_repair(volume, surface, RepairScope::Poor, remeshing, progress);
    repairs.cavities = static_cast<int>(remeshing.cavities);
    repairs.invalid_after = static_cast<int>(volume->invalid());
    clock.end("remeshing around invalid elements");
    return {*std::move(volume), repairs};
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_draft.h"

#include <vector>

#include "workflows/cad_normals.h"

namespace mq::workflows {

DraftSurface measure_draft(geometry::Engine& engine, const triangulate::Result& given, const TopoDS_Shape* shape,
                           const inspection::DraftOptions& options, Progress& progress) {
    options.validate();
    DraftSurface found;
    progress.stage("preparing the solids", 0.0, 0.1);
    found.solids = solid_surface(given, progress);
    progress.stage("measuring the draft", 0.1, 1.0);
    const mesh::TriangleMesh& mesh = found.solids.surface.mesh;
    std::vector<Vec3> normals;
    if (shape != nullptr) {
        normals = cad_normals(engine, mesh, *shape, progress, found.exact_normals);
    }
    found.draft = inspection::draft(mesh, normals, options, &progress);
    return found;
}

}  // namespace mq::workflows

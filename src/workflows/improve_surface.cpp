// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/improve_surface.h"

#include <utility>

#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

triangulate::Result improve_surface(const mesh::TriangleMesh& mesh, const improve::ImproveOptions& options,
                                    Progress& progress) {
    const Stopwatch watch_all;
    improve::Result result = improve::improve(mesh, options, &progress);
    triangulate::Result surface;
    surface.mesh = std::move(result.mesh);
    surface.report = mesh::measure(surface.mesh, &progress);
    surface.report.min_angle_asked = options.min_angle;
    mesh::set_exempt(surface.mesh, std::move(result.exempt), surface.report);
    surface.report.notes.push_back(
        {phrases::kChanges,
         {{"count", result.flips}, {"count2", result.collapses}, {"count3", result.splits}, {"count4", result.moves}}});
    if (result.kept > 0) {
        surface.report.notes.push_back(counted(phrases::kKeptAsItWas, result.kept));
    }
    surface.report.self_intersections = static_cast<std::int64_t>(
        mesh::self_intersections(surface.mesh.vertices, surface.mesh.triangles, mesh::kMostCounted, &progress).size());
    surface.report.seconds = std::move(result.seconds);
    surface.report.cpu_seconds = watch_all.cpu();
    return surface;
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/improve_surface.h"

#include <string>
#include <utility>

#include "base/stopwatch.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

namespace {

std::string sentence(const improve::Result& result) {
    return "edges swapped: " + std::to_string(result.flips) + ", collapsed: " + std::to_string(result.collapses) +
           ", halved: " + std::to_string(result.splits) + "; vertices moved: " + std::to_string(result.moves);
}

}  // namespace

triangulate::Result improve_surface(const mesh::TriangleMesh& mesh, const improve::ImproveOptions& options,
                                    Progress& progress) {
    const Stopwatch watch_all;
    improve::Result result = improve::improve(mesh, options, &progress);
    triangulate::Result surface;
    surface.mesh = std::move(result.mesh);
    surface.report = mesh::measure(surface.mesh, &progress);
    surface.report.min_angle_asked = options.min_angle;
    mesh::set_exempt(surface.mesh, std::move(result.exempt), surface.report);
    surface.report.notes.push_back(sentence(result));
    if (result.kept > 0) {
        surface.report.notes.push_back("the mesh was kept as it was at " + mesh::counted(result.kept, "triangle") +
                                       ", which would cross others or have smaller angles than any before");
    }
    surface.report.self_intersections = static_cast<std::int64_t>(
        mesh::self_intersections(surface.mesh.vertices, surface.mesh.triangles, mesh::kMostCounted, &progress).size());
    surface.report.seconds = std::move(result.seconds);
    surface.report.cpu_seconds = watch_all.cpu();
    return surface;
}

}  // namespace mq::workflows

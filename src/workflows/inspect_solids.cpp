// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/inspect_solids.h"

#include <algorithm>
#include <utility>

#include "boolean/input/operand_repair.h"
#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

namespace {

/// Width up to which cracks are closed, as a fraction of the largest side.
constexpr double kCrackWidth = 1e-4;

/// Whether every triangle bounds a solid of a shape, and all solids are closed.
bool bounds_solids(const triangulate::Result& given) {
    const std::vector<std::int32_t>& solid = given.mesh.triangle_solid;
    return !solid.empty() && given.report.closed && given.report.oriented &&
           std::all_of(solid.begin(), solid.end(), [](std::int32_t s) { return s >= 0; });
}

}  // namespace

SolidSurface solid_surface(const triangulate::Result& given, Progress& progress) {
    SolidSurface found;
    if (bounds_solids(given)) {
        found.surface = given;
        found.body = given.mesh.triangle_solid;
        return found;
    }
    Box box;
    for (const Vec3& p : given.mesh.vertices) {
        box.add(p);
    }
    boolean::Operand operand =
        boolean::prepare_operand(given.mesh, "the mesh", kCrackWidth * box.largest_side(), &progress);
    mesh::TriangleMesh& mesh = found.surface.mesh;
    mesh.origin = given.mesh.origin;
    mesh.vertices = std::move(operand.vertices);
    mesh.triangles = std::move(operand.triangles);
    if (!given.mesh.triangle_face.empty()) {
        for (const std::int32_t source : operand.source) {
            mesh.triangle_face.push_back(source < 0 ? -1 : given.mesh.triangle_face[source]);
        }
    }
    found.surface.report = mesh::measure(mesh, &progress);
    found.surface.report.max_chord_height = given.report.max_chord_height;
    found.surface.report.notes = given.report.notes;
    found.surface.report.bridge = given.report.bridge;
    if (operand.repairs.any()) {
        found.surface.report.notes.push_back("repaired before it was measured: " + operand.repairs.summary());
    }
    return found;
}

ThicknessSurface measure_thickness(const triangulate::Result& given, const inspection::ThicknessOptions& options,
                                   Progress& progress) {
    options.validate();
    const Stopwatch watch;
    ThicknessSurface found;
    StageTimer clock(found.seconds);
    progress.stage("preparing the solids", 0.0, 0.1);
    found.solids = solid_surface(given, progress);
    clock.end("preparing the solids");
    progress.stage("measuring the thickness", 0.1, 1.0);
    found.thickness = inspection::thickness(found.solids.surface.mesh, found.solids.body, options, &progress);
    clock.end("measuring the thickness");
    found.cpu_seconds = watch.cpu();
    return found;
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_clearances.h"

#include <array>
#include <memory>

#include "base/error.h"
#include "boolean/boolean.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"
#include "mesh/quality/mesh_report.h"

namespace mq::workflows {

namespace {

bool have_room_in_common(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    std::array<Box, 2> boxes;
    for (std::size_t i = 0; i < 2; ++i) {
        for (const Vec3& p : (i == 0 ? a : b).vertices) {
            boxes[i].add(p);
        }
    }
    return (boxes[0].low.cwiseMax(boxes[1].low).array() < boxes[0].high.cwiseMin(boxes[1].high).array()).all();
}

/// Sets the volume and surface of the intersection of two bodies, by an exact Boolean whose tolerance is that of
/// rounding.
void measure_common(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, inspection::Clearance& clearance,
                    const Progress& progress) {
    constexpr double kTolerance = 1e-6;  // fraction of the size of the larger one
    if (!have_room_in_common(a, b)) {
        return;
    }
    Box box;
    for (const mesh::TriangleMesh* mesh : {&a, &b}) {
        for (const Vec3& p : mesh->vertices) {
            box.add(p);
        }
    }
    boolean::BooleanOptions options;
    options.tolerance = kTolerance * box.largest_side();
    Progress unseen(&progress);
    try {
        const boolean::BooleanResult common =
            boolean::boolean({&a, &b}, boolean::Operation::Intersection, options, &unseen);
        const mesh::MeshReport report = mesh::measure(common.mesh);
        clearance.common_volume = report.volume;
        clearance.common_area = report.area;
    } catch (const TopologyError&) {
        clearance.common_volume = -1.0;
        clearance.common_area = -1.0;
    }
}

}  // namespace

std::vector<inspection::Clearance> measure_clearances(const std::vector<const triangulate::Result*>& bodies,
                                                      const std::vector<double>& slack,
                                                      const inspection::ClearanceOptions& options, Progress& progress) {
    progress.stage("measuring the clearance", 0.0, 1.0);
    std::vector<std::unique_ptr<mesh::TriangleMesh>> moved;
    std::vector<const mesh::TriangleMesh*> meshes;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const mesh::TriangleMesh& mesh = bodies[i]->mesh;
        if (mesh.triangles.empty()) {
            throw InvalidInput(phrases::kBodyEmpty, {{"count", i + 1}});
        }
        mesh::require_valid(mesh);
        meshes.push_back(&mesh);
        const Vec3 offset = mesh.origin - bodies[0]->mesh.origin;
        if (!offset.isZero(0.0)) {
            moved.push_back(std::make_unique<mesh::TriangleMesh>(mesh));
            for (Vec3& p : moved.back()->vertices) {
                p += offset;
            }
            meshes.back() = moved.back().get();
        }
    }
    std::vector<inspection::Clearance> found = inspection::clearances(meshes, slack, options, &progress);
    for (inspection::Clearance& clearance : found) {
        const std::array<std::size_t, 2> pair{static_cast<std::size_t>(clearance.bodies[0]),
                                              static_cast<std::size_t>(clearance.bodies[1])};
        if (clearance.nearest.distance == 0.0 && bodies[pair[0]]->report.closed && bodies[pair[1]]->report.closed) {
            measure_common(*meshes[pair[0]], *meshes[pair[1]], clearance, progress);
        }
        for (inspection::NearestPlaces& places : clearance.faces) {
            for (Vec3& p : places.points) {
                p += bodies[0]->mesh.origin;
            }
        }
        for (Vec3& p : clearance.nearest.points) {
            p += bodies[0]->mesh.origin;
        }
    }
    return found;
}

}  // namespace mq::workflows

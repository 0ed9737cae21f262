// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_clearances.h"

#include <memory>
#include <string>

#include "base/error.h"
#include "mesh/edge_table.h"

namespace mq::workflows {

std::vector<inspection::Clearance> measure_clearances(const std::vector<const triangulate::Result*>& bodies,
                                                      const std::vector<double>& slack,
                                                      const inspection::ClearanceOptions& options, Progress& progress) {
    progress.stage("measuring the clearance", 0.0, 1.0);
    std::vector<std::unique_ptr<mesh::TriangleMesh>> moved;
    std::vector<const mesh::TriangleMesh*> meshes;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const mesh::TriangleMesh& mesh = bodies[i]->mesh;
        if (mesh.triangles.empty()) {
            throw InvalidInput("body " + std::to_string(i + 1) + " has no triangles");
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

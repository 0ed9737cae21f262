// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"
#include "triangulate/work_mesh/angle_history.h"

namespace mq::triangulate {

/// The return value of triangulate().
struct Result {
    mesh::TriangleMesh mesh;
    mesh::MeshReport report;
    /// The state before Algorithm M begins, after each vertex that it inserts, and when it ends for the first time;
    /// empty unless TriangulateOptions::record_angles.
    std::vector<AngleHistory::Entry> angle_history{};
};

}  // namespace mq::triangulate

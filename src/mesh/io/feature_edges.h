// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/io/export_mesh.h"

namespace mq::mesh {

/// Edges that meshers for flows keep: where the surface turns by more than an angle, where patches meet, and where it
/// ends or branches.
struct FeatureEdges {
    std::vector<std::array<std::int32_t, 2>> edges;  ///< pairs of nodes, ascending
    std::vector<bool> sharp;                         ///< by edge, whether the surface turns, ends or branches there
    std::vector<bool> border;                        ///< by edge, whether it is between patches
};

/// Degrees by which a surface turns at a sharp edge; surfaceFeatures of OpenFOAM has the same (includedAngle 150).
constexpr double kSharpAngle = 30.0;

FeatureEdges feature_edges(const ExportMesh& mesh, double degrees = kSharpAngle);

}  // namespace mq::mesh

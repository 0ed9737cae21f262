// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/topology.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

/// Sets TriangleMesh::triangle_opposite.
/// @param source  by triangle of `mesh`: its triangle in the working mesh, the same one on both sides of a contact
void pair_opposite_triangles(mesh::TriangleMesh& mesh, const std::vector<int>& source);

/// The pairs of solids that share triangles, by their numbers.
std::vector<mesh::SolidContact> solid_contacts(const mesh::TriangleMesh& mesh);

/// Names the pairs of solids to which pairs of faces belong: "Solid1 and Solid2, Solid1 and Solid5".
std::string solids_of(const std::vector<std::pair<int, int>>& faces, const geometry::Topology& topology);

}  // namespace mq::triangulate

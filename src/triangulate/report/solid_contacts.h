// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

/// Sets TriangleMesh::triangle_opposite.
/// @param source  by triangle of `mesh`: its triangle in the working mesh, the same one on both sides of a contact
void pair_opposite_triangles(mesh::TriangleMesh& mesh, const std::vector<int>& source);

/// The pairs of solids that share triangles, by their numbers.
std::vector<mesh::SolidContact> solid_contacts(const mesh::TriangleMesh& mesh);

}  // namespace mq::triangulate

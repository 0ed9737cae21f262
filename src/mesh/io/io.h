// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Writes by extension: .stl (binary), .ply (binary), .obj, .off, .msh (Gmsh ASCII 4.1, one entity for each CAD face),
/// .vtu. Coordinates are in the model's frame (origin added), with all digits where the format allows.
/// @throws IoError naming the path.
void write(const TriangleMesh& mesh, const std::string& path);

/// FreeCAD's own binary mesh format (BMS) of the mesh in its local frame: the fastest way into a Mesh.Mesh, which
/// keeps shared vertices and the order of the triangles.
std::string to_bms(const TriangleMesh& mesh);

}  // namespace mq::mesh

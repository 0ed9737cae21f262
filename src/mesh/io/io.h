// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/io/export_mesh.h"
#include "mesh/io/output.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Writes by extension: .stl (binary), .ply (binary), .obj, .off, .msh (Gmsh ASCII 4.1, one entity for each CAD face),
/// .vtu. Coordinates are in the model's frame (origin added), with all digits where the format allows.
/// @throws IoError naming the path.
void write(const TriangleMesh& mesh, const std::string& path);

/// Writes a mesh in one of the formats, named as extensions without the full stop: the above, and formats that need
/// groups or other elements, such as "su2" or "inp". `ascii` chooses the text form of "stl".
/// @throws IoError naming the path, and for a format that is not known here
/// @throws InvalidInput where the format does not know elements of the order
void write(const ExportMesh& mesh, const std::string& path, const std::string& format, bool ascii = false);

/// A format that holds elements of several types.
struct ElementFormat {
    std::string name;
    int below = 0;  ///< how far below the highest dimension its elements may be; lower ones are left out
    std::vector<const ElementType*> types;
};

std::vector<ElementFormat> element_formats();

/// The extension of a path in lower case with its full stop; empty without one.
std::string extension_of(const std::string& path);

/// Writes what `append` appends into a file. @throws IoError naming the path
void save(const std::string& path, const std::function<void(Output&)>& append);

/// FreeCAD's own binary mesh format (BMS) of the mesh in its local frame: the fastest way into a Mesh.Mesh, which
/// keeps shared vertices and the order of the triangles.
std::string to_bms(const TriangleMesh& mesh);

}  // namespace mq::mesh

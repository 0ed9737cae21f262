// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstring>
#include <string>

#include "mesh/io/export_mesh.h"

/// One writer for each file format. Each returns the whole file.
namespace mq::mesh {

// These write flat triangles, without names where no patches are given.
std::string to_stl(const ExportMesh& mesh);  ///< binary; the attribute of a triangle is the number of its patch from 0
std::string to_ply(const ExportMesh& mesh);
std::string to_obj(const ExportMesh& mesh);
std::string to_off(const ExportMesh& mesh);
std::string to_msh(const ExportMesh& mesh);
std::string to_vtu(const ExportMesh& mesh);
std::string to_3mf_model(const ExportMesh& mesh);  ///< the XML part that a .3mf container holds
std::string to_amf(const ExportMesh& mesh);

// These write flat triangles by patches.
std::string to_stl_text(const ExportMesh& mesh);  ///< one solid a patch
std::string to_tri(const ExportMesh& mesh);       ///< Cart3D; component i + 1 is patch i
std::string to_emesh(const ExportMesh& mesh);     ///< OpenFOAM: sharp edges and borders of patches
std::string to_fms(const ExportMesh& mesh);       ///< cfMesh: triangles and those edges

// These write triangles and tetrahedra by patches and solids.
std::string to_su2(const ExportMesh& mesh);      ///< order 1
std::string to_nastran(const ExportMesh& mesh);  ///< orders 1 and 2, as the following
std::string to_abaqus(const ExportMesh& mesh);
std::string to_unv(const ExportMesh& mesh);
std::string to_msh2(const ExportMesh& mesh);  ///< Gmsh 2.2; all orders

/// True when every coordinate of the file is a single-precision number, so that float loses nothing.
bool fits_single_precision(const ExportMesh& mesh);

/// Gmsh's number of the type of elements of a dimension 1 to 3 and an order 1 to 5.
int gmsh_type(int dimension, int order);

/// Place of the nodes of a tetrahedron of order 2 in the order of Abaqus, Nastran, CGNS and Exodus: Gmsh exchanges the
/// last two.
constexpr std::array<std::size_t, 10> kTetrahedronOrder{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};

/// Appends the bytes of a plain value. All binary formats here are little-endian, as is every platform of FreeCAD.
template <typename T>
void append_bytes(std::string& out, const T& value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

template <typename Real>
void append_point(std::string& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
        append_bytes(out, static_cast<Real>(p[i]));
    }
}

/// Appends the shortest text that reads back as the same number.
void append_number(std::string& out, double value);
void append_number(std::string& out, float value);
void append_number(std::string& out, long long value);

/// Appends "x y z\n".
void append_point_text(std::string& out, const Vec3& p);

/// Appends the numbers of `count` nodes from `first` on, each after a separator, then a newline.
void append_nodes(std::string& out, const std::int32_t* nodes, std::size_t count, int first, char separator = ' ');

/// Appends a whole number at the right end of a column of this width.
void append_column(std::string& out, long long value, std::size_t width);

}  // namespace mq::mesh

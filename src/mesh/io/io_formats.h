// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstring>
#include <string>

#include "mesh/io/export_mesh.h"
#include "mesh/io/output.h"

/// One writer for each file format. Each appends the whole file.
namespace mq::mesh {

// These write flat triangles, without names where no patches are given.
void to_stl(Output& out,
            const ExportMesh& mesh);  ///< binary; the attribute of a triangle is the number of its patch from 0
void to_ply(Output& out, const ExportMesh& mesh);
void to_obj(Output& out, const ExportMesh& mesh);
void to_off(Output& out, const ExportMesh& mesh);
void to_3mf_mesh(Output& out, const ExportMesh& mesh);  ///< the element `mesh` of an object; `pid` is 1
void to_amf(Output& out, const ExportMesh& mesh);

// The following functions write flat triangles by patches.
void to_stl_text(Output& out, const ExportMesh& mesh);  ///< one solid a patch
void to_tri(Output& out, const ExportMesh& mesh);       ///< Cart3D; component i + 1 is patch i
void to_emesh(Output& out, const ExportMesh& mesh);     ///< OpenFOAM: sharp edges and borders of patches
void to_fms(Output& out, const ExportMesh& mesh);       ///< cfMesh: triangles, and the same edges as to_emesh

// The following functions write elements of any type that the format has (ElementType), by groups.
void to_msh(Output& out, const ExportMesh& mesh);
void to_vtu(Output& out, const ExportMesh& mesh);
void to_su2(Output& out, const ExportMesh& mesh);
void to_nastran(Output& out, const ExportMesh& mesh);
void to_abaqus(Output& out, const ExportMesh& mesh);
void to_unv(Output& out, const ExportMesh& mesh);
void to_msh2(Output& out, const ExportMesh& mesh);  ///< Gmsh 2.2

/// True when every coordinate of the file is a single-precision number, so that float loses nothing.
bool fits_single_precision(const ExportMesh& mesh);

/// Appends the bytes of a plain value. All binary formats here are little-endian, as is every platform of FreeCAD.
template <typename T, typename Out>
void append_bytes(Out& out, const T& value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

template <typename Real, typename Out>
void append_point(Out& out, const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
        append_bytes(out, static_cast<Real>(p[i]));
    }
}

/// Appends "x y z" and the given end.
void append_point_text(Output& out, const Vec3& p, std::string_view end = "\n");

/// Appends the numbers of `count` nodes from `first` on, each after a separator, and the given end.
void append_nodes(Output& out, const std::int32_t* nodes, std::size_t count, int first, char separator = ' ',
                  std::string_view end = "\n");

/// Appends a whole number at the right end of a column of this width.
void append_column(Output& out, long long value, std::size_t width);

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstring>
#include <string>

#include "mesh/triangle_mesh.h"

/// One writer for each file format. Each returns the whole file; coordinates are in the model's frame unless it says
/// otherwise.
namespace mq::mesh {

std::string to_stl(const TriangleMesh& mesh);
std::string to_ply(const TriangleMesh& mesh);
std::string to_obj(const TriangleMesh& mesh);
std::string to_off(const TriangleMesh& mesh);
std::string to_msh(const TriangleMesh& mesh);
std::string to_vtu(const TriangleMesh& mesh);

/// True when every coordinate of the model's frame is a single-precision number, so that float loses nothing.
bool fits_single_precision(const TriangleMesh& mesh);

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
void append_number(std::string& out, long long value);

/// Appends "x y z\n".
void append_point_text(std::string& out, const Vec3& p);

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/vec.h"

class TopoDS_Shape;

namespace mq::geometry {

/// The same shape, to be kept.
std::shared_ptr<const TopoDS_Shape> kept(const TopoDS_Shape& shape);

/// The box of a shape by OpenCASCADE, with the tolerances of its entities; not tight around curved faces.
/// @throws GeometryError when the kernel fails
Box box_of(const TopoDS_Shape& shape);

/// The mean thickness, 2 V / A, mm, of each solid, or of the shape where it has none; none of what has no volume.
/// @throws GeometryError when the kernel fails
std::vector<double> mean_thicknesses(const TopoDS_Shape& shape);

std::size_t face_count(const TopoDS_Shape& shape);

/// A copy of a face of a shape, by its index: what is made of it does not change the shape.
std::shared_ptr<const TopoDS_Shape> copied_face(const TopoDS_Shape& shape, std::size_t face);

struct KernelTriangles {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// OpenCASCADE's triangulation of a face, which stores it; nothing where it finds none.
/// @param distance  mm, asked for, but not always kept
/// @throws GeometryError when the kernel fails
KernelTriangles kernel_triangles(const TopoDS_Shape& face, double distance);

}  // namespace mq::geometry

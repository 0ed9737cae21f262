// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

class TopoDS_Shape;

namespace mq::geometry {

struct KernelTriangles {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// OpenCASCADE's triangulation of a face, which stores it; nothing where it finds none.
/// @param distance  mm, requested, but not always kept
/// @throws GeometryError when the kernel fails
KernelTriangles kernel_triangles(const TopoDS_Shape& face, double distance);

}  // namespace mq::geometry

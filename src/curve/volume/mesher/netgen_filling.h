// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/volume/filling/filling.h"

namespace mq::curve {

/// Sets the path of the program that runs Netgen (netgen/fill_main.cpp). To be called once, before anything is filled.
void set_fill_program(const std::string& path);

/// Fills a closed, outward oriented surface by Netgen's nglib in a process of its own, see fill().
/// @throws MeshingFailed when the mesher fails or crashes, GeometryError when it does not end, IoError when it cannot
/// be started; Cancelled.
TetrahedralFilling fill_by_netgen(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                  double grading_factor, const Progress& progress);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

class TopoDS_Shape;

namespace mq::geometry {

/// The mean thickness, 2 V / A, mm, of each solid, or of a shape without solids; solids without volume are left out.
/// @throws GeometryError when the kernel fails
std::vector<double> mean_thicknesses(const TopoDS_Shape& shape);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "curve/volume/filling/filling.h"

namespace mq::curve {

/// What the program that fills a surface answers (netgen/fill_main.cpp), which may have been ended in the middle:
/// int64 0, int64 points, int64 tetrahedra, three doubles a point, four int32 a tetrahedron; or int64 not 0, int64 and
/// the text of why it failed.
struct FillingAnswer {
    TetrahedralFilling filling;
    std::string fault;  ///< why there is no filling; empty when there is one
};

/// @param surface  the points of the surface, which the answer must begin with
/// @throws MeshingFailed for an answer that breaks off, moves points of the surface or names points that it has not got
FillingAnswer read_filling(const std::string& answer, const std::vector<Vec3>& surface);

}  // namespace mq::curve

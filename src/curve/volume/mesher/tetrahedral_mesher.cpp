// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/mesher/tetrahedral_mesher.h"

#include "curve/volume/filling/surface_filling.h"
#include "curve/volume/mesher/filling_check.h"
#include "curve/volume/mesher/netgen_filling.h"

namespace mq::curve {

TetrahedralFilling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                        double grading_factor, const Progress& progress, const EndTangents& tangents) {
    std::string why;
    try {
        return fill_by_netgen(points, triangles, grading_factor, progress);
    } catch (const GeometryError& error) {
        why = error.what();
    }
    try {
        TetrahedralFilling own = fill_surface(points, triangles, grading_factor, progress, tangents);
        if (ends_at(triangles, own.tetrahedra)) {
            own.netgen_fault = why;
            return own;
        }
    } catch (const MeshingFailed& error) {
        why += "; our own mesher: ";
        why += error.what();
    }
    throw MeshingFailed(why);
}

}  // namespace mq::curve

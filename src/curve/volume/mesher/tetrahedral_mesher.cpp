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
        TetrahedralFilling own = fill_surface(points, triangles, grading_factor, progress, tangents);
        if (ends_at(triangles, own.tetrahedra)) {
            return own;
        }
        why = "the filling does not end at the surface";
    } catch (const MeshingFailed& error) {
        why = error.what();
    }
    try {
        TetrahedralFilling other = fill_by_netgen(points, triangles, grading_factor, progress);
        other.own_fault = why;
        return other;
    } catch (const GeometryError& error) {
        throw MeshingFailed("our own mesher: " + why + "; Netgen: " + error.what());
    }
}

}  // namespace mq::curve

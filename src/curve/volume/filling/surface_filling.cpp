// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/surface_filling.h"

#include "curve/volume/filling/boundary_recovery.h"
#include "curve/volume/filling/carving.h"
#include "curve/volume/filling/delaunay.h"
#include "curve/volume/filling/interior_points.h"
#include "curve/volume/filling/optimisation.h"
#include "curve/volume/filling/tuning.h"

namespace mq::curve {

namespace {

/// The cells; inner vertices are numbered after those of the surface.
TetrahedralFilling filling_of(const Tetrahedralisation& mesh, std::size_t surface) {
    TetrahedralFilling filling;
    std::vector<int> number(mesh.points.size(), -1);
    for (const Cell& cell : mesh.cells) {
        if (cell.v[0] < 0) {
            continue;
        }
        std::array<int, 4> v = cell.v;
        for (int& k : v) {
            if (k < static_cast<int>(surface)) {
                continue;
            }
            if (number[k] < 0) {
                number[k] = static_cast<int>(surface + filling.inner_points.size());
                filling.inner_points.push_back(mesh.point(k));
            }
            k = number[k];
        }
        filling.tetrahedra.push_back(v);
    }
    return filling;
}

}  // namespace

TetrahedralFilling fill_surface(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                double grading_factor, const Progress& progress, const EndTangents& tangents) {
    const auto first_inner = static_cast<int>(points.size());
    Tetrahedralisation mesh = delaunay_tetrahedralisation(points, progress);
    SurfaceConstraints surface(triangles);
    BoundaryRecovery(mesh, surface, progress).run();
    remove_outside(mesh, surface, first_inner);
    move_divisions_inwards(mesh, surface);
    InteriorPoints(mesh, triangles, FillingTuning::kGrowth * grading_factor).insert(progress);
    Optimisation(mesh, tangents, first_inner).run(progress);
    return filling_of(mesh, points.size());
}

}  // namespace mq::curve

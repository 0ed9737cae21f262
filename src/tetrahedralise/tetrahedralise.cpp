// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/surface_filling.h"

#include <optional>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/volume/filling/boundary_recovery.h"
#include "curve/volume/filling/carving.h"
#include "curve/volume/filling/coincident_vertices.h"
#include "curve/volume/filling/delaunay.h"
#include "curve/volume/filling/filling_check.h"
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

/// The inside of a surface, without points of its own but for those that its triangles need.
Tetrahedralisation inside_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                             double least_fraction, const Progress& progress) {
    Tetrahedralisation mesh = delaunay_tetrahedralisation(points, progress);
    SurfaceConstraints surface(triangles);
    BoundaryRecovery(mesh, surface, least_fraction, progress).run();
    remove_outside(mesh, surface, static_cast<int>(points.size()));
    move_divisions_inwards(mesh, surface);
    return mesh;
}

/// inside_of() with points on edges ever nearer their middles until that succeeds.
/// @throws MeshingFailed the first error
Tetrahedralisation inside_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                             const Progress& progress) {
    std::optional<MeshingFailed> first;
    for (const double least_fraction : {1e-6, 0.2, 0.5}) {
        try {
            return inside_of(points, triangles, least_fraction, progress);
        } catch (const MeshingFailed& error) {
            first = first ? *first : error;
        }
    }
    throw *first;
}

/// Fills a surface whose vertices all differ.
TetrahedralFilling fill_distinct(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                 double grading_factor, const Progress& progress, const EndTangents& tangents) {
    Tetrahedralisation mesh = inside_of(points, triangles, progress);
    InteriorPoints(mesh, triangles, FillingTuning::kGrowth * grading_factor).insert(progress);
    Optimisation(mesh, tangents, static_cast<int>(points.size())).run(progress);
    return filling_of(mesh, points.size());
}

TetrahedralFilling fill_touching(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                 double grading_factor, const Progress& progress, const EndTangents& tangents) {
    const CoincidentVertices one(points, triangles, tangents);
    if (one.points.size() == points.size()) {
        return fill_distinct(points, triangles, grading_factor, progress, tangents);
    }
    return one.separate(fill_distinct(one.points, one.triangles, grading_factor, progress, one.tangents));
}

}  // namespace

TetrahedralFilling fill_surface(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                double grading_factor, const Progress& progress, const EndTangents& tangents) {
    try {
        TetrahedralFilling filling = fill_touching(points, triangles, grading_factor, progress, tangents);
        if (!ends_at(triangles, filling.tetrahedra)) {
            throw MeshingFailed("the tetrahedra do not end at the surface");
        }
        return filling;
    } catch (const MeshingFailed& error) {
        throw MeshingFailed(Message::of(phrases::kNotFilled, {{"value", error.what()}}));
    }
}

}  // namespace mq::curve

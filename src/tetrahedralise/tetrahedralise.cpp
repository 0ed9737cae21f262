// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/tetrahedralise.h"

#include <optional>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/boundary_recovery.h"
#include "tetrahedralise/cells/delaunay.h"
#include "tetrahedralise/coincident_vertices.h"
#include "tetrahedralise/interior_points.h"
#include "tetrahedralise/is_bounded_by.h"
#include "tetrahedralise/optimisation.h"
#include "tetrahedralise/remove_outside.h"
#include "tetrahedralise/tuning.h"

namespace mq::tetrahedralise {

namespace {

/// The cells; inner vertices are numbered after those of the surface.
Tetrahedra tetrahedra_of(const Tetrahedralisation& mesh, std::size_t surface) {
    Tetrahedra result;
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
                number[k] = static_cast<int>(surface + result.inner_points.size());
                result.inner_points.push_back(mesh.point(k));
            }
            k = number[k];
        }
        result.tetrahedra.push_back(v);
    }
    return result;
}

/// Tetrahedralises the inside of a surface, without inner points except those that recovering its triangles needs.
Tetrahedralisation inside_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                             double least_fraction, const Progress& progress) {
    Tetrahedralisation mesh = delaunay_tetrahedralisation(points, progress);
    SurfaceConstraints surface(triangles);
    BoundaryRecovery(mesh, surface, least_fraction, progress).run();
    remove_outside(mesh, surface, static_cast<int>(points.size()));
    move_divisions_inwards(mesh, surface);
    return mesh;
}

/// Calls inside_of() with points on edges nearer and nearer to the middles until it succeeds.
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

/// Takes a surface whose vertices all differ.
Tetrahedra tetrahedralise_distinct(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                   const Grading& grading, const Progress& progress, const EndTangents& tangents) {
    Tetrahedralisation mesh = inside_of(points, triangles, progress);
    InteriorPoints(mesh, triangles, TetrahedralisationTuning::kGrowth * grading.factor, grading.field).insert(progress);
    Optimisation(mesh, tangents, static_cast<int>(points.size()), grading.field).run(progress);
    return tetrahedra_of(mesh, points.size());
}

Tetrahedra tetrahedralise_touching(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                   const Grading& grading, const Progress& progress, const EndTangents& tangents) {
    const CoincidentVertices one(points, triangles, tangents);
    if (one.points.size() == points.size()) {
        return tetrahedralise_distinct(points, triangles, grading, progress, tangents);
    }
    return one.separate(tetrahedralise_distinct(one.points, one.triangles, grading, progress, one.tangents));
}

}  // namespace

Tetrahedra tetrahedralise(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                          const Grading& grading, const Progress& progress, const EndTangents& tangents) {
    try {
        Tetrahedra result = tetrahedralise_touching(points, triangles, grading, progress, tangents);
        if (!is_bounded_by(triangles, result.tetrahedra)) {
            throw MeshingFailed(phrases::kEndsElsewhere);
        }
        return result;
    } catch (const MeshingFailed& error) {
        throw MeshingFailed(phrases::kNotFilled, {{"value", error.message()}});
    }
}

}  // namespace mq::tetrahedralise

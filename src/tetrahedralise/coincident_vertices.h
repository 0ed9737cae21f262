// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::tetrahedralise {

/// A surface that may touch itself at vertices and along edges, with one vertex in place of those that coincide: a
/// Delaunay tetrahedralisation has one vertex at a point.
struct CoincidentVertices {
    CoincidentVertices(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                       const EndTangents& tangents);

    /// Gives tetrahedra the given vertices again: if several coincide, a tetrahedron at their point gets the one whose
    /// triangles can be reached from it inside the surface.
    /// @throws MeshingFailed where tetrahedra reach triangles of several vertices that coincide.
    Tetrahedra separate(Tetrahedra result) const;

    std::vector<Vec3> points;  ///< all different
    std::vector<std::array<int, 3>> triangles;
    EndTangents tangents;

  private:
    const std::vector<std::array<int, 3>>& given_;
    std::size_t given_points_;
    std::vector<int> first_;    // by vertex: the first of the given ones that coincide there
    std::vector<char> shared_;  // by vertex: whether several coincide
};

}  // namespace mq::tetrahedralise

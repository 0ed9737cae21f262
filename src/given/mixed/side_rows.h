// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "given/mixed/mixed_mesh.h"

namespace mq::given {

/// Sides that lie behind one another: edges across quadrilaterals, or faces across prisms and hexahedra. The first side
/// is on the CAD.
///
/// Such rows are the columns of a boundary layer, from the wall to its top, and the lines of structured hexahedra from
/// wall to wall. Corners of different sides correspond: corners of one column have the same index in each side.
struct SideRow {
    std::vector<std::vector<std::int32_t>> sides;  ///< the corners of each side
    std::vector<std::vector<double>> fractions;    ///< by side and corner: position along the corner's column, 0 to 1
    double height = 0.0;                           ///< mean length of the columns, mm
    bool ends_on_cad = false;
};

/// Whether a side, given by its corners, is on the CAD.
using OnCad = std::function<bool(const std::vector<std::int32_t>&)>;

/// A quadrilateral and the elements that have it; a quadrilateral of a surface has no elements.
struct RowQuadrilateral {
    std::array<std::int32_t, 4> corners;
    std::array<std::int64_t, 2> elements;  ///< -1: there is none
};

/// Rows of edges. A row continues from a quadrilateral to the one beyond the edge that has no element in common with
/// it. It ends on the CAD, or if there is not exactly one such quadrilateral.
std::vector<SideRow> rows_of_edges(const std::vector<RowQuadrilateral>& quadrilaterals, const std::vector<Vec3>& nodes,
                                   const OnCad& on_cad);

/// Rows of triangles across prisms and of quadrilaterals across hexahedra.
std::vector<SideRow> rows_of_faces(const MixedMesh& mesh, const OnCad& on_cad);

}  // namespace mq::given

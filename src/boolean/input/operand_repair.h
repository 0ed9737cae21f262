// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/message.h"
#include "base/progress.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// The repairs that made a closed, oriented surface of an operand, by number.
struct Repairs {
    std::size_t welded = 0;                ///< vertices with the coordinates of another one
    std::size_t degenerate = 0;            ///< triangles without area removed
    std::size_t duplicate = 0;             ///< triangles on the same three vertices removed
    std::size_t flipped = 0;               ///< triangles reversed
    std::size_t nonmanifold_edges = 0;     ///< edges of more than two triangles, separated into sheets
    std::size_t nonmanifold_vertices = 0;  ///< vertices where sheets met in a point, separated
    std::size_t cracks = 0;                ///< vertices of borders joined to other borders, across cracks
    std::size_t holes = 0;                 ///< holes closed
    std::size_t hole_triangles = 0;        ///< triangles made to close holes
    std::size_t scraps = 0;                ///< triangles of open sheets removed: inner walls, fins, stray triangles

    bool any() const;
    /// "2 holes closed (15 triangles), 1 duplicate triangle removed", or "none".
    Message summary() const;
    /// The same after the operand's name; empty if nothing was repaired.
    Message of_operand(const std::string& name) const;
};

/// An operand fit for the Boolean: closed, every edge with exactly two triangles that run along it opposite ways, every
/// vertex with a single fan, no triangle without area, components oriented outward unless they are cavities. It may
/// intersect itself. Vertices of sheets that were separated have equal coordinates.
struct Operand {
    std::vector<Vec3> vertices;  ///< the input's vertices in their places, in its frame; then added ones
    std::vector<mesh::Triangle> triangles;
    /// By triangle: the input's triangle that it is, or is a piece of; -1 for fillings of holes.
    std::vector<std::int32_t> source;
    Repairs repairs;
    double largest_move = 0.0;  ///< how far at most points of the surface were moved to close cracks, mm
    /// Components and Euler number of the input, if nothing was repaired and its components were separated; else with 0
    /// components.
    mesh::SurfaceTopology topology;
};

/// Whether a triangle of a prepared operand has the corners of the input's triangle from which it comes, in any order.
bool has_corners_of(const Operand& operand, std::size_t triangle, const mesh::TriangleMesh& input);

/// An operand that no repair makes closed and oriented: which points it encloses can only be guessed.
class OpenOperand : public InvalidInput {
    using InvalidInput::InvalidInput;
};

/// "operand A", "operand B", ...; a number where there are more operands than letters.
std::string operand_name(std::size_t index, std::size_t count);

/// Inspects an operand and makes the repairs listed in Repairs. 0.25 us a triangle when there is nothing to repair.
///
/// Triangles keep their order; a triangle that was only reversed or renumbered keeps its corners' coordinates bit for
/// bit.
/// @param name for messages, such as "operand A"
/// @param reach  the width up to which cracks are closed, mm; 0: none
/// @param oriented  whether components stay turned as they are: their inside is what they wind around
/// @throws InvalidInput naming the operand, the defect and its position: no triangles, a coordinate that is not finite,
/// an index out of range.
/// @throws OpenOperand likewise: a one-sided surface, an open surface (see InputTuning).
/// @throws Cancelled.
Operand prepare_operand(const mesh::TriangleMesh& mesh, const std::string& name, double reach = 0.0,
                        const Progress* progress = nullptr, bool oriented = false);

/// Repairs an operand that prepare_operand refuses as open, and leaves it open. Welds equal vertices, removes
/// degenerate and duplicate triangles, orients neighbours alike unless the surface is one-sided, and turns each open
/// sheet so that rays leave the operand on its outside.
/// @throws InvalidInput, Cancelled as prepare_operand
Operand prepare_open_operand(const mesh::TriangleMesh& mesh, const std::string& name,
                             const Progress* progress = nullptr);

}  // namespace mq::boolean

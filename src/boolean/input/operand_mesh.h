// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boolean/input/operand_repair.h"
#include "mesh/corner_table.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// An operand's surface while it is being repaired.
///
/// `mates` pairs the corners (directed edges, 3 * triangle + i) of neighbours; mesh::kBorder and mesh::kIrregular as in
/// mesh::edge_twins. Unlike twins, mates may run the same way until the triangles have been oriented.
struct OperandMesh {
    std::vector<Vec3> vertices;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> source;
    std::vector<std::int32_t> mates;
    std::vector<std::int32_t> attached;  ///< triangles of walls and fins, left over at an edge whose others were paired
    Repairs repairs;
    double largest_move = 0.0;   ///< how far at most points were moved to close cracks, mm
    std::string name;            ///< name of the operand, for messages
    Vec3 origin = Vec3::Zero();  ///< origin of the vertices' frame

    std::int32_t tail(std::int32_t corner) const { return triangles[corner / 3][corner % 3]; }
    std::int32_t head(std::int32_t corner) const { return tail(mesh::next_corner(corner)); }
    const Vec3& point(std::int32_t corner) const { return vertices[tail(corner)]; }
    void pair(std::int32_t h, std::int32_t g) {
        mates[h] = g;
        mates[g] = h;
    }
    void find_twins() { mates = mesh::edge_twins(triangles, vertices.size()); }
    /// Removes the triangles marked; their mates are on the border then.
    void remove(const std::vector<char>& marked);
    /// Reverses the triangles marked, and their mates with them.
    void turn(const std::vector<char>& marked);
    /// The corner that has the edge of this corner after its triangle was reversed: (a, b, c) becomes (a, c, b).
    static std::int32_t turned(std::int32_t corner) { return corner / 3 * 3 + 2 - corner % 3; }
    double area(std::int32_t triangle) const;
    /// Formats a position in the model's frame: "(1.5, 0, -2) mm".
    std::string position(const Vec3& local) const;
};

// ---- the steps, in their order --------------------------------------------------------------------------------------

/// Keeps one triangle for each set of three vertices. If as many run in one direction as in the other, the triangle
/// that fits the neighbours is kept, or none if the neighbours are in balance without it, as at a wall between two
/// solids. A surface that is drawn from both sides, with no other surface beside it, keeps one side if it is nearly
/// closed.
void remove_duplicates(OperandMesh& draft);

/// Joins borders of different components that run along each other: vertices that lie together, then edges and the
/// vertices along them (by distance, as Barequet and Sharir 1995 match borders). Needs twins, and keeps them valid.
/// @param reach  mm: largest distance of two points that are joined, which is also limited to InputTuning::kCrackWidth
/// of the border edges there; 0: nothing is joined
void close_cracks(OperandMesh& draft, double reach, const Progress* progress);

/// Removes triangles whose corners lie on one line: the neighbour along the long edge is divided at the corner that
/// lies on it. Needs twins, and keeps them valid. A triangle without a usable neighbour stays.
/// @return the number removed
std::size_t remove_degenerate(OperandMesh& draft);

/// Reverses triangles so that neighbours agree, the majority of each patch staying as it is, and pairs up the triangles
/// of edges that have more than two: going around the edge, those with the solid between them belong together. Edges of
/// two triangles that run the same way are mates afterwards, too; a corner without a partner is on the border.
/// @throws InvalidInput when the surface has one side only.
void pair_and_orient(OperandMesh& draft);

/// Fills all holes with the least area, preferring fillings that do not cross the rest of the surface; then removes or
/// refuses components that are too open.
/// @throws InvalidInput for an open surface.
void close_holes(OperandMesh& draft, const Progress* progress);

/// Gives each fan of triangles at a vertex a vertex of its own, so that indices alone determine the neighbours.
void split_fans(OperandMesh& draft);

/// Reverses components whose orientation contradicts the components around them. A component with negative volume that
/// lies in no other one is reversed together with all that lies in it; in another one it is a cavity.
/// @return the number of components
std::size_t orient_to_bound_volume(OperandMesh& draft);

/// Reverses open components if most of their area has the inside in front of it, by rays that count the triangles.
void orient_open_sheets(OperandMesh& draft, const Progress* progress);

}  // namespace mq::boolean

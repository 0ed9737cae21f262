// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/session.h"

namespace mq::given {

/// A surface mesh as a graph: its vertices, and the mesh edges at each of them.
struct SurfaceGraph {
    const std::vector<Vec3>& points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::vector<int>> neighbours;  ///< by point, ascending; empty for points inside
    std::vector<double> shortest;              ///< mm, by point: length of its shortest mesh edge

    SurfaceGraph(const std::vector<Vec3>& points, std::vector<std::array<int, 3>> triangles);
};

/// The mesh edges that follow a CAD edge: their vertices in the order of the parameter. The polyline of a closed edge
/// begins and ends with the same vertex. A CAD edge that is one vertex of the mesh has that vertex only.
struct EdgePath {
    std::vector<int> vertices;
    double distance = 0.0;  ///< mm: largest distance of the vertices from the CAD edge
};

/// Distances of mesh vertices from the CAD, as fractions of the model's size. The first ones are those of numbers in
/// single precision or with eight digits in a file, the others those of programs that place vertices less exactly.
constexpr std::array<double, 4> kNear{1e-6, 1e-5, 1e-4, 1e-3};

/// The vertices and edges of the model that were found in the mesh.
struct EdgePaths {
    std::vector<int> of_node;         ///< by CAD vertex: the vertex of the mesh, or -1
    std::vector<EdgePath> polylines;  ///< by CAD edge; empty if the mesh does not follow it
};

/// Finds the mesh vertex at each CAD vertex, and the mesh edges along each CAD edge.
///
/// Between the mesh vertices at its ends, the polyline of a CAD edge is the path of mesh edges with the most vertices,
/// all near the edge and with increasing parameters on it: the longest path of a directed graph without circles. The
/// distance that counts as near is the smallest of four at which there is a path, from rounding to a thousandth of the
/// model's size, and at most a quarter of the shortest mesh edge at a vertex, so that it is never ambiguous by the mesh
/// itself.
EdgePaths find_edge_discretisation(geometry::Session& session, const SurfaceGraph& graph);

}  // namespace mq::given

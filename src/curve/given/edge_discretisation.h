// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/session.h"

namespace mq::curve {

/// A surface mesh as a graph: its vertices, and the mesh edges at each.
struct SurfaceGraph {
    const std::vector<Vec3>& points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::vector<int>> neighbours;  ///< by point, ascending; none of points inside
    std::vector<double> shortest;              ///< by point: length of the shortest mesh edge there, mm

    SurfaceGraph(const std::vector<Vec3>& points, std::vector<std::array<int, 3>> triangles);
};

/// The mesh edges that follow a CAD edge: its vertices in the order of the parameter. Closed ones begin and end with
/// the same vertex. A CAD edge that is one vertex of the mesh has that vertex only.
struct EdgePolyline {
    std::vector<int> vertices;
    double distance = 0.0;  ///< largest distance of its vertices from the CAD edge, mm
};

/// Distances of mesh vertices from the CAD, as fractions of the model's size: numbers of single precision or eight
/// digits in a file, then those of programs that place vertices less exactly.
constexpr std::array<double, 4> kNear{1e-6, 1e-5, 1e-4, 1e-3};

/// What of the model's vertices and edges the mesh has.
struct EdgeDiscretisation {
    std::vector<int> of_node;             ///< by CAD vertex: the vertex of the mesh, or -1
    std::vector<EdgePolyline> polylines;  ///< by CAD edge; empty where the mesh does not follow it
};

/// Finds the mesh vertex at each CAD vertex, and the mesh edges along each CAD edge.
///
/// Between the mesh vertices at its ends, the polyline of a CAD edge is the path of mesh edges with the most vertices,
/// all near the edge and with increasing parameters on it: the longest path of a directed graph without circles. The
/// distance that counts as near is the smallest of four at which there is a path, from rounding to a thousandth of the
/// model's size, and at most a quarter of the shortest mesh edge at a vertex, so that it is never ambiguous by the mesh
/// itself.
EdgeDiscretisation find_edge_discretisation(geometry::Session& session, const SurfaceGraph& graph);

}  // namespace mq::curve

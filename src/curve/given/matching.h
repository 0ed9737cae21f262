// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/error.h"
#include "curve/given/given_mesh.h"
#include "curve/surface/curved_surface.h"

namespace mq::curve {

/// A node of the given mesh that does not lie on its CAD entity.
struct MovedNode {
    int node = -1;
    double distance = 0.0;  ///< to the point of the entity where it is put, mm
};

/// Tetrahedra of several solids that share nodes, where the faces between these are not one in the model.
class SolidsShareNodes : public InvalidInput {
    using InvalidInput::InvalidInput;
};

/// A given mesh on the model: every vertex, edge and triangle of its surface is classified on a CAD vertex, edge or
/// face, every tetrahedron in a volume.
struct MatchedMesh {
    CurvedSurface surface;
    std::vector<int> vertex_of_node;  ///< by given node: the vertex of the surface, or -1
    std::vector<int> volume;          ///< by tetrahedron: the volume of the model; -1: they only lie on one another
    std::vector<MovedNode> moved;     ///< farther off than rounding; these are put on the CAD, all others stay
    std::vector<int> bare_faces;      ///< faces of volumes of which other faces have triangles, but these have none
    std::vector<int> given_node;      ///< by node: the given one that it is, or is a copy of
};

/// Classifies a sound mesh with tetrahedra of positive volume.
///
/// The CAD is followed from below: a mesh vertex at each CAD vertex, mesh edges along each CAD edge, and a face for
/// each region of triangles between these. Seams that the mesh does not follow stay inside their faces.
/// Where solids share faces in the model, and tetrahedra of several are joined, the solid of each is that which has its
/// centroid.
/// @throws SolidsShareNodes likewise where they share none; InvalidInput where the mesh and the model differ in scale
/// or place, naming the factor or the shift; TopologyError, GeometryError naming the entity and the place.
MatchedMesh match(geometry::Session& session, const GivenMesh& mesh, int order);

/// The same; triangles that it refuses are matched by body, where bodies touch that the shape keeps apart.
/// @param mesh  gets copies of nodes where bodies need their own, see separate_touching_bodies
MatchedMesh match_bodies(geometry::Session& session, GivenMesh& mesh, int order);

}  // namespace mq::curve

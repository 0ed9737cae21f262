// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/error.h"
#include "curve/surface/curved_surface.h"
#include "given/matching/given_mesh.h"

namespace mq::given {

/// A node of the given mesh that is off its CAD entity by more than rounding.
struct MovedNode {
    int node = -1;
    double distance = 0.0;  ///< mm: to the point of the entity on which it is put
};

/// Tetrahedra of several solids share nodes, and the faces between these solids are not shared in the model.
class SolidsShareNodes : public InvalidInput {
    using InvalidInput::InvalidInput;
};

/// A given mesh on the model: every vertex, edge and triangle of its surface is classified on a CAD vertex, edge or
/// face, and every tetrahedron in a volume.
struct MatchedMesh {
    curve::CurvedSurface surface;
    std::vector<int> vertex_of_node;  ///< by given node: the vertex of the surface, or -1
    std::vector<int> volume;          ///< by tetrahedron: the volume of the model; -1: not connected to the surface
    std::vector<MovedNode> moved;     ///< nodes off the CAD by more than rounding: these are put on it, all others stay
    std::vector<int> bare_faces;      ///< faces without triangles of volumes that have triangles on other faces
    std::vector<int> given_node;      ///< by node: the given node that it is, or that it is a copy of
};

/// Classifies a sound mesh whose tetrahedra have positive volumes.
///
/// Entities of low dimension come first: a mesh vertex is found for each CAD vertex, mesh edges along each CAD edge,
/// and a face for each region of triangles between these. Seams that the mesh does not follow stay inside of their
/// faces. If solids share faces in the model, and tetrahedra of several solids are joined, a tetrahedron belongs to the
/// solid that contains its centroid.
/// @throws SolidsShareNodes if tetrahedra of several solids are joined that share no face in the model; InvalidInput if
/// the mesh and the model differ in scale or place, naming the factor or the shift; TopologyError, GeometryError naming
/// the entity and the place.
MatchedMesh match(geometry::Session& session, const GivenMesh& mesh, int order);

/// Like match(). If match() refuses triangles, and bodies touch in the mesh that are apart in the shape, their shared
/// nodes are duplicated and each body is matched alone.
/// @param mesh  gets the copies of nodes, see separate_touching_bodies()
MatchedMesh match_bodies(geometry::Session& session, GivenMesh& mesh, int order);

}  // namespace mq::given

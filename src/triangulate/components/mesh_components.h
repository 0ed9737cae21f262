// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Connected components of a mesh as a mesh of their own, which can be changed while other threads change the others.
struct MeshComponent {
    ClassifiedMesh mesh;
    std::vector<int> triangles;  ///< indices in the whole mesh of the component's triangles at first, ascending
    std::vector<int> vertices;   ///< the same of its vertices
    std::vector<int> sites;      ///< the same of its sites
    std::vector<int> segments;   ///< the same of its segments
};

/// Divides a mesh into its connected components, the one with most expected work first: triangles with a common vertex,
/// or on faces of one body, are in the same one. Where there are more of them than `most`, small ones are together. No
/// index may be unused.
/// @param bodies  by CAD face: a number from 0 on, the same for the faces of a body, below the number of faces
/// @param work  by triangle: the work that is expected on it, in any unit
/// @param largest  fraction of the work that one component may have; none are returned where one has more
std::vector<MeshComponent> divide(const ClassifiedMesh& mesh, const std::vector<int>& bodies,
                                  const std::vector<double>& work, std::size_t most, double largest);

/// The mesh of which components were taken, with the changes that were made to them. Its former vertices, sites and
/// segments keep their indices.
struct JoinedComponents {
    ClassifiedMesh mesh;
    std::vector<int> first;  ///< by component: index of its first triangle; the others follow in the component's order
    std::vector<std::vector<int>> vertices;  ///< by component: indices of its vertices
};
/// @param changed  all components of `divided` after their changes; no index may be unused
JoinedComponents join(const ClassifiedMesh& divided, const std::vector<const MeshComponent*>& changed);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// The triangles of a body: those with a common vertex, or on faces of one volume or one face of the shape.
struct MeshBody {
    std::vector<int> triangles;  ///< ascending
    double work = 0.0;           ///< work that is expected on the triangles
};

/// Returns the bodies of a mesh without unused indices, the one with most expected work first.
/// @param together  by CAD face: a number from 0 on, the same for faces that are to be in one body, below the number
/// of faces
/// @param work  by triangle: the work that is expected on it, in any unit
std::vector<MeshBody> bodies_of(const ClassifiedMesh& mesh, const std::vector<int>& together,
                                const std::vector<double>& work);

/// Collects items, the one with most work first, in groups: one each, but small ones together where there are more than
/// `most`.
/// @param work  by item, descending
/// @return by group, the one with most work first: its items
std::vector<std::vector<int>> groups_of(const std::vector<double>& work, std::size_t most);

/// Bodies of a mesh as a mesh of their own, which can be changed while other threads change the others.
struct MeshComponent {
    ClassifiedMesh mesh;
    /// Indices in the whole mesh of the component's triangles at first, ascending but for copies of bodies.
    std::vector<int> triangles;
    /// By vertex at first: its index in the whole mesh, ascending but for those that have none, -1.
    std::vector<int> vertices;
    std::vector<int> sites;     ///< by site at first: its index in the whole mesh
    std::vector<int> segments;  ///< by segment at first: its index in the whole mesh
};

/// @param triangles  all those of some bodies, ascending
/// @throws Cancelled
MeshComponent component_of(const ClassifiedMesh& mesh, std::vector<int> triangles, const Progress* progress = nullptr);

/// The mesh of which components were taken, with the changes that were made to them. Its former vertices and sites keep
/// their indices; those that no component has are unused. Segments keep their indices if each is in a component.
struct JoinedComponents {
    ClassifiedMesh mesh;
    std::vector<int> first;  ///< by component: index of its first triangle; the others follow in the component's order
    std::vector<std::vector<int>> vertices;  ///< by component: indices of its vertices
};
/// @param changed  all components of `divided` after their changes, or what takes their place; no index may be unused
/// @throws Cancelled
JoinedComponents join(const ClassifiedMesh& divided, const std::vector<const MeshComponent*>& changed,
                      const Progress* progress = nullptr);

}  // namespace mq::triangulate

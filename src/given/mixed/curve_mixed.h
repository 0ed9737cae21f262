// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "curve/curve.h"
#include "given/mixed/mixed_mesh.h"

namespace mq::given {

/// Elements of one kind.
struct ElementBlock {
    elements::ElementKind kind = elements::ElementKind::Triangle;
    std::vector<std::int32_t> nodes;   ///< the nodes of one element after those of another, in Gmsh's order
    std::vector<std::int32_t> entity;  ///< by element: its volume, or its CAD face; -1: none
    std::vector<double> quality;       ///< by element: lower bound of min J / max |J|; not positive: not proven valid
    std::vector<std::int32_t> given;   ///< by element: its number in the given mesh; -1 for faces of solids
};

/// A curved mesh of elements of several kinds.
struct CurvedMixedMesh {
    int order = 1;
    std::vector<Vec3> nodes;  ///< the corners come first, in the order of the given nodes
    std::vector<ElementBlock> blocks;
    std::vector<std::int32_t> edges;  ///< mesh edges on CAD edges, order + 1 nodes each
    std::vector<std::int32_t> edge_entity;
    std::vector<std::int32_t> given_node;   ///< by corner: the given node
    std::vector<std::int32_t> moved_nodes;  ///< given nodes that were moved
    curve::CurveReport report;
};

/// Curves a mesh of any kinds of elements to the geometry of the model; elements and corners stay.
///
/// Nodes on CAD edges and faces are put on the CAD, and layers of prisms and hexahedra follow their walls (layers.h).
/// Elements that are not proven valid are then relaxed (node_relaxation.h), and straightened if `options.straighten` is
/// set.
/// @throws as match_faces_of(); InvalidInput.
CurvedMixedMesh curve_mixed(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                            const MixedMesh& given, const curve::CurveOptions& options, Progress* progress = nullptr);

}  // namespace mq::given

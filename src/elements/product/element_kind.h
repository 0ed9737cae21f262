// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

/// Elements that come from elsewhere: of any kind, with their nodes in Gmsh's order.
namespace mq::elements {

enum class ElementKind { Triangle, Quadrilateral, Tetrahedron, Pyramid, Prism, Hexahedron };

const char* name_of(ElementKind kind);
/// @throws InvalidInput where there is no kind of this name.
ElementKind element_kind(const std::string& name);

/// 2 for surface elements, 3 for solid ones.
int dimension_of(ElementKind kind);

/// Nodes of an element with all its inner nodes.
int full_node_count(ElementKind kind, int order);
/// Nodes of a serendipity element: corners and edges only. 0 where the kind has none of this order that is supported,
/// which are the quadrilateral of 8 nodes, the hexahedron of 20, the prism of 15 and the pyramid of 13.
int serendipity_node_count(ElementKind kind, int order);

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mq::mesh {

/// A kind of elements with a number of nodes, and its number or name in each format; 0 or "": the format lacks it.
struct ElementType {
    /// Orders of the nodes of order 2: by place in the file the place in Gmsh's order, as digits and then letters.
    /// Empty: Gmsh's own.
    struct NodeOrders {
        std::string_view rings{};   ///< VTK and Abaqus: edges below, above, between
        std::string_view levels{};  ///< Nastran: edges below, between, above
        std::string_view around{};  ///< I-DEAS: nodes on edges between the corners
    };

    std::string_view kind;  ///< "line", "triangle", "quadrilateral", "tetrahedron", "pyramid", "prism", "hexahedron"
    int dimension = 0;
    std::size_t corners = 0;
    int order = 0;
    std::size_t nodes = 0;
    int gmsh = 0;
    int vtk = 0;
    int unv = 0;
    std::string_view abaqus{};
    std::string_view nastran{};
    NodeOrders orders{};
};

/// All types of elements, which are Gmsh's up to order 5 and its serendipity elements of order 2.
const std::vector<ElementType>& element_types();

/// @throws InvalidInput for one that is not in the table
const ElementType& element_type(std::string_view kind, std::size_t nodes);

/// The entries of one of ElementType::NodeOrders as numbers; `count` of them where it is empty.
std::vector<std::size_t> places_of(std::string_view order, std::size_t count);

}  // namespace mq::mesh

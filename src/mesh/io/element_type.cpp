// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/element_type.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::mesh {

const std::vector<ElementType>& element_types() {
    // kind, dimension, corners, order, nodes; numbers of Gmsh, VTK (Lagrange cells from order 3 on) and I-DEAS; names
    // of Abaqus and Nastran; orders of nodes
    // clang-format off
    static const auto& types = never_destroyed<std::vector<ElementType>>({
        {"line", 1, 2, 1, 2, 1, 3, 21, "B31", "CBAR"},
        {"line", 1, 2, 2, 3, 8, 21, 24, "B32", "", {"", "", "021"}},
        {"line", 1, 2, 3, 4, 26, 68},
        {"line", 1, 2, 4, 5, 27, 68},
        {"line", 1, 2, 5, 6, 28, 68},
        {"triangle", 2, 3, 1, 3, 2, 5, 91, "S3", "CTRIA3"},
        {"triangle", 2, 3, 2, 6, 9, 22, 92, "S6", "CTRIA6", {"", "", "031425"}},
        {"triangle", 2, 3, 3, 10, 21, 69},
        {"triangle", 2, 3, 4, 15, 23, 69},
        {"triangle", 2, 3, 5, 21, 25, 69},
        {"quadrilateral", 2, 4, 1, 4, 3, 9, 94, "S4", "CQUAD4"},
        {"quadrilateral", 2, 4, 2, 8, 16, 23, 95, "S8", "CQUAD8", {"", "", "04152637"}},
        {"quadrilateral", 2, 4, 2, 9, 10, 28},
        {"quadrilateral", 2, 4, 3, 16, 36, 70},
        {"quadrilateral", 2, 4, 4, 25, 37, 70},
        {"quadrilateral", 2, 4, 5, 36, 38, 70},
        {"tetrahedron", 3, 4, 1, 4, 4, 10, 111, "C3D4", "CTETRA"},
        {"tetrahedron", 3, 4, 2, 10, 11, 24, 118, "C3D10", "CTETRA", {"0123456798", "0123456798", "0415267983"}},
        {"tetrahedron", 3, 4, 3, 20, 29, 71},
        {"tetrahedron", 3, 4, 4, 35, 30, 71},
        {"tetrahedron", 3, 4, 5, 56, 31, 71},
        {"pyramid", 3, 5, 1, 5, 7, 14, 0, "C3D5", "CPYRAM"},
        {"pyramid", 3, 5, 2, 13, 19, 27, 0, "", "CPYRAM", {"0123458a679bc", "0123458a679bc", ""}},
        {"pyramid", 3, 5, 2, 14, 14, 0},
        {"pyramid", 3, 5, 3, 30, 118, 0},
        {"pyramid", 3, 5, 4, 55, 119, 0},
        {"pyramid", 3, 5, 5, 91, 120, 0},
        {"prism", 3, 6, 1, 6, 6, 13, 112, "C3D6", "CPENTA"},
        {"prism", 3, 6, 2, 15, 18, 26, 113, "C3D15", "CPENTA", {"012345697ced8ab", "0123456978abced", "0619278ab3c4e5d"}},
        {"prism", 3, 6, 2, 18, 13, 32, 0, "", "", {"012345697ced8abfhg", "", ""}},
        {"prism", 3, 6, 3, 40, 90, 73},
        {"prism", 3, 6, 4, 75, 91, 73},
        {"prism", 3, 6, 5, 126, 106, 73},
        {"hexahedron", 3, 8, 1, 8, 5, 12, 115, "C3D8", "CHEXA"},
        {"hexahedron", 3, 8, 2, 20, 17, 25, 116, "C3D20", "CHEXA", {"012345678bd9gijhacef", "012345678bd9acefgijh", "081b2d39acef4g5i6j7h"}},
        {"hexahedron", 3, 8, 2, 27, 12, 29, 0, "", "", {"012345678bd9gijhacefmnlokpq", "", ""}},
        {"hexahedron", 3, 8, 3, 64, 92, 72},
        {"hexahedron", 3, 8, 4, 125, 93, 72},
        {"hexahedron", 3, 8, 5, 216, 94, 72},
    });
    // clang-format on
    return types;
}

const ElementType& element_type(std::string_view kind, std::size_t nodes) {
    const std::vector<ElementType>& all = element_types();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const ElementType& type) { return type.kind == kind && type.nodes == nodes; });
    if (found == all.end()) {
        throw InvalidInput(phrases::kNoSuchElements, {{"kind", std::string(kind)}, {"count", nodes}});
    }
    return *found;
}

std::vector<std::size_t> places_of(std::string_view order, std::size_t count) {
    std::vector<std::size_t> places(count);
    std::iota(places.begin(), places.end(), std::size_t{0});
    for (std::size_t i = 0; i < order.size(); ++i) {
        places[i] = static_cast<std::size_t>(order[i] <= '9' ? order[i] - '0' : order[i] - 'a' + 10);
    }
    return places;
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/element_kind.h"

#include <array>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::elements {

namespace {

constexpr std::array<const char*, 6> kNames{"triangle", "quadrilateral", "tetrahedron",
                                            "pyramid",  "prism",         "hexahedron"};

}  // namespace

const char* name_of(ElementKind kind) {
    return kNames[static_cast<std::size_t>(kind)];
}

ElementKind element_kind(const std::string& name) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (name == kNames[i]) {
            return static_cast<ElementKind>(i);
        }
    }
    throw InvalidInput(phrases::kNoSuchKind, {{"value", name}});
}

int dimension_of(ElementKind kind) {
    return kind == ElementKind::Triangle || kind == ElementKind::Quadrilateral ? 2 : 3;
}

int full_node_count(ElementKind kind, int order) {
    const int n = order + 1;
    switch (kind) {
        case ElementKind::Triangle:
            return n * (n + 1) / 2;
        case ElementKind::Quadrilateral:
            return n * n;
        case ElementKind::Tetrahedron:
            return n * (n + 1) * (n + 2) / 6;
        case ElementKind::Pyramid:
            return n * (n + 1) * (2 * n + 1) / 6;
        case ElementKind::Prism:
            return n * n * (n + 1) / 2;
        case ElementKind::Hexahedron:
            break;
    }
    return n * n * n;
}

int serendipity_node_count(ElementKind kind, int order) {
    if (order != 2) {
        return 0;
    }
    switch (kind) {
        case ElementKind::Quadrilateral:
            return 8;
        case ElementKind::Pyramid:
            return 13;
        case ElementKind::Prism:
            return 15;
        case ElementKind::Hexahedron:
            return 20;
        case ElementKind::Triangle:
        case ElementKind::Tetrahedron:
            break;
    }
    return 0;
}

}  // namespace mq::elements

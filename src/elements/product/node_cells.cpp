// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/product/node_cells.h"

#include <algorithm>
#include <map>
#include <string>

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/simplex_lattice.h"
#include "elements/product/reference_nodes.h"

namespace mq::elements {

namespace {

using Cells = std::vector<std::array<int, 4>>;

constexpr std::array<ElementKind, 4> kSolids{ElementKind::Tetrahedron, ElementKind::Pyramid, ElementKind::Prism,
                                             ElementKind::Hexahedron};

GridPoint in_space(ElementKind kind, int order, const GridPoint& p) {
    switch (kind) {
        case ElementKind::Tetrahedron:
            return {p[0] + p[1] + p[2], p[1] + p[2], p[2]};
        case ElementKind::Prism:
            return {p[0] + p[1], p[1], p[2]};
        case ElementKind::Pyramid: {
            const int level = order - p[2];
            return {level, (p[0] + level) / 2, (p[1] + level) / 2};
        }
        default:
            return p;
    }
}

Cells cells_of(ElementKind kind, int order) {
    std::map<GridPoint, int> numbers;
    for (const GridPoint& p : gmsh_nodes(kind, order)) {
        const auto number = static_cast<int>(numbers.size());
        numbers.emplace(in_space(kind, order, p), number);
    }
    Cells cells;
    for (const auto& [first, number] : numbers) {
        std::array<std::size_t, 3> axes{0, 1, 2};
        do {
            GridPoint p = first;
            std::array<int, 4> cell{number, -1, -1, -1};
            for (std::size_t k = 0; k < 3; ++k) {
                ++p[axes[k]];
                const auto found = numbers.find(p);
                cell[k + 1] = found == numbers.end() ? -1 : found->second;
            }
            if (std::find(cell.begin(), cell.end(), -1) == cell.end()) {
                cells.push_back(cell);
            }
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    return cells;
}

}  // namespace

const Cells& node_cells(ElementKind kind, int order) {
    static const auto& all = never_destroyed([] {
        std::vector<Cells> cells;
        for (const ElementKind solid : kSolids) {
            for (int p = 1; p <= kMaxOrder; ++p) {
                cells.push_back(cells_of(solid, p));
            }
        }
        return cells;
    }());
    if (dimension_of(kind) != 3 || order < 1 || order > kMaxOrder) {
        throw InvalidInput(phrases::kNotDivided,
                           {{"kind", std::string(name_of(kind))}, {"count", order}, {"count2", kMaxOrder}});
    }
    const auto solid = std::find(kSolids.begin(), kSolids.end(), kind) - kSolids.begin();
    return all[static_cast<std::size_t>(solid * kMaxOrder + order - 1)];
}

}  // namespace mq::elements

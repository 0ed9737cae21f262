// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/side_rows.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/key_set.h"
#include "base/memory/never_destroyed.h"
#include "elements/product/reference_nodes.h"

namespace mq::given {

using elements::ElementKind;

namespace {

using Corners = std::vector<std::int32_t>;

Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Sets the position of each corner of each side along its column.
void measure(SideRow& row, const std::vector<Vec3>& nodes) {
    const std::size_t count = row.sides.front().size();
    std::vector<double> length(count, 0.0);
    row.fractions.assign(1, length);
    for (std::size_t k = 1; k < row.sides.size(); ++k) {
        for (std::size_t c = 0; c < count; ++c) {
            length[c] += (nodes[static_cast<std::size_t>(row.sides[k][c])] -
                          nodes[static_cast<std::size_t>(row.sides[k - 1][c])])
                             .norm();
        }
        row.fractions.push_back(length);
    }
    for (std::size_t c = 0; c < count; ++c) {
        row.height += length[c] / static_cast<double>(count);
        for (auto& of_side : row.fractions) {
            of_side[c] /= length[c] > 0.0 ? length[c] : 1.0;
        }
    }
}

/// Keeps a row, unless both of its ends are on the CAD and it has no sides between them or is kept in the other
/// direction.
void keep(SideRow row, const std::vector<Vec3>& nodes, const OnCad& on_cad, std::vector<SideRow>& rows) {
    row.ends_on_cad = on_cad(row.sides.back());
    const Corners first = sorted(row.sides.front());
    const Corners last = sorted(row.sides.back());
    if (row.ends_on_cad && (row.sides.size() < 3 || last < first || last == first)) {
        return;
    }
    measure(row, nodes);
    rows.push_back(std::move(row));
}

class EdgeRows {
  public:
    explicit EdgeRows(const std::vector<RowQuadrilateral>& quadrilaterals) : all_(quadrilaterals) {
        for (std::size_t q = 0; q < all_.size(); ++q) {
            for (std::size_t k = 0; k < 4; ++k) {
                at_edge_[pair_key(all_[q].corners[k], all_[q].corners[(k + 1) % 4])].push_back(q);
            }
        }
    }

    SideRow from(std::size_t q, std::size_t side, const OnCad& on_cad) const {
        SideRow row;
        row.sides.push_back({all_[q].corners[side], all_[q].corners[(side + 1) % 4]});
        row.sides.push_back(opposite(q, row.sides.back()));
        std::set<std::size_t> passed{q};
        while (!on_cad(row.sides.back())) {
            const std::optional<std::size_t> next = beyond(q, row.sides.back());
            if (!next || !passed.insert(*next).second) {
                break;
            }
            q = *next;
            row.sides.push_back(opposite(q, row.sides.back()));
        }
        return row;
    }

  private:
    Corners opposite(std::size_t q, const Corners& edge) const {
        const auto& c = all_[q].corners;
        const auto k = static_cast<std::size_t>(std::find(c.begin(), c.end(), edge[0]) - c.begin());
        return c[(k + 1) % 4] == edge[1] ? Corners{c[(k + 3) % 4], c[(k + 2) % 4]}
                                         : Corners{c[(k + 1) % 4], c[(k + 2) % 4]};
    }

    std::optional<std::size_t> beyond(std::size_t q, const Corners& edge) const {
        std::optional<std::size_t> found;
        for (const std::size_t other : at_edge_.at(pair_key(edge[0], edge[1]))) {
            if (other == q || share_an_element(all_[q], all_[other])) {
                continue;
            }
            if (found) {
                return std::nullopt;
            }
            found = other;
        }
        return found;
    }

    static bool share_an_element(const RowQuadrilateral& a, const RowQuadrilateral& b) {
        return std::any_of(a.elements.begin(), a.elements.end(), [&](std::int64_t element) {
            return element >= 0 && (element == b.elements[0] || element == b.elements[1]);
        });
    }

    const std::vector<RowQuadrilateral>& all_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>, KeyHash> at_edge_;
};

/// The face of a prism or a hexahedron opposite to the face with these corners; corresponding corners are in the same
/// columns. Empty if the given face is a side of a prism, or the element has no opposite faces.
Corners opposite_face(const MixedElement& element, const Corners& face) {
    static const auto& prism = never_destroyed<std::vector<std::array<std::size_t, 2>>>({{0, 3}, {1, 4}, {2, 5}});
    static const auto& hexahedron = never_destroyed<std::array<std::vector<std::array<std::size_t, 2>>, 3>>({{
        {{0, 1}, {3, 2}, {4, 5}, {7, 6}},
        {{0, 3}, {1, 2}, {4, 7}, {5, 6}},
        {{0, 4}, {1, 5}, {2, 6}, {3, 7}},
    }});
    const auto across = [&](const std::vector<std::array<std::size_t, 2>>& columns) {
        Corners result;
        for (const std::int32_t corner : face) {
            for (const auto& [low, high] : columns) {
                if (element.corners[low] == corner) {
                    result.push_back(element.corners[high]);
                } else if (element.corners[high] == corner) {
                    result.push_back(element.corners[low]);
                }
            }
        }
        const bool apart = std::none_of(result.begin(), result.end(), [&](std::int32_t corner) {
            return std::count(face.begin(), face.end(), corner) > 0;
        });
        return result.size() == face.size() && apart ? result : Corners();
    };
    if (element.kind == ElementKind::Prism && face.size() == 3) {
        return across(prism);
    }
    if (element.kind == ElementKind::Hexahedron) {
        for (const auto& columns : hexahedron) {
            if (Corners result = across(columns); !result.empty()) {
                return result;
            }
        }
    }
    return {};
}

}  // namespace

std::vector<SideRow> rows_of_edges(const std::vector<RowQuadrilateral>& quadrilaterals, const std::vector<Vec3>& nodes,
                                   const OnCad& on_cad) {
    const EdgeRows all(quadrilaterals);
    std::vector<SideRow> rows;
    for (std::size_t q = 0; q < quadrilaterals.size(); ++q) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (on_cad({quadrilaterals[q].corners[k], quadrilaterals[q].corners[(k + 1) % 4]})) {
                keep(all.from(q, k, on_cad), nodes, on_cad, rows);
            }
        }
    }
    return rows;
}

std::vector<SideRow> rows_of_faces(const MixedMesh& mesh, const OnCad& on_cad) {
    std::map<Corners, std::vector<std::size_t>> elements;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const ElementKind kind = mesh.elements[e].kind;
        for (std::size_t f = 0; f < elements::sides_of(kind).faces.size(); ++f) {
            if (kind == ElementKind::Prism || kind == ElementKind::Hexahedron) {
                elements[sorted(face_corners(mesh.elements[e], f))].push_back(e);
            }
        }
    }
    std::vector<SideRow> rows;
    for (std::size_t start = 0; start < mesh.elements.size(); ++start) {
        for (std::size_t f = 0; f < elements::sides_of(mesh.elements[start].kind).faces.size(); ++f) {
            const Corners wall = face_corners(mesh.elements[start], f);
            Corners next = opposite_face(mesh.elements[start], wall);
            if (next.empty() || !on_cad(wall)) {
                continue;
            }
            SideRow row;
            row.sides = {wall, next};
            std::size_t e = start;
            std::set<std::size_t> passed{e};
            while (!on_cad(row.sides.back())) {
                const std::vector<std::size_t>& beside = elements.at(sorted(row.sides.back()));
                const auto other = std::find_if(beside.begin(), beside.end(), [&](std::size_t b) { return b != e; });
                if (other == beside.end() || !passed.insert(*other).second) {
                    break;
                }
                e = *other;
                next = opposite_face(mesh.elements[e], row.sides.back());
                if (next.empty()) {
                    break;
                }
                row.sides.push_back(std::move(next));
            }
            keep(std::move(row), mesh.nodes, on_cad, rows);
        }
    }
    return rows;
}

}  // namespace mq::given

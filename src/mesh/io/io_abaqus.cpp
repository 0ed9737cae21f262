// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/memory/never_destroyed.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// CalculiX reads no number of more characters.
constexpr std::size_t kLongest = 20;

/// Number of digits that always fits, whatever the sign and exponent.
constexpr int kDigits = 13;

/// Appends a number with all its digits if these fit, so that reading gives the same number; else with fewer digits.
void append_real(Output& out, double value) {
    std::array<char, 40> text;
    const auto first = text.data();
    auto last = std::to_chars(first, first + text.size(), value).ptr;
    if (static_cast<std::size_t>(last - first) > kLongest) {
        last = std::to_chars(first, first + text.size(), value, std::chars_format::general, kDigits).ptr;
    }
    out.append(first, static_cast<std::size_t>(last - first));
}

constexpr std::size_t kPerLine =
    8;  ///< numbers of a set in one line; Abaqus takes 16, and 132 characters are CalculiX's

/// Suffix of the name of a patch's sides: CalculiX 2.20 ends if a surface has the name of a set.
constexpr const char* kSurface = "_surface";

void append_set(Output& out, const std::string& head, const std::vector<std::int32_t>& numbers) {
    if (numbers.empty()) {
        return;
    }
    out += head;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out.append_number(static_cast<long long>(numbers[i]) + 1);
        out += (i + 1) % kPerLine == 0 || i + 1 == numbers.size() ? "\n" : ", ";
    }
}

/// Elements of one block, in a set of that name unless it is empty.
class ElementLines {
  public:
    ElementLines(Output& out, const NumberedElements& block, const std::string& set) : out_(out), block_(block) {
        const ElementType& type = *block.elements->type;
        // The middle node of a line comes between the others.
        places_ = places_of(type.dimension == 1 ? type.orders.around : type.orders.rings, type.nodes);
        out_ += "*ELEMENT, TYPE=" + std::string(type.abaqus) + (set.empty() ? "" : ", ELSET=" + set) + "\n";
    }

    void append(std::size_t k) const {
        constexpr std::size_t kMostNumbers = 16,
                              kFirst = 10;  // a line has at most 16 numbers, with that of the element
        out_.append_number(block_.first + k);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            out_ += places_.size() >= kMostNumbers && i == kFirst ? ",\n" : ",";
            out_.append_number(block_.elements->of(k)[places_[i]] + 1);
        }
        out_ += '\n';
    }

  private:
    Output& out_;
    const NumberedElements& block_;
    std::vector<std::size_t> places_;
};

void append_elements(Output& out, const ExportMesh& mesh, const std::vector<NumberedElements>& blocks) {
    if (mesh.is_given()) {
        for (const NumberedElements& block : blocks) {
            const ElementLines lines(out, block, "");
            for (std::size_t k = 0; k < block.elements->size(); ++k) {
                lines.append(k);
            }
        }
        return;
    }
    for (const Members& group : divided(mesh, blocks)) {
        if (!group.elements.empty()) {
            const ElementLines lines(out, *group.elements.front().first, group.name);
            for (const auto& [block, k] : group.elements) {
                lines.append(static_cast<std::size_t>(k));
            }
        }
    }
}

/// The key of a side: its lowest three corners, and the number of its corners.
using Side = std::array<std::int32_t, 4>;

Side side_of(const std::int32_t* nodes, std::string_view corners) {
    std::array<std::int32_t, 4> sorted{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sorted[i] = nodes[corners[i] - '0'];
    }
    std::sort(sorted.begin(), sorted.begin() + corners.size());
    return {sorted[0], sorted[1], sorted[2], static_cast<std::int32_t>(corners.size())};
}

/// The side of a face of a group.
Side face_of(const NumberedElements& block, std::int32_t k) {
    return side_of(block.elements->of(static_cast<std::size_t>(k)),
                   block.elements->type->corners == 3 ? "012" : "0123");
}

/// The sides of volume elements, S1 and on, by the corners of each.
const std::vector<std::string_view>& sides_of(const ElementType& type) {
    static const auto& sides = never_destroyed<std::map<std::size_t, std::vector<std::string_view>>>(
        {{4, {"012", "013", "123", "023"}},
         {5, {"0123", "014", "124", "234", "034"}},
         {6, {"012", "345", "0143", "1254", "0352"}},
         {8, {"0123", "4567", "0154", "1265", "2376", "0473"}}});
    return sides.at(type.corners);
}

struct SideHash {
    std::size_t operator()(const Side& side) const {
        std::size_t hash = 0;
        for (const std::int32_t part : side) {
            hash = hash * 0x9E3779B97F4A7C15U + static_cast<std::size_t>(part);  // 2^64 by the golden ratio
        }
        return hash ^ hash >> 32;
    }
};

using Behind = std::unordered_map<Side, std::pair<std::size_t, int>, SideHash>;

/// The element of lowest number, and its side, of each face in a group; 0: none.
Behind elements_behind(const std::vector<Members>& groups, const std::vector<NumberedElements>& volumes) {
    Behind found;
    for (const Members& group : groups) {
        for (const auto& [block, k] : group.elements) {
            if (block->elements->type->dimension == 2) {
                found[face_of(*block, k)] = {};
            }
        }
    }
    for (const NumberedElements& block : volumes) {
        const std::vector<std::string_view>& sides = sides_of(*block.elements->type);
        for (std::size_t k = 0; k < block.elements->size(); ++k) {
            for (std::size_t s = 0; s < sides.size(); ++s) {
                const auto face = found.find(side_of(block.elements->of(k), sides[s]));
                if (face != found.end() && face->second.first == 0) {
                    face->second = {block.first + k, static_cast<int>(s) + 1};
                }
            }
        }
    }
    return found;
}

/// The elements of each group, and the sides that make up its faces, for pressures and contacts.
void append_groups(Output& out, const ExportMesh& mesh, const std::vector<Members>& groups,
                   const std::vector<NumberedElements>& elements) {
    const bool solid = mesh.dimension() == 3;
    const Behind behind = solid ? elements_behind(groups, elements) : Behind();
    for (const Members& group : groups) {
        std::vector<std::int32_t> members;
        std::vector<std::pair<std::size_t, int>> sides;
        for (const auto& [block, k] : group.elements) {
            const int dimension = block->elements->type->dimension;
            if (dimension == mesh.dimension() && mesh.is_given()) {
                members.push_back(static_cast<std::int32_t>(block->first) - 1 + k);
            }
            if (const auto face = solid && dimension == 2 ? behind.find(face_of(*block, k)) : behind.end();
                face != behind.end() && face->second.first > 0) {
                sides.push_back(face->second);
                members.push_back(static_cast<std::int32_t>(face->second.first) - 1);
            }
        }
        std::sort(members.begin(), members.end());
        members.erase(std::unique(members.begin(), members.end()), members.end());
        append_set(out, "*ELSET, ELSET=" + group.name + "\n", members);
        if (!sides.empty()) {
            out += "*SURFACE, NAME=" + group.name + kSurface + ", TYPE=ELEMENT\n";
        }
        for (const auto& [element, side] : sides) {
            out.append_number(element);
            out += ", S";
            out.append_number(side);
            out += '\n';
        }
    }
}

}  // namespace

void to_abaqus(Output& out, const ExportMesh& mesh) {
    out += "*HEADING\nMeshQuality\n*NODE\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        out.append_number(static_cast<long long>(i) + 1);
        const Vec3 p = mesh.point(i);
        for (int axis = 0; axis < 3; ++axis) {
            out += ", ";
            append_real(out, p[axis]);
        }
        out += '\n';
    }
    const std::vector<NumberedElements> elements = mesh.numbered(mesh.dimension());
    append_elements(out, mesh, elements);
    std::vector<NumberedElements> all = elements;
    const std::vector<NumberedElements> below = mesh.numbered(mesh.lowest(3), mesh.dimension() - 1);
    all.insert(all.end(), below.begin(), below.end());
    const std::vector<Members> groups = members_of(mesh, all);
    for (const Members& group : groups) {
        append_set(out, "*NSET, NSET=" + group.name + "\n", group.nodes);
    }
    append_groups(out, mesh, groups, elements);
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/mixed_mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/product/reference_nodes.h"

namespace mq::given {

using elements::ElementKind;

namespace {

void require_nodes(const MixedMesh& mesh, const std::vector<MixedElement>& elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::string kind(elements::name_of(elements[i].kind));
        std::vector<std::int32_t> corners(
            elements[i].corners.begin(),
            elements[i].corners.begin() + static_cast<std::ptrdiff_t>(elements[i].count()));
        std::sort(corners.begin(), corners.end());
        if (corners.front() < 0 || static_cast<std::size_t>(corners.back()) >= mesh.nodes.size()) {
            throw InvalidInput(phrases::kGivenNode, {{"kind", kind}, {"count", i}});
        }
        if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
            throw InvalidInput(phrases::kGivenNodeTwice, {{"kind", kind}, {"count", i}});
        }
        for (const std::int32_t v : corners) {
            if (!mesh.nodes[static_cast<std::size_t>(v)].allFinite()) {
                throw InvalidInput(phrases::kGivenNotFinite, {{"kind", kind}, {"count", i}});
            }
        }
    }
}

}  // namespace

void require_sound(const MixedMesh& mesh) {
    if (mesh.elements.empty()) {
        throw InvalidInput(phrases::kGivenEmpty);
    }
    require_nodes(mesh, mesh.elements);
    require_nodes(mesh, mesh.listed);
}

std::vector<std::int32_t> face_corners(const MixedElement& element, std::size_t face) {
    std::vector<std::int32_t> corners;
    for (const std::size_t k : elements::sides_of(element.kind).faces[face]) {
        corners.push_back(element.corners[k]);
    }
    return corners;
}

std::vector<std::array<int, 3>> triangles_of(const std::vector<std::int32_t>& corners) {
    if (corners.size() == 3) {
        return {{corners[0], corners[1], corners[2]}};
    }
    const auto low = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) - corners.begin());
    const auto at = [&](std::size_t k) { return corners[(low + k) % 4]; };
    return {{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};
}

Simplices divided_into_simplices(const MixedMesh& mesh) {
    Simplices result;
    result.mesh.nodes = mesh.nodes;
    const bool volume = mesh.has_volume();
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
        const MixedElement& element = mesh.elements[i];
        const std::int32_t* corners = element.corners.data();
        const std::int32_t low = *std::min_element(corners, corners + element.count());
        for (std::size_t f = 0; f < elements::sides_of(element.kind).faces.size(); ++f) {
            const std::vector<std::int32_t> face = face_corners(element, f);
            if (volume && std::count(face.begin(), face.end(), low) > 0) {
                continue;
            }
            for (const auto& t : triangles_of(face)) {
                if (volume) {
                    result.mesh.tetrahedra.push_back({low, t[0], t[1], t[2]});
                    result.mesh.regions.push_back(element.region);
                } else {
                    result.mesh.triangles.push_back(t);
                }
                result.element.push_back(i);
            }
        }
    }
    for (const MixedElement& element : mesh.listed) {
        const auto triangles = triangles_of(face_corners(element, 0));
        result.mesh.triangles.insert(result.mesh.triangles.end(), triangles.begin(), triangles.end());
    }
    return result;
}

std::size_t orient_elements(MixedMesh& mesh) {
    if (!mesh.has_volume()) {
        return 0;
    }
    static const auto& mirrored = never_destroyed<std::map<ElementKind, std::array<std::size_t, 8>>>(
        {{ElementKind::Tetrahedron, {0, 1, 3, 2, 4, 5, 6, 7}},
         {ElementKind::Pyramid, {0, 3, 2, 1, 4, 5, 6, 7}},
         {ElementKind::Prism, {3, 4, 5, 0, 1, 2, 6, 7}},
         {ElementKind::Hexahedron, {4, 5, 6, 7, 0, 1, 2, 3}}});
    Simplices simplices = divided_into_simplices(mesh);
    const std::vector<std::array<int, 4>> before = simplices.mesh.tetrahedra;
    orient_tetrahedra(simplices.mesh);
    std::set<std::size_t> turned;
    for (std::size_t t = 0; t < before.size(); ++t) {
        if (before[t] != simplices.mesh.tetrahedra[t] && turned.insert(simplices.element[t]).second) {
            MixedElement& element = mesh.elements[simplices.element[t]];
            const std::array<std::int32_t, 8> corners = element.corners;
            for (std::size_t k = 0; k < 8; ++k) {
                element.corners[k] = corners[mirrored.at(element.kind)[k]];
            }
        }
    }
    return turned.size();
}

}  // namespace mq::given

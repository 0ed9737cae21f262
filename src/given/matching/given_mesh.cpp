// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/given_mesh.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/volume/tetrahedral_mesh.h"
#include "elements/bezier/curved_shapes.h"

namespace mq::given {

namespace {

template <std::size_t N>
void require_nodes(const std::vector<std::array<int, N>>& elements, const GivenMesh& mesh, const char* kind) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::array<int, N> sorted = elements[i];
        std::sort(sorted.begin(), sorted.end());
        if (sorted.front() < 0 || static_cast<std::size_t>(sorted.back()) >= mesh.nodes.size()) {
            throw InvalidInput(phrases::kGivenNode, {{"kind", kind}, {"count", i}});
        }
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            throw InvalidInput(phrases::kGivenNodeTwice, {{"kind", kind}, {"count", i}});
        }
        for (const int v : sorted) {
            if (!mesh.nodes[static_cast<std::size_t>(v)].allFinite()) {
                throw InvalidInput(phrases::kGivenNotFinite, {{"kind", kind}, {"count", i}});
            }
        }
    }
}

/// A face of two tetrahedra, with the corners in the order in which it is seen from outside of the first one.
struct SharedFace {
    elements::FaceKey key;
    std::size_t tetrahedron;
    std::array<int, 3> outward;
};

std::vector<SharedFace> sorted_faces(const GivenMesh& mesh) {
    std::vector<SharedFace> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        for (const auto& outward : curve::outward_faces(mesh.tetrahedra[t])) {
            faces.push_back({elements::face_key(outward[0], outward[1], outward[2]), t, outward});
        }
    }
    std::sort(faces.begin(), faces.end(), [](const SharedFace& a, const SharedFace& b) {
        return std::tie(a.key, a.tetrahedron) < std::tie(b.key, b.tetrahedron);
    });
    return faces;
}

double six_volumes(const GivenMesh& mesh, const std::array<int, 4>& t) {
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(t[k])]; };
    return (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0));
}

}  // namespace

void require_sound(const GivenMesh& mesh) {
    if (mesh.triangles.empty() && mesh.tetrahedra.empty()) {
        throw InvalidInput(phrases::kGivenNothing);
    }
    if (!mesh.regions.empty() && mesh.regions.size() != mesh.tetrahedra.size()) {
        throw InvalidInput(phrases::kOneForEach,
                           {{"name", "regions"}, {"count", mesh.regions.size()}, {"count2", mesh.tetrahedra.size()}});
    }
    require_nodes(mesh.triangles, mesh, "triangle");
    require_nodes(mesh.tetrahedra, mesh, "tetrahedron");
}

std::size_t orient_tetrahedra(GivenMesh& mesh) {
    const std::vector<SharedFace> faces = sorted_faces(mesh);
    std::vector<std::vector<std::pair<std::size_t, bool>>> beside(
        mesh.tetrahedra.size());  // whether both neighbours see the face alike, too
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        if (faces[i].key == faces[i + 1].key) {
            const bool alike = same_turn(faces[i].outward, faces[i + 1].outward);
            beside[faces[i].tetrahedron].emplace_back(faces[i + 1].tetrahedron, alike);
            beside[faces[i + 1].tetrahedron].emplace_back(faces[i].tetrahedron, alike);
        }
    }
    std::vector<char> met(mesh.tetrahedra.size(), 0);
    std::vector<char> turned(mesh.tetrahedra.size(), 0);
    for (std::size_t start = 0; start < met.size(); ++start) {
        if (met[start]) {
            continue;
        }
        std::vector<std::size_t> body{start};
        met[start] = 1;
        double volume = 0.0;
        for (std::size_t i = 0; i < body.size(); ++i) {
            const std::size_t t = body[i];
            volume += (turned[t] ? -1.0 : 1.0) * six_volumes(mesh, mesh.tetrahedra[t]);
            for (const auto& [other, alike] : beside[t]) {
                if (!met[other]) {
                    met[other] = 1;
                    turned[other] = static_cast<char>(turned[t] != (alike ? 1 : 0));
                    body.push_back(other);
                }
            }
        }
        for (const std::size_t t : body) {
            turned[t] = static_cast<char>(turned[t] != (volume < 0.0 ? 1 : 0));
        }
    }
    for (std::size_t t = 0; t < turned.size(); ++t) {
        if (turned[t]) {
            std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
        }
    }
    return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
}

bool same_turn(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
    return b[(at + 1) % 3] == a[1];
}

std::vector<std::array<int, 3>> surface_of(const GivenMesh& mesh) {
    if (mesh.tetrahedra.empty()) {
        return mesh.triangles;
    }
    const std::vector<SharedFace> faces = sorted_faces(mesh);
    std::set<elements::FaceKey> listed;
    for (const auto& t : mesh.triangles) {
        listed.insert(elements::face_key(t[0], t[1], t[2]));
    }
    const auto region = [&](const SharedFace& face) {
        return mesh.regions.empty() ? 0 : mesh.regions[face.tetrahedron];
    };
    std::vector<std::array<int, 3>> result;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].key == faces[i].key) {
            ++end;
        }
        if (end - i > 2) {
            throw InvalidInput(phrases::kManyTetrahedra,
                               {{"count", faces[i].key[0]}, {"count2", faces[i].key[1]}, {"count3", faces[i].key[2]}});
        }
        if (end - i == 1 || region(faces[i]) != region(faces[i + 1]) || listed.count(faces[i].key) > 0) {
            result.push_back(faces[i].outward);
        }
        i = end;
    }
    return result;
}

}  // namespace mq::given

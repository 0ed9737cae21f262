// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/given/given_mesh.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "curve/bezier/curved_shapes.h"

namespace mq::curve {

namespace {

template <std::size_t N>
void require_nodes(const std::vector<std::array<int, N>>& elements, const GivenMesh& mesh, const char* kind) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::string name = std::string(kind) + " " + std::to_string(i);
        std::array<int, N> sorted = elements[i];
        std::sort(sorted.begin(), sorted.end());
        if (sorted.front() < 0 || static_cast<std::size_t>(sorted.back()) >= mesh.nodes.size()) {
            throw InvalidInput(name + " of the given mesh has a node that the mesh does not: write the mesh anew");
        }
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            throw InvalidInput(name + " of the given mesh has one node twice: remove it from the mesh");
        }
        for (const int v : sorted) {
            if (!mesh.nodes[static_cast<std::size_t>(v)].allFinite()) {
                throw InvalidInput(name + " of the given mesh has a node whose coordinates are no finite numbers");
            }
        }
    }
}

/// A face of tetrahedra, as it is seen from outside of the first.
struct SharedFace {
    FaceKey key;
    std::size_t tetrahedron;
    std::array<int, 3> outward;
};

}  // namespace

void require_sound(const GivenMesh& mesh) {
    if (mesh.triangles.empty() && mesh.tetrahedra.empty()) {
        throw InvalidInput("the given mesh has neither triangles nor tetrahedra: only these are curved");
    }
    if (!mesh.regions.empty() && mesh.regions.size() != mesh.tetrahedra.size()) {
        throw InvalidInput("the given mesh has " + std::to_string(mesh.regions.size()) + " regions for " +
                           std::to_string(mesh.tetrahedra.size()) + " tetrahedra: give one for each, or none");
    }
    require_nodes(mesh.triangles, mesh, "triangle");
    require_nodes(mesh.tetrahedra, mesh, "tetrahedron");
}

std::size_t orient_tetrahedra(GivenMesh& mesh) {
    std::size_t turned = 0;
    for (auto& t : mesh.tetrahedra) {
        const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(t[k])]; };
        if ((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0.0) {
            std::swap(t[2], t[3]);
            ++turned;
        }
    }
    return turned;
}

std::array<std::array<int, 3>, 4> outward_faces(const std::array<int, 4>& v) {
    return {{{v[1], v[2], v[3]}, {v[0], v[3], v[2]}, {v[0], v[1], v[3]}, {v[0], v[2], v[1]}}};
}

std::vector<std::array<int, 3>> surface_of(const GivenMesh& mesh) {
    if (mesh.tetrahedra.empty()) {
        return mesh.triangles;
    }
    std::vector<SharedFace> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        for (const auto& outward : outward_faces(mesh.tetrahedra[t])) {
            faces.push_back({face_key(outward[0], outward[1], outward[2]), t, outward});
        }
    }
    std::sort(faces.begin(), faces.end(), [](const SharedFace& a, const SharedFace& b) {
        return std::tie(a.key, a.tetrahedron) < std::tie(b.key, b.tetrahedron);
    });
    std::set<FaceKey> listed;
    for (const auto& t : mesh.triangles) {
        listed.insert(face_key(t[0], t[1], t[2]));
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
            throw InvalidInput("more than two tetrahedra of the given mesh have the triangle of nodes " +
                               std::to_string(faces[i].key[0]) + ", " + std::to_string(faces[i].key[1]) + " and " +
                               std::to_string(faces[i].key[2]) + ": remove those that lie on one another");
        }
        if (end - i == 1 || region(faces[i]) != region(faces[i + 1]) || listed.count(faces[i].key) > 0) {
            result.push_back(faces[i].outward);
        }
        i = end;
    }
    return result;
}

}  // namespace mq::curve

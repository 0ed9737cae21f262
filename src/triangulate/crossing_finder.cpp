// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/crossing_finder.h"

#include <algorithm>

#include "mesh/self_intersection.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

constexpr std::size_t kMostPairs = 50'000;

}  // namespace

CrossingFinder::CrossingFinder(Workspace& work) : work_(work) {
    const geometry::Topology& topology = work.session.topology();
    volumes_of_face_.resize(topology.faces.size());
    for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
        if (topology.volumes[v].kind != geometry::Volume::Kind::Faces) {
            for (const auto& side : topology.volumes[v].sides) {
                volumes_of_face_[side.face].push_back(static_cast<int>(v));
            }
        }
    }
}

bool CrossingFinder::one_volume(const Faces& faces) const {
    const std::vector<int>& a = volumes_of_face_[faces.first];
    const std::vector<int>& b = volumes_of_face_[faces.second];
    return std::any_of(a.begin(), a.end(), [&](int v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

CrossingFinder::Faces CrossingFinder::faces_of(const std::array<int, 2>& pair) const {
    return std::minmax({work_.mesh.face_of(pair[0]), work_.mesh.face_of(pair[1])});
}

// Every change of the mesh makes an edge with a new number; triangles that take the places of others are fewer then.
const std::vector<std::array<int, 2>>& CrossingFinder::pairs() {
    const std::array<int, 2> state{work_.mesh.number_count(), work_.mesh.triangle_count()};
    if (state != state_) {
        find();
        state_ = state;
    }
    return pairs_;
}

void CrossingFinder::find() {
    const SurfaceMesh& mesh = work_.mesh;
    std::vector<Vec3> vertices;
    std::vector<mesh::Triangle> triangles;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        vertices.push_back(mesh.vertex(v).point);
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        triangles.push_back({mesh.vertex_of(3 * t), mesh.vertex_of(3 * t + 1), mesh.vertex_of(3 * t + 2)});
    }
    pairs_.clear();
    for (const mesh::ContactPair& pair : mesh::self_intersections(vertices, triangles, kMostPairs, &work_.progress)) {
        if (one_volume(faces_of({pair.a, pair.b}))) {
            pairs_.push_back({pair.a, pair.b});
        }
    }
}

std::map<CrossingFinder::Faces, std::size_t> CrossingFinder::by_faces(
    const std::vector<std::array<int, 2>>& pairs) const {
    std::map<Faces, std::size_t> result;
    for (const auto& pair : pairs) {
        ++result[faces_of(pair)];
    }
    return result;
}

}  // namespace mq::triangulate

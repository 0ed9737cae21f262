// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/self_intersections.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/disjoint_sets.h"
#include "mesh/intersection/self_intersection.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

SelfIntersections::SelfIntersections(Workspace& work) : work_(work) {
    const geometry::Topology& topology = work.session.topology();
    volumes_of_face_.resize(topology.faces.size());
    for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
        if (topology.volumes[v].kind != geometry::Volume::Kind::Faces) {
            for (const auto& side : topology.volumes[v].sides) {
                volumes_of_face_[side.face].push_back(static_cast<int>(v));
            }
        }
    }
    DisjointSets<int> sheets(topology.faces.size());
    for (const geometry::Edge& edge : topology.edges) {
        for (const int use : edge.uses) {
            sheets.unite(topology.uses[edge.uses.front()].face, topology.uses[use].face);
        }
    }
    int count = 0;
    sheet_of_face_ = sheets.number(count);
}

// Whether neither face belongs to a volume.
bool SelfIntersections::loose(const Faces& faces) const {
    return volumes_of_face_[faces.first].empty() && volumes_of_face_[faces.second].empty();
}

bool SelfIntersections::one_volume(const Faces& faces) const {
    const geometry::Topology& topology = work_.session.topology();
    if (topology.of_shape({2, faces.first}) == topology.of_shape({2, faces.second})) {
        return true;
    }
    if (loose(faces)) {
        return sheet_of_face_[faces.first] == sheet_of_face_[faces.second];
    }
    const std::vector<int>& a = volumes_of_face_[faces.first];
    const std::vector<int>& b = volumes_of_face_[faces.second];
    return std::any_of(a.begin(), a.end(), [&](int v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

SelfIntersections::Faces SelfIntersections::faces_of(const std::array<int, 2>& pair) const {
    return std::minmax({work_.mesh.face_of(pair[0]), work_.mesh.face_of(pair[1])});
}

const std::vector<std::array<int, 2>>& SelfIntersections::pairs() {
    find_where_changed();
    return pairs_;
}

std::vector<std::array<int, 2>> SelfIntersections::pairs_of_bodies() {
    find_where_changed();
    std::vector<std::array<int, 2>> result;
    std::copy_if(others_.begin(), others_.end(), std::back_inserter(result),
                 [&](const auto& pair) { return !loose(faces_of(pair)); });
    return result;
}

std::vector<std::array<int, 2>> SelfIntersections::deep_loose_pairs(double deviation) {
    constexpr double kBoth = 2.0;  // both triangles may deviate from their faces
    find_where_changed();
    std::set<Faces> deep;
    for (const auto& pair : others_) {
        if (loose(faces_of(pair)) && depth(pair) > kBoth * deviation + work_.grid.resolution()) {
            deep.insert(faces_of(pair));
        }
    }
    std::vector<std::array<int, 2>> result;
    std::copy_if(others_.begin(), others_.end(), std::back_inserter(result),
                 [&](const auto& pair) { return deep.count(faces_of(pair)) > 0; });
    return result;
}

// Returns how far triangle a extends to the shallower side of the plane of b, mm.
double SelfIntersections::reach(int a, int b) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const Vec3& o = mesh.point_of(3 * b);
    const Vec3 normal = doubled_area(mesh, b).normalized();
    double above = 0.0;
    double below = 0.0;
    for (int h = 3 * a; h < 3 * a + 3; ++h) {
        const double height = normal.dot(mesh.point_of(h) - o);
        above = std::max(above, height);
        below = std::max(below, -height);
    }
    return std::min(above, below);
}

double SelfIntersections::depth(const std::array<int, 2>& pair) const {
    return std::min(reach(pair[0], pair[1]), reach(pair[1], pair[0]));
}

// Searches again if the mesh changed: every change creates an edge, or reduces the number of triangles.
void SelfIntersections::find_where_changed() {
    const std::array<std::int64_t, 2> state{work_.mesh.edges_made(), work_.mesh.triangle_count()};
    if (state != state_) {
        find();
        state_ = state;
    }
}

void SelfIntersections::find() {
    const ClassifiedMesh& mesh = work_.mesh;
    std::vector<mesh::Triangle> triangles;
    triangles.reserve(static_cast<std::size_t>(mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        triangles.push_back({mesh.vertex_of(3 * t), mesh.vertex_of(3 * t + 1), mesh.vertex_of(3 * t + 2)});
    }
    pairs_.clear();
    others_.clear();
    const std::vector<mesh::ContactPair> found =
        mesh::self_intersections(mesh.points(), triangles, mesh::kMostCounted, &work_.progress);
    incomplete_ = found.size() >= mesh::kMostCounted;
    for (const mesh::ContactPair& pair : found) {
        if (one_volume(faces_of({pair.a, pair.b}))) {
            pairs_.push_back({pair.a, pair.b});
        } else if (pair.contact == mesh::Contact::Crossing) {
            others_.push_back({pair.a, pair.b});
        }
    }
}

std::map<SelfIntersections::Faces, std::size_t> SelfIntersections::by_faces(
    const std::vector<std::array<int, 2>>& pairs) const {
    std::map<Faces, std::size_t> result;
    for (const auto& pair : pairs) {
        ++result[faces_of(pair)];
    }
    return result;
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/front_fault.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "base/predicates.h"

namespace mq::triangulate {

namespace {

struct Count {
    long euler = 0;               // V - E + F, with the images of a vertex and the sides of a seam counted once
    std::size_t inner_sites = 0;  // sites inside the face that triangles use
    std::size_t borders = 0;      // pieces of the border that triangles use
};

Count count(const FaceMesh& face, const geometry::Topology& topology) {
    std::set<int> vertices;
    std::set<int> inner;
    std::set<int> borders;
    std::set<std::pair<int, int>> pieces;  // CAD edge, index
    long halves = 0;
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const int s = face.triangles[t][i];
            if (face.sites[s].vertex >= 0) {
                vertices.insert(face.sites[s].vertex);
            } else {
                inner.insert(s);
            }
            const FaceMesh::Link& link = face.links[t][i];
            if (link.half_edge >= 0) {
                ++halves;
                continue;
            }
            const FaceMesh::Border& piece = face.borders[link.border];
            borders.insert(link.border);
            pieces.insert({topology.uses[piece.use].edge, piece.index});
        }
    }
    Count found;
    found.euler = static_cast<long>(vertices.size() + inner.size()) - halves / 2 - static_cast<long>(pieces.size()) +
                  static_cast<long>(face.triangles.size());
    found.inner_sites = inner.size();
    found.borders = borders.size();
    return found;
}

}  // namespace

std::string fault_of_face(const FaceMesh& face, const FaceMesh& coarse, const geometry::Topology& topology) {
    const Count own = count(face, topology);
    const std::size_t sites = static_cast<std::size_t>(
        std::count_if(face.sites.begin(), face.sites.end(), [](const FaceMesh::VertexUse& s) { return s.vertex < 0; }));
    const std::size_t borders = static_cast<std::size_t>(std::count_if(
        face.borders.begin(), face.borders.end(), [](const FaceMesh::Border& b) { return b.index >= 0; }));
    if (own.borders != borders) {
        return "the triangles leave out " + std::to_string(borders - own.borders) + " pieces of the border";
    }
    if (own.inner_sites != sites) {
        return "the triangles leave out " + std::to_string(sites - own.inner_sites) + " samples";
    }
    if (own.euler != count(coarse, topology).euler) {
        return "the triangles have the wrong Euler characteristic";
    }
    for (const auto& t : face.triangles) {
        if (collinear(face.sites[t[0]].point, face.sites[t[1]].point, face.sites[t[2]].point)) {
            return "a triangle has no area";
        }
    }
    return "";
}

}  // namespace mq::triangulate

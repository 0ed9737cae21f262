// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/assemble.h"

namespace mq::triangulate {

namespace {

// Adds the segments of every CAD edge, in the order of its chain.
std::vector<std::vector<int>> add_segments(ClassifiedMesh& mesh, const InitialTriangulation& initial,
                                           const geometry::Topology& topology) {
    std::vector<std::vector<int>> segments(topology.edges.size());
    for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
        const EdgePolyline& chain = initial.chains.chain(e);
        for (std::size_t i = 0; !chain.collapsed && i + 1 < chain.t.size(); ++i) {
            segments[e].push_back(
                mesh.add_segment(e, {chain.vertices[i], chain.vertices[i + 1]}, {chain.t[i], chain.t[i + 1]}));
        }
    }
    return segments;
}

std::vector<int> add_sites(ClassifiedMesh& mesh, const FaceMesh& face, int f) {
    std::vector<int> sites;
    for (const FaceMesh::VertexUse& s : face.sites) {
        const int vertex = s.vertex >= 0 ? s.vertex : mesh.add_vertex(s.point, {2, f});
        sites.push_back(mesh.add_site({vertex, s.uv, s.normal}));
    }
    return sites;
}

void add_face(ClassifiedMesh& mesh, const FaceMesh& face, int f, const geometry::Topology& topology,
              const std::vector<std::vector<int>>& segments) {
    const std::vector<int> sites = add_sites(mesh, face, f);
    const int base = mesh.half_edge_count();
    for (const auto& t : face.triangles) {
        mesh.add_triangle({sites[t[0]], sites[t[1]], sites[t[2]]}, f);
    }
    for (int h = 0; h < 3 * static_cast<int>(face.triangles.size()); ++h) {
        const FaceMesh::Link& link = face.links[h / 3][h % 3];
        if (link.half_edge >= 0) {
            mesh.link(base + h, base + link.half_edge);
        } else {
            const FaceMesh::Border& border = face.borders[link.border];
            mesh.bind(base + h, segments[topology.uses[border.use].edge][border.index], border.use);
        }
    }
}

}  // namespace

ClassifiedMesh assemble(const InitialTriangulation& initial, const geometry::Topology& topology) {
    ClassifiedMesh mesh;
    for (const ChainVertex& v : initial.chains.vertices()) {
        mesh.add_vertex(v.point, {v.entity.dimension, v.entity.index});
    }
    const auto segments = add_segments(mesh, initial, topology);
    for (int f = 0; f < static_cast<int>(initial.faces.size()); ++f) {
        const FaceMesh& face = initial.faces[f];
        if (face.failure.empty() && face.marks.empty()) {
            add_face(mesh, face, f, topology, segments);
        }
    }
    return mesh;
}

}  // namespace mq::triangulate

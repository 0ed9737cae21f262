// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/output.h"

#include <numeric>
#include <unordered_map>

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

int find_root(std::vector<int>& parent, int i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

// One volume on its way out: its triangles, and which corners (half-edges) are one vertex.
class VolumeWriter {
  public:
    VolumeWriter(const SurfaceMesh& mesh, const geometry::Volume& volume, std::vector<char>& flipped,
                 std::vector<char>& present, std::vector<int>& parent)
        : mesh_(mesh), volume_(volume), flipped_(flipped), present_(present), parent_(parent) {}

    void run(const std::vector<std::vector<int>>& triangles_of_face, Output& out) {
        std::vector<int> triangles;
        for (const auto& side : volume_.sides) {
            present_[side.face] = 1;
            flipped_[side.face] = side.flipped ? 1 : 0;
            for (const int t : triangles_of_face[side.face]) {
                triangles.push_back(t);
                for (int h = 3 * t; h < 3 * t + 3; ++h) {
                    parent_[h] = h;
                }
            }
        }
        bool closed = true;
        for (const int t : triangles) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                closed = glue(h) && closed;
            }
        }
        write(triangles, closed && signed_volume(triangles) < 0.0, out);
        for (const auto& side : volume_.sides) {
            present_[side.face] = 0;
        }
    }

  private:
    bool flipped(int h) const { return flipped_[mesh_.face_of(h / 3)] != 0; }
    int from(int h) const { return mesh_.vertex_of(flipped(h) ? SurfaceMesh::next(h) : h); }

    // The half-edge on the other side within this volume; -1 at a border or where the sides are not exactly two.
    int partner(int h) const {
        const int s = mesh_.segment_of(h);
        if (s < 0) {
            return mesh_.twin(h);
        }
        int other = -1;
        for (const SurfaceMesh::SegmentUse& use : mesh_.segment(s).uses) {
            if (use.half_edge == h || !present_[mesh_.face_of(use.half_edge / 3)]) {
                continue;
            }
            if (other >= 0) {
                return -1;
            }
            other = use.half_edge;
        }
        return other >= 0 && from(other) != from(h) ? other : -1;
    }

    bool glue(int h) {
        const int g = partner(h);
        if (g < 0) {
            return false;
        }
        const bool same_way = mesh_.vertex_of(g) == mesh_.vertex_of(h);
        join(h, same_way ? g : SurfaceMesh::next(g));
        join(SurfaceMesh::next(h), same_way ? SurfaceMesh::next(g) : g);
        return true;
    }

    void join(int a, int b) {
        const int ra = find_root(parent_, a);
        const int rb = find_root(parent_, b);
        parent_[std::max(ra, rb)] = std::min(ra, rb);
    }

    double signed_volume(const std::vector<int>& triangles) const {
        double sum = 0.0;
        for (const int t : triangles) {
            const double six = mesh_.point_of(3 * t).dot(mesh_.point_of(3 * t + 1).cross(mesh_.point_of(3 * t + 2)));
            sum += flipped(3 * t) ? -six : six;
        }
        return sum / 6.0;
    }

    void write(const std::vector<int>& triangles, bool turn, Output& out) {
        std::unordered_map<int, int> vertex_of_root;
        for (const int t : triangles) {
            mesh::Triangle corners{};
            for (int i = 0; i < 3; ++i) {
                const int root = find_root(parent_, 3 * t + i);
                const auto [found, fresh] = vertex_of_root.emplace(root, static_cast<int>(out.mesh.vertices.size()));
                if (fresh) {
                    const SurfaceMesh::Vertex& v = mesh_.vertex(mesh_.vertex_of(3 * t + i));
                    out.mesh.vertices.push_back(v.point);
                    out.mesh.vertex_entity.push_back(v.entity);
                }
                corners[i] = found->second;
            }
            if (flipped(3 * t) != turn) {
                std::swap(corners[1], corners[2]);
            }
            out.mesh.triangles.push_back(corners);
            out.mesh.triangle_face.push_back(mesh_.face_of(t));
            out.source.push_back(t);
        }
    }

    const SurfaceMesh& mesh_;
    const geometry::Volume& volume_;
    std::vector<char>& flipped_;  // by face, of this volume
    std::vector<char>& present_;
    std::vector<int>& parent_;    // by corner
};

}  // namespace

Output write_out(const SurfaceMesh& mesh, const geometry::Topology& topology, const Vec3& origin) {
    Output out;
    out.mesh.origin = origin;
    std::vector<std::vector<int>> triangles_of_face(topology.faces.size());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        triangles_of_face[mesh.face_of(t)].push_back(t);
    }
    std::vector<char> flipped(topology.faces.size(), 0);
    std::vector<char> present(topology.faces.size(), 0);
    std::vector<int> parent(mesh.half_edge_count());
    for (const geometry::Volume& volume : topology.volumes) {
        VolumeWriter(mesh, volume, flipped, present, parent).run(triangles_of_face, out);
    }
    return out;
}

}  // namespace mq::triangulate

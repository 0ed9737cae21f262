// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/manifold_output.h"

#include <cmath>

#include "base/disjoint_sets.h"
#include "triangulate/report/solid_contacts.h"

namespace mq::triangulate {

namespace {

// Writes one volume: its triangles, and which corners (half-edges) are one vertex.
class VolumeWriter {
  public:
    VolumeWriter(const ClassifiedMesh& mesh, const geometry::Topology& topology, const geometry::Volume& volume,
                 std::vector<char>& flipped, std::vector<char>& present, DisjointSets<int>& corners,
                 LargeVector<int>& vertex_of_root, const Progress& progress)
        : mesh_(mesh),
          topology_(topology),
          volume_(volume),
          flipped_(flipped),
          present_(present),
          corners_(corners),
          vertex_of_root_(vertex_of_root),
          pace_(progress) {}

    void run(const std::vector<std::vector<int>>& triangles_of_face, Output& out) {
        LargeVector<int> triangles;
        triangles.reserve(count_of(triangles_of_face));
        for (const auto& side : volume_.sides) {
            present_[side.face] = 1;
            flipped_[side.face] = side.flipped ? 1 : 0;
            for (const int t : triangles_of_face[side.face]) {
                triangles.push_back(t);
                for (int h = 3 * t; h < 3 * t + 3; ++h) {
                    corners_.reset(h);
                    vertex_of_root_[h] = -1;
                }
            }
        }
        bool closed = true;
        for (const int t : triangles) {
            pace_.step();
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                closed = glue(h) && closed;
            }
        }
        write(triangles, closed && signed_volume(triangles) < 0.0, out);
        for (const auto& side : volume_.sides) {
            present_[side.face] = 0;
        }
    }

    /// Returns how many triangles it has.
    std::size_t count_of(const std::vector<std::vector<int>>& triangles_of_face) const {
        std::size_t count = 0;
        for (const auto& side : volume_.sides) {
            count += triangles_of_face[side.face].size();
        }
        return count;
    }

  private:
    // Returns the shape's face on the side that this volume has.
    int own_face(int t) const {
        const int behind = topology_.faces[static_cast<std::size_t>(mesh_.face_of(t))].behind;
        return flipped(3 * t) && behind >= 0 ? behind : topology_.of_shape({2, mesh_.face_of(t)}).index;
    }
    bool flipped(int h) const { return flipped_[mesh_.face_of(h / 3)] != 0; }
    int from(int h) const { return mesh_.vertex_of(flipped(h) ? ClassifiedMesh::next(h) : h); }

    // Returns the half-edge on the other side within this volume; -1 at a border or where sides do not form pairs.
    int partner(int h) const {
        const int s = mesh_.segment_of(h);
        if (s < 0) {
            return mesh_.twin(h);
        }
        std::vector<int> sides;
        int balance = 0;
        for (const ClassifiedMesh::SegmentUse& use : mesh_.segment(s).uses) {
            if (present_[mesh_.face_of(use.half_edge / 3)]) {
                sides.push_back(use.half_edge);
                balance += from(use.half_edge) == mesh_.segment(s).vertices[0] ? 1 : -1;
            }
        }
        if (balance != 0 || sides.size() < 2) {
            return -1;
        }
        if (sides.size() == 2) {
            return sides[0] == h ? sides[1] : sides[0];
        }
        return across_material(s, h, sides);
    }

    // Where a solid touches itself along an edge, four or more faces meet. Two of them belong together if they bound
    // the same wedge of material.
    int across_material(int segment, int h, const std::vector<int>& sides) const {
        const auto& v = mesh_.segment(segment).vertices;
        const Vec3 axis = (mesh_.vertex(v[1]).point - mesh_.vertex(v[0]).point).normalized();
        const Vec3 own = into_face(h, axis);
        const Vec3 turned = axis.cross(own);
        // Outward is to the right of the face when its border is followed with the inside on the left.
        const double sense = from(h) == v[0] ? -1.0 : 1.0;
        int best = -1;
        double least = 1e300;
        for (const int other : sides) {
            if (other == h || from(other) == from(h)) {
                continue;
            }
            const Vec3 d = into_face(other, axis);
            double angle = sense * std::atan2(turned.dot(d), own.dot(d));
            angle = angle <= 0.0 ? angle + 2.0 * M_PI : angle;
            if (angle < least) {
                least = angle;
                best = other;
            }
        }
        return best;
    }

    // Returns the direction perpendicular to the segment in which the face of `h` leaves it.
    Vec3 into_face(int h, const Vec3& axis) const {
        const Vec3 d = mesh_.point_of(ClassifiedMesh::prev(h)) - mesh_.point_of(h);
        return (d - axis * axis.dot(d)).normalized();
    }

    bool glue(int h) {
        const int g = partner(h);
        if (g < 0) {
            return false;
        }
        if (mesh_.twin(h) == g && g < h && present_[mesh_.face_of(g / 3)]) {
            return true;  // already joined from the other side
        }
        const bool same_way = mesh_.vertex_of(g) == mesh_.vertex_of(h);
        corners_.unite(h, same_way ? g : ClassifiedMesh::next(g));
        corners_.unite(ClassifiedMesh::next(h), same_way ? ClassifiedMesh::next(g) : g);
        return true;
    }

    double signed_volume(const LargeVector<int>& triangles) const {
        double sum = 0.0;
        for (const int t : triangles) {
            const double six = mesh_.point_of(3 * t).dot(mesh_.point_of(3 * t + 1).cross(mesh_.point_of(3 * t + 2)));
            sum += flipped(3 * t) ? -six : six;
        }
        return sum / 6.0;
    }

    void write(const LargeVector<int>& triangles, bool turn, Output& out) {
        for (const int t : triangles) {
            pace_.step();
            mesh::Triangle corners{};
            for (int i = 0; i < 3; ++i) {
                const int root = corners_.find(3 * t + i);
                if (vertex_of_root_[root] < 0) {
                    vertex_of_root_[root] = static_cast<int>(out.mesh.vertices.size());
                    const ClassifiedMesh::Vertex& v = mesh_.vertex(mesh_.vertex_of(3 * t + i));
                    out.mesh.vertices.push_back(v.point);
                    const geometry::Entity of = topology_.of_shape({v.entity[0], v.entity[1]});
                    out.mesh.vertex_entity.push_back({of.dimension, of.index});
                    if (topology_.has_pieces()) {
                        out.mesh.vertex_piece.push_back(v.entity);
                    }
                }
                corners[i] = vertex_of_root_[root];
            }
            if (flipped(3 * t) != turn) {
                std::swap(corners[1], corners[2]);
            }
            out.mesh.triangles.push_back(corners);
            out.mesh.triangle_face.push_back(own_face(t));
            out.mesh.triangle_solid.push_back(volume_.solid);
            if (topology_.has_pieces()) {
                out.mesh.triangle_piece.push_back(mesh_.face_of(t));
            }
            out.source.push_back(t);
        }
    }

    const ClassifiedMesh& mesh_;
    const geometry::Topology& topology_;
    const geometry::Volume& volume_;
    std::vector<char>& flipped_;  // by face, for this volume
    std::vector<char>& present_;
    DisjointSets<int>& corners_;  // corners joined to vertices
    LargeVector<int>& vertex_of_root_;
    CancelPace pace_;
};

// Without it, arrays that grow would take up to three times as much for a while. Pieces of faces are rare.
void reserve_arrays(Output& out, std::size_t triangles, std::size_t vertices) {
    out.mesh.vertices.reserve(vertices);
    out.mesh.vertex_entity.reserve(vertices);
    out.mesh.triangles.reserve(triangles);
    out.mesh.triangle_face.reserve(triangles);
    out.mesh.triangle_solid.reserve(triangles);
    out.source.reserve(triangles);
}

bool any_face_has_two_sides(const geometry::Topology& topology) {
    std::vector<char> met(topology.faces.size(), 0);
    for (const geometry::Volume& volume : topology.volumes) {
        for (const auto& side : volume.sides) {
            if (met[side.face] != 0) {
                return true;
            }
            met[side.face] = 1;
        }
    }
    return false;
}

}  // namespace

Output write_out(const ClassifiedMesh& mesh, const geometry::Topology& topology, const Vec3& origin,
                 const Progress& progress) {
    Output out;
    out.mesh.origin = origin;
    const std::vector<std::vector<int>> triangles_of_face = mesh.triangles_by_face(topology.faces.size());
    std::vector<char> flipped(topology.faces.size(), 0);
    std::vector<char> present(topology.faces.size(), 0);
    DisjointSets<int> corners(mesh.half_edge_count());
    LargeVector<int> vertex_of_root(mesh.half_edge_count());
    std::vector<VolumeWriter> writers;
    std::size_t triangles = 0;
    for (const geometry::Volume& volume : topology.volumes) {
        writers.emplace_back(mesh, topology, volume, flipped, present, corners, vertex_of_root, progress);
        triangles += writers.back().count_of(triangles_of_face);
    }
    reserve_arrays(out, triangles, static_cast<std::size_t>(mesh.vertex_count()));
    for (VolumeWriter& writer : writers) {
        writer.run(triangles_of_face, out);
    }
    if (any_face_has_two_sides(topology)) {
        pair_opposite_triangles(out.mesh, out.source);
    }
    return out;
}

}  // namespace mq::triangulate

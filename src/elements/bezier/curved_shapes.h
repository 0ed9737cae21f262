// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/key_set.h"
#include "elements/bezier/bernstein.h"
#include "mesh/triangle_mesh.h"

namespace mq::elements {

using EdgeKey = std::uint64_t;  ///< pair_key of the vertices
using FaceKey = std::array<std::int32_t, 3>;

/// Ascending vertices.
FaceKey face_key(int a, int b, int c);

/// A mesh vertex with its classification (section 1 of Dey, O'Bara, Shephard 1999): dimension 0 model vertex, 1 edge,
/// 2 face, 3 region.
struct Vertex {
    Vec3 point = Vec3::Zero();
    mesh::VertexEntity entity{-1, -1};
};

/// The curved geometry of a mesh: vertices, and Bezier control points of its edges and faces.
///
/// Edges and faces without a shape of their own have the lowest order that fits: an edge is straight, a face is blended
/// from its edges, a region from its faces. Elements that share an entity get the same control points, bit for bit.
class CurvedShapes {
  public:
    explicit CurvedShapes(int order);

    int order() const { return order_; }
    std::vector<Vertex> vertices;

    /// The q - 1 inner control points from `a` to `b`.
    void set_edge(int a, int b, const std::vector<Vec3>& inner);
    void forget_edge(int a, int b);
    bool has_edge(int a, int b) const { return edges_.count(pair_key(a, b)) > 0; }
    std::vector<Vec3> edge_inner(int a, int b) const;

    /// The inner control points of face (a, b, c), in the order of the triangle lattice on these corners.
    void set_face(const std::array<int, 3>& corners, const std::vector<Vec3>& inner);
    /// Sets them by all control points of the triangle, of which it keeps the inner ones.
    void set_inside(const std::array<int, 3>& corners, const std::vector<Vec3>& control);
    void forget_face(const std::array<int, 3>& corners);
    bool has_face(const std::array<int, 3>& corners) const;

    /// All control points of a triangle or tetrahedron, in the order of its lattice.
    void triangle(const std::array<int, 3>& corners, std::vector<Vec3>& control) const;
    void tetrahedron(const std::array<int, 4>& corners, std::vector<Vec3>& control) const;

  private:
    void place_edge(const Lattice& lattice, int a, int b, std::size_t i, std::size_t k,
                    std::vector<Vec3>& control) const;

    int order_;
    std::unordered_map<EdgeKey, std::vector<Vec3>> edges_;  // inner control points from the lower vertex to the higher
    std::unordered_map<FaceKey, std::vector<Vec3>, KeyHash> faces_;  // inner control points on ascending corners
    std::vector<int> inner_;  // indices of the inner points of the triangle lattice
};

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <unordered_set>
#include <vector>

#include "base/progress.h"
#include "base/sizes/size_field.h"
#include "curve/surface/curved_surface.h"

namespace mq::curve {

struct Tetrahedron {
    std::array<int, 4> corners{};
    int volume = -1;
    double quality = 1.0;  ///< lower bound of I = min J / max J; not positive: invalid
    bool alive = true;
};

/// Tetrahedra inside a curved surface, whose vertices and shapes they share. The surface stays as it is: its vertices,
/// edges and triangles are fixed. Tetrahedra are only added or marked dead.
class TetrahedralMesh {
  public:
    explicit TetrahedralMesh(CurvedSurface& surface);
    /// With those of these tetrahedra that are alive, and their qualities.
    TetrahedralMesh(CurvedSurface& surface, const std::vector<Tetrahedron>& kept);

    CurvedSurface& surface;
    std::vector<Tetrahedron> tetrahedra;

    elements::CurvedShapes& shapes() { return surface.shapes; }
    const elements::CurvedShapes& shapes() const { return surface.shapes; }
    const Vec3& point(int v) const { return surface.shapes.vertices[static_cast<std::size_t>(v)].point; }

    int add(const std::array<int, 4>& corners, int volume);
    void remove(int tetrahedron);
    int add_vertex(const Vec3& point, int volume);

    const std::vector<int>& of_vertex(int v) const { return stars_[v]; }
    std::vector<int> of_edge(int a, int b) const { return stars_.of({a, b}, tetrahedra); }
    std::vector<int> of_face(int a, int b, int c) const { return stars_.of({a, b, c}, tetrahedra); }
    bool has_edge(int a, int b) const { return stars_.joined(a, b, tetrahedra); }
    /// Whether an edge may be collapsed, by the connections alone.
    bool link_condition(int a, int b) const { return stars_.link_condition(a, b, tetrahedra); }
    bool fixed_edge(int a, int b) const { return fixed_edges_.count(pair_key(a, b)) > 0; }
    bool fixed_face(int a, int b, int c) const { return fixed_faces_.count(elements::face_key(a, b, c)) > 0; }
    /// Six times the volume of the straight tetrahedron.
    double straight_jacobian(const std::array<int, 4>& corners) const;
    /// 1 for the regular tetrahedron, 0 for a flat one, negative for an inverted one.
    double straight_shape(const std::array<int, 4>& corners) const;
    /// The target of an element's J: J of the straight tetrahedron or, if this is flat, of one with the same sum of
    /// squared edges and the least mean ratio that is not flat. Relative to its own J a flat element would outweigh all
    /// others.
    double reference_jacobian(const std::array<int, 4>& corners) const;
    bool curved(const std::array<int, 4>& corners) const;

    /// Certified quality of an element.
    double measure(const std::array<int, 4>& corners) const;
    /// Sets the qualities of elements, in parallel where there are many.
    /// @throws Cancelled
    void measure(const std::vector<int>& tetrahedra, const Progress* progress = nullptr);
    std::vector<int> live_tetrahedra() const;
    /// Number of tetrahedra that are not removed and not valid, by their qualities.
    std::size_t invalid() const;

  private:
    double squared_edges(const std::array<int, 4>& corners) const;

    mesh::SimplexStars stars_;
    std::unordered_set<elements::EdgeKey> fixed_edges_;
    std::unordered_set<elements::FaceKey, KeyHash> fixed_faces_;
};

/// The four faces of a tetrahedron, seen from outside where its volume is positive.
std::array<std::array<int, 3>, 4> outward_faces(const std::array<int, 4>& corners);

/// The triangles of a surface that are not valid: they fold any tetrahedron on them, whatever is inside.
class FoldedTriangles {
  public:
    explicit FoldedTriangles(const CurvedSurface& surface);

    /// Whether a face of the tetrahedron is an invalid triangle of the surface.
    bool has_face_of(const std::array<int, 4>& corners) const;

  private:
    std::unordered_set<elements::FaceKey, KeyHash> folded_;
};

/// Fills every closed solid of the model. Volumes that are not solids have no inside and are left out.
/// @param edges  curved edges of the surface, whose tangents the tetrahedra respect: those of `surface.shapes`, or of
/// another order
/// @param field  bounds the lengths of edges inside; null: none
/// @throws tetrahedralise::MeshingFailed naming the solid.
TetrahedralMesh tetrahedralise_solids(CurvedSurface& surface, const elements::CurvedShapes& edges,
                                      const geometry::Topology& topology, const Progress& progress,
                                      const SizeField* field = nullptr);

}  // namespace mq::curve

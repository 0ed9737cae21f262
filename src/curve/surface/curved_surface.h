// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <unordered_map>
#include <vector>

#include "elements/bezier/curved_shapes.h"
#include "geometry/session.h"
#include "mesh/simplex_stars.h"

namespace mq::curve {

/// A mesh edge on a CAD edge, with the parameters of its ends.
struct Segment {
    int edge = -1;
    double t_low = 0.0;  ///< at the mesh vertex of lower index
    double t_high = 0.0;
};

struct SurfaceTriangle {
    std::array<int, 3> corners{};
    int face = -1;         ///< CAD face
    double quality = 0.0;  ///< lower bound of min / max of the normal component; not positive: invalid
    bool alive = true;
};

/// A side of a triangle that bounds a volume.
struct BoundarySide {
    int triangle = -1;
    bool flipped = false;
};

/// The curved surface mesh of a model: triangles classified on CAD faces, each CAD face meshed once, also where two
/// volumes share it. Triangles and vertices are added or marked dead, so that indices stay; only the last triangles can
/// be withdrawn.
class CurvedSurface {
  public:
    explicit CurvedSurface(int order) : shapes(order) {}

    elements::CurvedShapes shapes;
    std::vector<SurfaceTriangle> triangles;
    std::unordered_map<elements::EdgeKey, Segment> segments;
    /// (u, v) of a vertex on a face that it touches, on any of its branches.
    std::unordered_map<std::uint64_t, Vec2> uv;
    /// At poles and apexes: which of u and v (0, 1) is undefined there.
    std::unordered_map<std::uint64_t, int> free_parameter;
    /// Vertices that deviate from the CAD entities at them: nodes of elements there leave the CAD evenly (see
    /// Placement).
    std::set<int> off_cad;
    /// +1 or -1 by CAD face: how the triangles are oriented against its outward normal.
    std::vector<double> face_sign;
    /// By volume of the model: which faces bound it, seen from the triangles' side or from behind.
    std::vector<std::vector<std::pair<int, bool>>> volume_faces;

    int add_triangle(const std::array<int, 3>& corners, int face);
    void remove_triangle(int triangle);
    /// Takes back the last call of `add_triangle` that was not taken back.
    void withdraw_triangle();
    void revive_triangle(int triangle);
    /// Living triangles with both vertices.
    std::vector<int> triangles_of_edge(int a, int b) const { return stars_.of({a, b}, triangles); }
    const std::vector<int>& triangles_of_vertex(int v) const { return stars_[v]; }
    bool has_edge(int a, int b) const { return stars_.joined(a, b, triangles); }
    /// The vertices that have an edge with v, in ascending order.
    std::vector<int> neighbours(int v) const { return stars_.link({v}, triangles); }
    /// Whether an edge may be collapsed, by the connections alone.
    bool link_condition(int a, int b) const { return stars_.link_condition(a, b, triangles); }
    int add_vertex(const elements::Vertex& vertex);
    /// Parameters at a and b of the CAD edge under mesh edge (a, b); nullptr when it lies inside a face.
    const Segment* segment(int a, int b) const;
    void set_segment(int a, int b, int edge, double t_a, double t_b);
    double t_of(int vertex, int other) const;
    const Vec2* uv_of(int vertex, int face) const;
    std::size_t alive() const;
    /// How many live triangles are not valid, by their qualities.
    std::size_t invalid() const;

    static std::uint64_t key(int vertex, int face) {
        return ordered_key(static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(face));
    }

  private:
    mesh::SimplexStars stars_;
};

/// Vertices of meshes made by triangulate() are rounded to single precision: this fraction of the model's size is their
/// largest distance from their curves.
constexpr double kOnCurve = 2e-7;

/// The mesh vertex at an end of a CAD edge (0 at t0, 1 at t1); -1: none.
/// @param at_node  by CAD vertex, the mesh vertex there or -1
int vertex_at_end(const geometry::Edge& edge, std::size_t end, const std::vector<int>& at_node);

/// Finds the parameters of all vertices of a surface whose vertices and triangles know their CAD entities, and the CAD
/// edge under every mesh edge; sets the vertices exactly on their entities, and the sign of each face.
/// @param at_node  by CAD vertex, the mesh vertex there or -1
/// @throws TopologyError when the mesh does not follow an edge of the model, naming it; GeometryError.
void find_parameters(geometry::Session& session, CurvedSurface& surface, const std::vector<int>& at_node);

/// Takes over a triangulation of the model: joins what volumes share, finds the CAD edge under every mesh edge and the
/// parameters of all vertices, and sets the vertices exactly on their entities (the triangulation holds them in single
/// precision).
/// @throws TopologyError when the mesh does not follow an edge of the model, naming it.
CurvedSurface classify(geometry::Session& session, const mesh::TriangleMesh& mesh, int order);

}  // namespace mq::curve

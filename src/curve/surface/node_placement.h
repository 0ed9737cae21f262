// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/surface/curved_surface.h"
#include "geometry/trimmed_face_distances.h"

namespace mq::curve {

/// Puts the nodes of mesh edges and triangles on the CAD (section 5.1 of Dey, O'Bara, Shephard 1999).
///
/// On a CAD edge: the parameters between those of the ends (equation (5)), moved to even arc lengths. Inside a face:
/// points of the straight edge projected to the surface, and points at even (u, v) (one end shifted by a period where
/// that is nearer; at a pole the free parameter taken from the other end); kept is the choice that is shorter and more
/// even in space. Nodes inside triangles: blended from the edges and projected, or at even (u, v); kept is the better
/// triangle. Edges inside planes stay straight.
///
/// Booleans leave vertices, and edges on faces, that deviate from their entities by far more than rounding, though
/// within their tolerance. Nodes on the CAD may fold the triangles there: at vertices in CurvedSurface::off_cad nodes
/// of mesh edges leave the CAD evenly towards the vertex, and triangles are blended from their edges.
class Placement {
  public:
    Placement(geometry::Session& session, CurvedSurface& surface);

    /// Gives shapes to all edges of the triangles that have none, and to the triangles, and sets their quality.
    void place(const std::vector<int>& triangles);
    /// Sets the quality of triangles from their present shapes.
    void measure(const std::vector<int>& triangles);

    /// Gives mesh edge (a, b) on a CAD edge a shape of `degree`, at most the order of the mesh, with its nodes on the
    /// CAD edge but moved towards b: the middle one by the fraction `by` of the edge's parameter range.
    void set_warped(int a, int b, double by, int degree);

    /// Moves the nodes of mesh edge (a, b) inside a face by the quadratic bubble 4 s (1 - s) times `by`, and back onto
    /// the face. The inner nodes of the triangles beside stay where they are.
    /// @return false, and nothing is changed, where no point of the face is found.
    bool bulge_on_face(int a, int b, int face, const Vec3& by);

    /// Puts the nodes of mesh edge (a, b) inside a face at even (u, v) between its ends.
    /// @return false, and nothing is changed, where the face has no point there.
    bool place_by_parameters(int a, int b, int face);

    /// The middle of a curved edge, where a new vertex is put, with its parameters on the entities.
    struct Middle {
        elements::Vertex vertex;
        double t = 0.0;                        ///< on a CAD edge
        std::vector<std::pair<int, Vec2>> uv;  ///< face, (u, v)
        bool found = false;
    };
    Middle middle_of(int a, int b);

    /// Whether a vertex lies on a CAD edge between two of its parameters, within tolerance or nearer than `allowed`; if
    /// so, its parameter and the point.
    bool on_edge(int vertex, int edge, double t_from, double t_to, double allowed, double& t, Vec3& point);
    /// Gives a vertex on a CAD edge its (u, v) on the faces there.
    void set_uv_on_edge(int vertex, int edge, double t);

    bool planar(int face) const;

    /// Whether tolerances of the CAD allow a vertex to deviate from it by a notable fraction of its shortest mesh edge.
    bool may_be_off_cad(int vertex) const;
    /// The distance of a vertex from the edges and faces at it, mm.
    double distance_off_cad(int vertex);

    /// Distances of points on the triangles from their trimmed CAD faces: 33 points each, none of them a node, and of
    /// flat ones the middles of their sides.
    std::vector<double> deviations(const std::vector<int>& triangles);

  private:
    struct EdgeTask {
        int a;
        int b;
        int face;
    };
    struct InnerEdge;
    /// The distances between the ends of a mesh edge and the points of the CAD at which its nodes start.
    struct Gaps {
        Vec3 at_a = Vec3::Zero();
        Vec3 at_b = Vec3::Zero();
        bool none = true;
        Vec3 closed(const Vec3& point, double s) const {
            return none ? point : Vec3(point + (1.0 - s) * at_a + s * at_b);
        }
        void close(std::vector<Vec3>& inner_nodes) const;
    };
    /// A mesh edge with the queries of the CAD points at its ends.
    struct Ends {
        int a;
        int b;
        geometry::Query at_a;
        geometry::Query at_b;
    };
    std::vector<Gaps> gaps(const std::vector<Ends>& edges);
    Ends ends_of(const InnerEdge& edge, bool project) const;
    /// A triangle with the (u, v) of its corners on its face.
    struct FaceTask {
        int triangle;
        std::array<Vec2, 3> uv;
    };
    std::vector<FaceTask> triangles_on_faces(const std::vector<int>& triangles);
    std::vector<Gaps> segment_gaps(const std::vector<EdgeTask>& tasks);
    const Vec3& point(int v) const { return surface_.shapes.vertices[static_cast<std::size_t>(v)].point; }
    geometry::Query node_query(const InnerEdge& edge, double s, bool project) const;
    void space_evenly(std::vector<InnerEdge>& edges);
    std::vector<geometry::Answer> at_even_lengths(const std::vector<EdgeTask>& tasks,
                                                  std::vector<geometry::Query>& points);
    void place_segments(const std::vector<EdgeTask>& tasks);
    void place_inner_edges(const std::vector<EdgeTask>& tasks);
    void place_faces(const std::vector<int>& triangles, bool by_parameters);
    void improve_faces(const std::vector<int>& triangles);
    std::array<Vec2, 3> corner_uv(const SurfaceTriangle& triangle) const;
    Vec2 unwrapped(int vertex, int face, const Vec2& near) const;
    void resolve_free(int vertex, int face, const Vec2& other, Vec2& uv) const;
    void set_edge_nodes(int a, int b, const std::vector<Vec3>& nodes);
    Vec3 normal_inside(const SurfaceTriangle& triangle, int corner, geometry::Answerer& answerer) const;
    std::vector<Vec3> normals_at(const SurfaceTriangle& triangle, const std::vector<Vec3>& control,
                                 geometry::Answerer& answerer) const;
    double quality_of(const SurfaceTriangle& triangle, geometry::Answerer& answerer) const;

    geometry::Session& session_;
    CurvedSurface& surface_;
    geometry::TrimmedFaceDistances distances_;
};

/// The edges of a surface as they are at order 2, whatever the order of its shapes.
elements::CurvedShapes edges_of_second_order(geometry::Session& session, const CurvedSurface& surface);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "curve/surface/node_placement.h"
#include "given/matching/matching.h"
#include "given/mixed/node_table.h"
#include "given/mixed/side_rows.h"

namespace mq::given {

/// A face of the given mesh that lies on a CAD face.
struct CadFace {
    elements::ElementKind kind = elements::ElementKind::Triangle;
    std::vector<std::int32_t>
        corners;    ///< outward from the element behind the face; in the given order if there are no solids
    int face = -1;  ///< the CAD face
    std::vector<int> triangles;  ///< in the matched surface: the face itself, or its two halves
    std::int64_t element = -1;   ///< the element behind the face; at an interface the first of its two elements
};

/// A mixed mesh on the model: its simplices were matched, and its faces are found by them.
struct MatchedFaces {
    MatchedMesh matched;
    std::vector<CadFace> faces;
    std::vector<int> volume;  ///< by element: the volume of the model; -1: none
};

/// @throws as match(); GeometryError, naming the place, if the halves of a quadrilateral are on two CAD faces.
MatchedFaces match_faces_of(geometry::Session& session, const MixedMesh& mesh, int order);

/// Puts the nodes of edges and faces on the CAD. Nodes of quadrilaterals are blended from their edges and projected.
class CadNodes {
  public:
    CadNodes(geometry::Session& session, MatchedFaces& found, NodeTable& table);

    /// Places all nodes, each edge and each face by itself.
    void place(std::vector<Vec3>& nodes);
    /// Makes edges inside of CAD faces follow the CAD edges at the ends of rows of quadrilaterals, for example where a
    /// boundary layer meets a face that is perpendicular to its wall. @return how many edges were changed.
    std::size_t follow_edges(std::vector<Vec3>& nodes);

    /// Rows of edges across the quadrilaterals of each CAD face, starting at CAD edges.
    std::vector<SideRow> rows() const;

    /// Takes nodes that others have moved: sets the shapes of edges and triangles of the surface from them, and
    /// measures these.
    void read_from(const std::vector<Vec3>& nodes);

    /// Whether these are the corners of an edge or a face on the CAD.
    bool has(const std::vector<std::int32_t>& corners) const { return sides_.count(sorted(corners)) > 0; }
    /// mm, by face: the largest distance of points between its nodes from its CAD face.
    std::vector<double> deviations(const std::vector<Vec3>& nodes);
    /// By face on the CAD: lower bound of min J / max J against the CAD normal for triangles, 1 for quadrilaterals.
    std::vector<double> triangle_qualities();

  private:
    static std::vector<std::int32_t> sorted(std::vector<std::int32_t> corners);
    int vertex(std::int32_t corner) const { return found_.matched.vertex_of_node[static_cast<std::size_t>(corner)]; }
    bool on_cad_edge(std::int32_t a, std::int32_t b) const;
    void write_edges_to(std::vector<Vec3>& nodes);
    void write_triangles_to(std::vector<Vec3>& nodes);
    void place_quadrilaterals(std::vector<Vec3>& nodes);
    void put_edge(std::int32_t a, std::int32_t b, const std::vector<Vec3>& nodes);
    std::vector<Vec3> projected(int face, const std::vector<Vec3>& points);
    /// By node: the difference between CAD edges at the ends of rows and edges inside of the face.
    std::vector<Vec3> displacement_of_ends(int face, const std::vector<SideRow>& rows, const std::vector<Vec3>& nodes);
    /// Whether the ends of a row are displaced by a notable fraction of the thinnest layer at an end of the row.
    bool bends_much(const SideRow& row, const std::vector<Vec3>& displacement);
    std::vector<SideRow> rows_on(int face) const;
    std::set<int> faces_with_quadrilaterals() const;
    bool follow_edges_of(int face, std::vector<Vec3>& nodes, std::size_t& changed);

    geometry::Session& session_;
    MatchedFaces& found_;
    NodeTable& table_;
    curve::Placement placement_;
    std::set<std::vector<std::int32_t>> sides_;
    std::set<std::array<std::int32_t, 2>> edges_;
};

}  // namespace mq::given

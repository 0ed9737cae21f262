// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "base/vec.h"

/// The CAD-neutral entities (Aftosmis 1999, figure 1): volumes, faces, loops, edges, nodes.
///
/// All indices count from 0 and map one to one to FreeCAD's sub-elements: face 6 is "Face7". Where surfaces are cut
/// along their creases (Topology::parts_of), the pieces beyond the first come after all of the shape's own entities.
namespace mq::geometry {

/// The entity to which a vertex or a message refers: dimension 0 node, 1 edge, 2 face.
struct Entity {
    int dimension = -1;
    int index = -1;

    bool operator==(const Entity& other) const { return dimension == other.dimension && index == other.index; }
};

/// FreeCAD's name of an entity: "Vertex3", "Edge12", "Face7".
std::string name_of(Entity entity);

struct Node {
    Vec3 point = Vec3::Zero();
    double tolerance = 0.0;
};

/// The pieces of a curve, or of a surface in one direction, each of which is one polynomial: features of the curve or
/// the surface can be as small as these.
struct KnotSpans {
    std::vector<double> bounds;  ///< ascending, with both ends of the range; empty for lines, planes, conics, quadrics
    int degree = 0;
};

/// One appearance of an edge on a face, with its own curve in the face's parameter domain.
/// A seam appears twice on one face; an edge inside a face (a slit) may too.
struct EdgeUse {
    int edge = -1;
    int face = -1;
    bool forward = true;    ///< walking the loop with the interior on the left in (u, v), t grows
    bool internal = false;  ///< whether it lies inside the face and does not bound it
};

struct Edge {
    std::array<int, 2> nodes{-1, -1};  ///< nodes at t0 and t1; equal when closed; -1 when the curve has no end there
    double t0 = 0.0;
    double t1 = 0.0;
    bool degenerate = false;  ///< no curve in space: the pole of a sphere, the apex of a cone
    double tolerance = 0.0;
    std::vector<int> uses;  ///< indices into Topology::uses
    KnotSpans spans;
};

/// An oriented run of edge uses. Not all of them form a closed chain on faulty faces.
struct Loop {
    std::vector<int> uses;
};

struct Face {
    std::vector<Loop> loops;
    std::vector<int> points;  ///< nodes inside: another entity touches the face there
    bool reversed = false;    ///< the outward normal is -(Su x Sv)
    bool no_area = false;     ///< the surface is collapsed to a curve: there is nothing to mesh
    int behind = -1;          ///< the shape's face on the side that is flipped, where two solids touch; -1: the same
    double tolerance = 0.0;
    std::array<double, 2> low{0.0, 0.0};  ///< bounds of (u, v) on the trimmed face
    std::array<double, 2> high{0.0, 0.0};
    std::array<double, 2> period{0.0, 0.0};  ///< 0 where the surface is not periodic (or closed) in u, v
    std::array<KnotSpans, 2> spans;          ///< spans in u and v
    const char* surface = "other";           ///< "plane", "cylinder", "cone", "sphere", "torus", "bspline", ...
};

/// A solid, a free shell, or the free faces of a compound taken together.
struct Volume {
    enum class Kind { Solid, Shell, Faces };
    struct Side {
        int face = -1;
        bool flipped = false;  ///< the volume sees the face from its other side (a face shared by two solids)
    };
    Kind kind = Kind::Solid;
    int solid = -1;  ///< number of the solid in the shape, from 0 on; -1: it is none
    std::vector<Side> sides;
};

/// Two nodes or two edges of a topology that count as one, although the shape has both.
struct Joined {
    std::array<Entity, 2> entities;
    double distance = 0.0;  ///< mm, at most
    bool by_shape = false;  ///< whether the shape's own tolerances make them one
};

/// Which narrow corners of faces are cut off (see cut_narrow_corners).
enum class CornerCuts {
    None,
    /// Those with which the bound on angles is not kept. At pinches parts of a face's border meet that do not follow
    /// each other, as at a hole that is tangent to an edge, or one of the edges is a seam, which is no line of the
    /// shape. Elsewhere the innermost pieces are 150 times as long as the corner is wide at their ends.
    Infeasible,
    All,
};

struct Topology {
    std::vector<Node> nodes;
    std::vector<Edge> edges;
    std::vector<Face> faces;
    std::vector<EdgeUse> uses;
    std::vector<Volume> volumes;
    Box box;  ///< box of the faces, mm; never smaller than they are
    /// mm; edges shorter and faces thinner than this are not told apart where that is safe (degenerate_faces,
    /// triangulate/edges/short_edges); 0: all are
    double detail = 0.0;
    bool sewn = false;       ///< faces without a shell are joined where borders lie together within `detail`
    bool imprinted = false;  ///< faces of two solids that lie on each other are one face
    std::vector<Joined> joined;
    std::vector<int> joined_nodes;  ///< by node: the node with which it was joined; empty: no nodes are joined
    CornerCuts corner_cuts = CornerCuts::None;
    /// Nodes where narrow corners of faces were cut off, each as far from its edges as its tolerance says.
    std::vector<int> cut_corners;
    std::vector<std::string> faults;  ///< faults of the model by the kernel's own checks, naming entities
    /// By dimension, for the entities after the shape's own: the entity of the shape to which each belongs. A piece of
    /// an edge or a face belongs to the whole one, a crease to its face, the end of a crease to the edge or face on
    /// which it lies.
    std::array<std::vector<Entity>, 3> parts_of;

    /// Whether the entities of a mesh may be others than the shape's own.
    bool has_pieces() const {
        return imprinted || !parts_of[0].empty() || !parts_of[1].empty() || !parts_of[2].empty();
    }
    /// The number of entities that are the shape's own.
    std::size_t own_count(int dimension) const;
    /// The node with which a node was joined, or the node itself.
    int node_of(int node) const { return joined_nodes.empty() ? node : joined_nodes[static_cast<std::size_t>(node)]; }
    /// The entity of the shape to which an entity belongs (`parts_of`), or the entity itself.
    Entity of_shape(Entity entity) const;
    /// The indices of all pieces of an entity of the shape; only its own where it was not cut.
    std::vector<int> pieces_of(Entity entity) const;
    /// The edges around and inside a face.
    std::set<int> edges_of(int face) const;
    /// FreeCAD's name of the shape's own entity to which an entity belongs.
    std::string name_of(Entity entity) const;
};

}  // namespace mq::geometry

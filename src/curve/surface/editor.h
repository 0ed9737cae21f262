// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/surface/node_placement.h"

namespace mq::curve {

/// The state on which repairs of the surface work. Every operation of Dey, O'Bara, Shephard 1999, section 5, is a
/// function in a file of its own; all make their change through `replace`, which reverts it unless it improves the
/// surface.
class SurfaceEditor {
  public:
    SurfaceEditor(geometry::Session& session, CurvedSurface& edited) : placement(session, edited), surface(edited) {}

    enum class Rule {
        Improve,     ///< no more invalid triangles than before, and the worst becomes better
        Refine,      ///< no more invalid triangles than before
        RefinePoor,  ///< no more triangles than before that are invalid or hardly valid
        Try,         ///< accepts every result: the caller judges later
    };
    struct Corners {
        std::array<int, 3> corners;
        int face;
    };
    /// Replaces `removed` by `added`, places and measures the new triangles, and decides by the rule.
    bool replace(const std::vector<int>& removed, const std::vector<Corners>& added, Rule rule);

    double deviation(int a, int b) const;  ///< largest distance of the edge's control polygon from its chord, mm
    double length(int a, int b) const;
    /// Root mean square of the distances of the triangles from their CAD faces, mm.
    double rms_deviation(const std::vector<int>& triangles);
    /// The root mean square deviation of the surface at the first call, before any shape was given up, mm: the
    /// reference for repairs. On large surfaces a sample of the triangles is measured.
    double plain_deviation();
    const Vec3& point(int v) const { return surface.shapes.vertices[static_cast<std::size_t>(v)].point; }
    const SurfaceTriangle& triangle(int t) const { return surface.triangles[static_cast<std::size_t>(t)]; }

    Placement placement;
    CurvedSurface& surface;

  private:
    void undo(const std::vector<int>& removed, const std::vector<int>& added,
              const std::vector<std::pair<int, int>>& fresh_edges);
    bool inner_edges_sound(const std::vector<int>& triangles) const;
    bool straight_sound(const std::vector<int>& removed, const std::vector<Corners>& added) const;

    double plain_deviation_ = -1.0;
};

/// Swaps edge (a, b) inside a face for the one between the opposite corners (section 5.3.1).
bool swap_surface_edge(SurfaceEditor& editor, int a, int b);

/// Collapses vertex `a` into its neighbour `b`, along the CAD edge where `a` lies on one (section 5.3.3).
bool collapse_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule);

/// Curves edge (a, b) inside a face so that it no longer crosses the curved edge (a, c): equations (7) to (9), at
/// vertex a. Its nodes stay on the face.
bool curve_face_edge(SurfaceEditor& editor, int a, int b, int c);

/// Puts the nodes of the mesh edges of `triangle` inside its face at even (u, v), or also those of all triangles at its
/// corners. A triangle with straight edges in (u, v) never folds over its face, and elements of high order come near to
/// it. Narrow strips between curved CAD edges need this, as projected edges bend less than the CAD edges.
/// @return whether fewer triangles are invalid, or the worst is better; else nothing is changed.
bool follow_parameters(SurfaceEditor& editor, int triangle);

/// Vertices of the CAD may deviate from the edges and faces at them, and its edges from their faces, by a large
/// fraction of a mesh edge: nodes on the CAD fold the triangles there. Lets the nodes at such corners of `triangle`, or
/// of the bad triangles around it too, leave the CAD towards them (see Placement), where that makes triangles valid or
/// the worst better.
/// @return the number of vertices.
int relax_to_off_cad_vertices(SurfaceEditor& editor, int triangle);

enum class CuspRepair { None, Opened, Refined };

/// Where two CAD edges leave vertex a in one direction, and the triangle between (a, b) and (a, c) has no angle at a:
/// gives the two mesh edges shapes, of lower degree if need be, whose nodes, still on the CAD edges, are moved along
/// them until the quality of the triangle suffices. No shape that follows both edges exactly could be valid there.
/// Where the deviation from the CAD would grow too much, both edges are halved instead: the cusp is opened next to its
/// vertex later.
CuspRepair open_cusp(SurfaceEditor& editor, int a, int b, int c);

/// Vertices of a face may lie on its border within tolerance, or nearly on it, behind a long mesh edge that bends up to
/// them once it is curved: the triangle on that edge, `triangle` or one beside it, and others behind it have no area
/// then. They are removed, and the vertices become vertices of the CAD edge.
/// @return the number of vertices.
int snap_to_boundary(SurfaceEditor& editor, int triangle, SurfaceEditor::Rule rule);

/// Removes the bad triangles around `triangle` from their face, with layers of others where that is not enough, and
/// fills the cavity anew between the curved edges around it: by the triangulation without vertices inside whose worst
/// curved triangle is best (section 5.5, figure 15).
bool retriangulate_cavity(SurfaceEditor& editor, int triangle);

/// Splits edge (a, b) at its middle on the CAD: a boundary point for local remeshing (section 5.5).
/// @return the new vertex, or -1.
int split_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule);

}  // namespace mq::curve

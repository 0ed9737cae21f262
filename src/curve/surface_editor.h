// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/placement.h"

namespace mq::curve {

/// What a repair on the surface works with. Every operation of Dey, O'Bara, Shephard 1999, section 5, is a function
/// in a file of its own; all make their change through `replace`, which takes it back unless it helps.
class SurfaceEditor {
  public:
    SurfaceEditor(geometry::Session& session, Surface& edited) : placement(session, edited), surface(edited) {}

    enum class Rule {
        Improve,     ///< no more invalid triangles than before, and the worst gets better
        Refine,      ///< no more invalid triangles than before
        RefinePoor,  ///< no more triangles than before that are invalid or hardly valid
        Try,         ///< whatever comes: the caller judges later
    };
    struct Corners {
        std::array<int, 3> corners;
        int face;
    };
    /// Puts `added` in the place of `removed`, places and measures what is new, and decides.
    bool replace(const std::vector<int>& removed, const std::vector<Corners>& added, Rule rule);

    double deviation(int a, int b) const;  ///< of the edge's control polygon from its chord
    double length(int a, int b) const;
    /// Root mean square of the distances of the triangles from their CAD faces, mm.
    double rms_deviation(const std::vector<int>& triangles);
    /// That of the surface as it was when first asked for, before shapes were given up: what repairs are held to. Of
    /// large surfaces a part of the triangles stands for all.
    double plain_deviation();
    const Vec3& point(int v) const { return surface.shapes.vertices[static_cast<std::size_t>(v)].point; }
    const SurfaceTriangle& triangle(int t) const { return surface.triangles[static_cast<std::size_t>(t)]; }

    Placement placement;
    Surface& surface;

  private:
    void take_back(const std::vector<int>& removed, const std::vector<int>& added,
                   const std::vector<std::pair<int, int>>& fresh_edges);
    bool inner_edges_sound(const std::vector<int>& triangles) const;
    bool straight_sound(const std::vector<int>& removed, const std::vector<Corners>& added) const;

    double plain_deviation_ = -1.0;
};

/// Swaps edge (a, b) inside a face for the one between the opposite corners (section 5.3.1).
bool swap_surface_edge(SurfaceEditor& editor, int a, int b);

/// Draws vertex `a` into its neighbour `b`, along the CAD edge where `a` lies on one (section 5.3.3).
bool collapse_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule);

/// Curves edge (a, b) inside a face so that it gives way to the curved edge (a, c): equations (7) to (9), at vertex a.
/// Its nodes stay on the face.
bool curve_face_edge(SurfaceEditor& editor, int a, int b, int c);

/// Vertices of the CAD may lie off the edges and faces at them, and its edges off their faces, by much of a mesh edge:
/// nodes on the CAD fold the triangles there. Lets the nodes at such corners of `triangle`, or of the bad triangles
/// around it too, leave the CAD towards them (see Placement), where that makes triangles valid or the worst better.
/// @return how many vertices.
int reach_off_vertices(SurfaceEditor& editor, int triangle);

enum class CuspRepair { None, Opened, Refined };

/// Where two CAD edges leave vertex a in one direction, and the triangle between (a, b) and (a, c) has no angle at a:
/// gives the two mesh edges shapes, of lower degree if need be, whose nodes, still on the CAD edges, are moved along
/// them until the triangle is good enough. No shape that follows both edges exactly could be valid there. Where that
/// would cost too much of the deviation from the CAD, both edges are halved instead: the cusp is opened next to its
/// vertex later.
CuspRepair open_cusp(SurfaceEditor& editor, int a, int b, int c);

/// Vertices of a face may lie on its border within tolerance, or nearly so, behind a long mesh edge that bends up to
/// them once it is curved: the triangle on that edge, `triangle` or one beside it, and others behind it have no area
/// then. They go, and the vertices become vertices of the CAD edge.
/// @return how many.
int snap_to_border(SurfaceEditor& editor, int triangle, SurfaceEditor::Rule rule);

/// Takes the bad triangles around `triangle` out of their face, with layers of others where that is not enough, and
/// fills the cavity anew between the curved edges around it: of all triangulations without vertices inside, the one
/// whose worst curved triangle is best (section 5.5, figure 15).
bool regrow_surface_cavity(SurfaceEditor& editor, int triangle);

/// Splits edge (a, b) at its middle on the CAD: a boundary point for local remeshing (section 5.5).
/// @return the new vertex, or -1.
int split_surface_edge(SurfaceEditor& editor, int a, int b, SurfaceEditor::Rule rule);

}  // namespace mq::curve

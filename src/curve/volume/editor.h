// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// The state on which repairs among tetrahedra work. Every operation of Dey, O'Bara, Shephard 1999, section 5, is a
/// function in a file of its own; all make their change through `replace`, which reverts it unless it improves the
/// elements. New edges and faces inside are straight: curving them comes later.
class VolumeEditor {
  public:
    explicit VolumeEditor(TetrahedralMesh& edited) : volume(edited) {}

    /// The quality of an element, and the best that its fixed edges allow.
    struct Score {
        /// Least J, relative to the straight element, at a corner whose three edges all lie on the surface: no curving
        /// inside can change it. 1 where there is no such corner.
        double fixed = 1.0;
        /// The least Bernstein coefficient of J divided by the largest; for slivers it is reduced.
        double quality = 1.0;
    };
    Score score(const std::array<int, 4>& corners) const;
    /// Score::fixed of a curved element, for which its Jacobian is not formed.
    double fixed_score(const std::array<int, 4>& corners) const;
    Score worst(const std::vector<std::array<int, 4>>& elements) const;

    enum class Rule {
        Free,     ///< the `fixed` score becomes better, and no straight element flat
        Improve,  ///< the worst element becomes better, and the `fixed` score not worse
    };
    /// Replaces `removed` by `added`, which fill the same space.
    bool replace(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added, Rule rule);
    bool better(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added, Rule rule) const;

    const Tetrahedron& tetrahedron(int t) const { return volume.tetrahedra[static_cast<std::size_t>(t)]; }

    TetrahedralMesh& volume;

  private:
    void forget_lost_shapes(const std::vector<int>& removed);
};

/// Removes edge (a, b) inside a volume: the ring of vertices around it is triangulated (section 5.3.1).
bool swap_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule);

/// Removes face (a, b, c) inside a volume: two tetrahedra become three around a new edge (section 5.3.2).
bool swap_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule);

/// Collapses the inner vertex `a` into its neighbour `b` (section 5.3.3).
bool collapse_region_edge(VolumeEditor& editor, int a, int b);

/// Curves an inner edge at a corner of the tetrahedron where J is too small: its middle moves by m across the other two
/// edges there, equations (10) to (12).
bool curve_region_edge(VolumeEditor& editor, int tetrahedron);

/// The inner control points of a face whose nodes are, for cubics, at the average of the centroids of the triangles of
/// each edge's two inner nodes and the opposite vertex (section 5.4.3); for higher orders, at the average of three
/// points between a vertex and the line through the nodes of the edge opposite, at the same fractions as in the
/// straight face.
std::vector<Vec3> average_of_centroids(const elements::CurvedShapes& shapes, const std::array<int, 3>& corners);

/// Moves the inner nodes of face (a, b, c) inside a volume, and with them those of the two regions at it, which are
/// blended from their faces: first to the places blended from its edges or to the average of the centroids, then from
/// the better of the two along the axes by smaller and smaller steps to the place where the worse of the two elements
/// is best. Orders 3 and up; elsewhere, and where the worse element gains nothing, the nodes stay.
bool relocate_face_nodes(VolumeEditor& editor, int a, int b, int c);

/// Puts a vertex on edge (a, b), on face (a, b, c) or into a tetrahedron and moves it to the place where the worst
/// element around it is best: the refinement of a cavity (section 5.5).
bool split_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule);
bool split_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule);
bool split_region(VolumeEditor& editor, int tetrahedron, VolumeEditor::Rule rule);

/// Moves the inner vertex p along the axes, by smaller and smaller steps, to the place where the worst of the elements
/// at it is best.
/// @param size length of the elements' edges, mm.
void relocate_vertex(VolumeEditor& editor, int p, const std::vector<std::array<int, 4>>& star, double size);

}  // namespace mq::curve

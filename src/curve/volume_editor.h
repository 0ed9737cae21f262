// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/volume.h"

namespace mq::curve {

/// What a repair among tetrahedra works with. Every operation of Dey, O'Bara, Shephard 1999, section 5, is a function
/// in a file of its own; all make their change through `replace`, which takes it back unless it helps. New edges and
/// faces inside are straight: curving them comes after.
class VolumeEditor {
  public:
    explicit VolumeEditor(Volume& edited) : volume(edited) {}

    /// How good an element can be made, from what is fixed, and how good it is.
    struct Score {
        /// Least J, relative to the straight element, at a corner whose three edges all lie on the surface: no curving
        /// inside can change it. 1 where there is no such corner.
        double fixed = 1.0;
        /// The least Bernstein coefficient of J by the largest; for slivers less.
        double quality = 1.0;
    };
    Score score(const std::array<int, 4>& corners) const;
    Score worst(const std::vector<std::array<int, 4>>& elements) const;

    enum class Rule {
        Free,     ///< what is fixed becomes better, and no straight element flat
        Improve,  ///< the worst element becomes better, and what is fixed not worse
    };
    /// Puts `added` in the place of `removed`, which fill the same space.
    bool replace(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added, Rule rule);
    bool better(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added, Rule rule) const;

    const Tetrahedron& tetrahedron(int t) const { return volume.tetrahedra[static_cast<std::size_t>(t)]; }

    Volume& volume;

  private:
    void forget_lost_shapes(const std::vector<int>& removed);
};

/// Removes edge (a, b) inside a volume: the ring of vertices around it is triangulated (section 5.3.1).
bool swap_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule);

/// Removes face (a, b, c) inside a volume: two tetrahedra become three around a new edge (section 5.3.2).
bool swap_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule);

/// Draws the inner vertex `a` into its neighbour `b` (section 5.3.3).
bool collapse_region_edge(VolumeEditor& editor, int a, int b);

/// Curves an inner edge at a corner of the tetrahedron where J is too small: its middle moves by m across the other two
/// edges there, equations (10) to (12).
bool curve_region_edge(VolumeEditor& editor, int tetrahedron);

/// The inner control points of a face whose nodes are, for cubics, at the average of the centroids of the triangles of
/// each edge's two inner nodes and the opposite vertex (section 5.4.3); for higher orders, at the average of the three
/// points that lie, as far as in the straight face, between a vertex and the line through the nodes of the edge
/// opposite.
std::vector<Vec3> average_of_centroids(const Shapes& shapes, const std::array<int, 3>& corners);

/// Moves the inner nodes of face (a, b, c) inside a volume, and with them those of the two regions at it, which are
/// blended from their faces: to where its edges blend to or to the average of the centroids, and from the better of the
/// two along the axes by ever smaller steps to where the worse of the two elements is best. Orders 3 and up; elsewhere,
/// and where the worse element gains nothing, the nodes stay.
bool relocate_face_nodes(VolumeEditor& editor, int a, int b, int c);

/// Puts a vertex on edge (a, b), on face (a, b, c) or into a tetrahedron and moves it to where the worst element around
/// it is best: the refinement of a cavity (section 5.5).
bool split_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule);
bool split_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule);
bool split_region(VolumeEditor& editor, int tetrahedron, VolumeEditor::Rule rule);

/// Moves the inner vertex p along the axes, by ever smaller steps, to where the worst of the elements at it is best.
/// @param size of the elements.
void settle_vertex(VolumeEditor& editor, int p, const std::vector<std::array<int, 4>>& star, double size);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include "geometry/face_triangulation.h"
#include "geometry/fingerprint.h"
#include "triangulate/chord_measure.h"
#include "triangulate/triangulate.h"

namespace mq::triangulate {

/// The final mesh of one CAD face, in words that hold for any part that has this face.
struct RememberedFace {
    /// A vertex on a CAD edge: its place in `parameters`.
    struct Knot {
        int use = -1;    ///< in the order of geometry::uses_in_order
        int index = -1;  ///< of the parameter; 0 on a collapsed edge
    };
    /// Of all vertices along the edge of each use, ascending; none of a collapsed edge.
    std::vector<std::vector<double>> parameters;
    std::vector<Knot> knots;
    /// `vertex` of a site is an index into `knots`, `use` of a border counts as in Knot. Points are the part's.
    geometry::FaceTriangulation mesh;
    std::vector<ChordMeasure::Measured> measured;  ///< by half-edge
    std::vector<char> good;                        ///< by triangle: all angles keep the bound
};

/// What one run leaves for the next one of the same part after an edit: about 300 bytes a triangle.
struct Memory {
    Options options;
    double chord = 0.0;       ///< mm, as it was asked for; 0: not
    double resolution = 0.0;  ///< of the grid, mm
    std::map<geometry::Fingerprint, RememberedFace> faces;

    /// Whether faces meshed then are of use now: the same is asked for, on a grid that is no coarser. A tolerance that
    /// follows the part's size may be a little different.
    bool serves(const Options& now, double chord_now, double resolution_now) const;
};

}  // namespace mq::triangulate

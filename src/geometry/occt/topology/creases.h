// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// A shape and its entities in the order of their numbers.
struct OrderedShape {
    TopoDS_Shape shape;
    TopTools_IndexedMapOfShape vertices;
    TopTools_IndexedMapOfShape edges;
    TopTools_IndexedMapOfShape faces;
    std::array<std::vector<Entity>, 3> parts_of;  ///< as in Topology
    std::vector<int> cut_faces;                   ///< faces that have more than one piece, ascending
    TopTools_IndexedMapOfShape replaced;          ///< entities that only keep their number: their pieces represent them

    /// Whether a face of the shape, by its own number, has more than one piece.
    bool is_cut(int face) const { return std::binary_search(cut_faces.begin(), cut_faces.end(), face); }
};

/// The shape with its entities in order, uncut.
/// @throws Cancelled
OrderedShape ordered(const TopoDS_Shape& shape, const Progress* progress);

/// The shape with its surfaces cut along their creases: parameter lines across which the normal jumps, as those of
/// splines through corners, and lines that are a point in space. The shape itself does not change. Pieces have surfaces
/// of their own, so that each has its own normal on the crease. Where OpenCASCADE's division (ShapeUpgrade) loses area
/// the shape stays as it is, and `faults` says so.
/// @throws Cancelled
OrderedShape cut_at_creases(const TopoDS_Shape& shape, std::vector<std::string>& faults, const Progress* progress);

}  // namespace mq::geometry

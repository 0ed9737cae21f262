// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
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
    std::map<int, int> behind;                    ///< by number of a face between two solids: Face::behind

    /// Whether a face of the shape, by its own number, has more than one piece.
    bool is_cut(int face) const { return std::binary_search(cut_faces.begin(), cut_faces.end(), face); }
    /// The number of a face, an edge or a vertex from 0 on; -1: it is none of the shape's.
    int number_of(const TopoDS_Shape& entity) const;
    /// The entity of the shape to which an entity belongs (`parts_of`), or the entity itself.
    Entity of_shape(Entity entity) const;
};

/// The shape with its entities in order, uncut.
/// @throws Cancelled
OrderedShape ordered(const TopoDS_Shape& shape, const Progress* progress);

/// The shape at another place.
OrderedShape moved(OrderedShape shape, const TopLoc_Location& place);

/// Numbers the pieces of a shape: the first piece gets the number of the entity that was cut, the others follow after
/// all entities of the shape. An entity whose only pieces have numbers already is `replaced`.
/// @param result  the shape after it was cut
/// @param pieces_of  for a face, an edge or a vertex of `whole`: what became of it, oriented as it is
OrderedShape number_pieces(const OrderedShape& whole, const TopoDS_Shape& result,
                           const std::function<TopoDS_Shape(const TopoDS_Shape&)>& pieces_of);

}  // namespace mq::geometry

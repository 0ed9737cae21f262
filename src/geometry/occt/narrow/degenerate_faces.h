// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/creases.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Sews gaps that `cut_at_creases` leaves. A piece of a face without area is a curve, or a point: it is removed, and
/// the entities around it become one edge or node. The halves of an edge that runs to and fro on one curve become one
/// edge, too, as on the border in the middle of a wing's flat end. A whole face is removed, too, and named in
/// `topology.faults`, if it lies between two edges and is no wider than their tolerance, or if it is thinner than
/// `topology.detail`. A thin face must lie between edges that run along each other, with nothing but edges shorter than
/// the detail at its ends, or around a ring. Its edges are divided at the nodes across from them, so that they lie in
/// pairs (Topology::parts_of); the faces beside it must still meet at an edge, and those beyond its ends must
/// keep a corner or be as thin.
/// @throws Cancelled
void remove_degenerate_faces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry

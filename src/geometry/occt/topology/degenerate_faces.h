// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/topology/creases.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Sews gaps that `cut_at_creases` leaves. A piece of a face without area is a curve, or a point: it is removed, and
/// the entities around it become one edge or node. The same is done with the halves of an edge that runs to and fro on
/// one curve, as the border in the middle of a wing's flat end does. A whole face between two edges that is no wider
/// than their tolerance is a curve, too; `topology.faults` says so. So is one that is thinner than `topology.detail`
/// between edges that run along each other in pairs, with or without edges shorter than that at its ends, if the faces
/// beside it still make an edge, and those beyond its ends a corner or are as thin.
/// @throws Cancelled
void remove_degenerate_faces(const OrderedShape& shape, Topology& topology, ShapeMap& live, const Progress* progress);

}  // namespace mq::geometry

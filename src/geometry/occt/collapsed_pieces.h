// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/occt/creases.h"
#include "geometry/occt/live_shape.h"

namespace mq::geometry {

/// Sews what `cut_at_creases` leaves open. A piece of a face without area is a curve, or a point: it is taken out, and
/// what borders on it becomes one edge or node. So do the halves of an edge that runs to and fro on one curve, as the
/// border in the middle of a wing's flat end does. A whole face between two edges that is no wider than their tolerance
/// is a curve, too; `topology.faults` says so.
void sew_collapsed_pieces(const OrderedShape& shape, Topology& topology, LiveShape& live);

}  // namespace mq::geometry

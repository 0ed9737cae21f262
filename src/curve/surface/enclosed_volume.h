// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/surface/curved_surface.h"

namespace mq::curve {

/// The volume that the curved triangles enclose, mm^3: the sum over the solids of the model, also those that are inside
/// out; 0 without one. Exact but for rounding: a third of the flux of the position through the triangles, which is a
/// polynomial (divergence theorem).
/// @throws Cancelled
double enclosed_volume(const CurvedSurface& surface, const geometry::Topology& topology, const Progress& progress);

}  // namespace mq::curve

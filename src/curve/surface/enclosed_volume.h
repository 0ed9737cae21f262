// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "curve/surface/curved_surface.h"

namespace mq::curve {

/// The volume that the curved triangles enclose, mm^3: the sum over the solids of the model, also those that are inside
/// out; 0 without one. Exact but for rounding: a third of the flux of the position through the triangles, which is a
/// polynomial (divergence theorem).
double enclosed_volume(const CurvedSurface& surface, const geometry::Topology& topology);

}  // namespace mq::curve

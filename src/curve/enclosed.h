// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "curve/surface.h"

namespace mq::curve {

/// What the curved triangles enclose, mm^3: the solids of the part added up, also those that are inside out; 0 without
/// one. Exact but for rounding: a third of the flux of the position through the triangles, which is a polynomial
/// (divergence theorem).
double enclosed_volume(const Surface& surface, const geometry::Topology& topology);

}  // namespace mq::curve

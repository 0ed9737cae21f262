// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <array>

#include "geometry/topology.h"

namespace mq::geometry {

/// The spans of the edge's curve in its range.
KnotSpans spans_of(const TopoDS_Edge& edge);
/// The spans of u and v in the adaptor's range.
std::array<KnotSpans, 2> spans_of(const GeomAdaptor_Surface& surface);

}  // namespace mq::geometry

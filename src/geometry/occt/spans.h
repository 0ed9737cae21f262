// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <array>

#include "geometry/topology.h"

namespace mq::geometry {

/// Of the edge's curve in its range.
Spans spans_of(const TopoDS_Edge& edge);
/// Of u and v in the adaptor's range.
std::array<Spans, 2> spans_of(const GeomAdaptor_Surface& surface);

}  // namespace mq::geometry

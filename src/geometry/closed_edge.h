// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/topology.h"

/// Parameters over the end of a closed edge. Queries take those of up to a turn before t0 or after t1, except
/// EdgeAtDistance: a mesh edge may reach over the CAD vertex of a rim.
namespace mq::geometry {

bool is_closed(const Edge& edge);

/// The parameter between t0 and t1 of the same point of a closed edge; any other parameter is returned unchanged.
double in_first_turn(const Edge& edge, double t);

/// Whether an edge has a point at t, to within `slack`.
bool has_parameter(const Edge& edge, double t, double slack);

}  // namespace mq::geometry

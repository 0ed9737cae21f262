// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/closed_edge.h"

namespace mq::geometry {

bool is_closed(const Edge& edge) {
    return edge.nodes[0] >= 0 && edge.nodes[0] == edge.nodes[1] && !edge.degenerate;
}

double in_first_turn(const Edge& edge, double t) {
    if (!is_closed(edge) || (t >= edge.t0 && t <= edge.t1)) {
        return t;
    }
    const double turn = edge.t1 - edge.t0;
    const double moved = t < edge.t0 ? t + turn : t - turn;
    return moved >= edge.t0 && moved <= edge.t1 ? moved : t;
}

bool has_parameter(const Edge& edge, double t, double slack) {
    const double own = in_first_turn(edge, t);
    return own >= edge.t0 - slack && own <= edge.t1 + slack;
}

}  // namespace mq::geometry

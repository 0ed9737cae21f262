// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "elements/bezier/jacobian.h"

namespace mq::elements {

inline JacobianForm form_of(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    return jacobian_of(lattice, nodes_to_bezier(lattice, nodes));
}

}  // namespace mq::elements

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// The radii of the innermost shells around the CAD nodes of S_C.
struct CornerShells {
    std::vector<double> innermost;  ///< by vertex: radius of the innermost shell around a CAD node, mm; else 0
    std::vector<int> narrow_nodes;  ///< vertices of nodes with a small input angle, ascending
};

CornerShells corner_shells(const ClassifiedMesh& mesh);

}  // namespace mq::triangulate

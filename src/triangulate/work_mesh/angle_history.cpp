// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/angle_history.h"

#include <cmath>

#include "base/angle.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

void AngleHistory::add(const Workspace& work) {
    const ClassifiedMesh& mesh = work.mesh;
    known_.resize(static_cast<std::size_t>(mesh.triangle_count()));
    double least = M_PI;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.gone(t)) {
            continue;
        }
        Known& known = known_[t];
        if (known.version != std::uint64_t{mesh.stamp(t)} + 1) {
            known = {std::uint64_t{mesh.stamp(t)} + 1, smallest_angle(mesh, t).angle};
        }
        if (known.angle < least && work.exemption_of(t) == nullptr) {
            least = known.angle;
        }
    }
    entries_.push_back({work.triangles(), least / kDegree});
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/topology.h"

namespace mq::geometry {

std::string name_of(Entity entity) {
    static constexpr std::array<const char*, 3> kKinds{"Vertex", "Edge", "Face"};
    if (entity.dimension < 0 || entity.dimension > 2 || entity.index < 0) {
        return "(no entity)";
    }
    return kKinds[static_cast<std::size_t>(entity.dimension)] + std::to_string(entity.index + 1);
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Returns, by vertex, the segment that ends in it and the one that starts there, -1 if there is none. On a CAD edge
/// every vertex has both; a CAD node, where several edges meet, has any of them.
inline std::vector<std::array<int, 2>> segments_at_vertices(const ClassifiedMesh& mesh) {
    std::vector<std::array<int, 2>> segments(static_cast<std::size_t>(mesh.vertex_count()), {-1, -1});
    for (int s = 0; s < mesh.segment_count(); ++s) {
        if (!mesh.segment(s).uses.empty()) {
            segments[static_cast<std::size_t>(mesh.segment(s).vertices[1])][0] = s;
            segments[static_cast<std::size_t>(mesh.segment(s).vertices[0])][1] = s;
        }
    }
    return segments;
}

}  // namespace mq::triangulate

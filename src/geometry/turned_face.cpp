// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/turned_face.h"

#include <utility>

namespace mq::geometry {

void turn_over(FaceTriangulation& face) {
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
        std::swap(face.triangles[t][1], face.triangles[t][2]);
        std::swap(face.links[t][0], face.links[t][2]);
        for (FaceTriangulation::Link& link : face.links[t]) {
            if (link.half_edge >= 0) {
                link.half_edge = 3 * (link.half_edge / 3) + 2 - link.half_edge % 3;
            }
        }
    }
}

}  // namespace mq::geometry

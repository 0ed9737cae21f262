// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/exact_contact.h"
#include "mesh/intersection/self_intersection.h"

namespace mq::mesh {

inline std::vector<ContactPair> brute_force(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    std::vector<ContactPair> pairs;
    for (std::int32_t a = 0; a < int(triangles.size()); ++a) {
        for (std::int32_t b = a + 1; b < int(triangles.size()); ++b) {
            const Contact how = exact::contact(vertices, triangles[a], triangles[b]);
            if (how != Contact::None) {
                pairs.push_back({a, b, how});
            }
        }
    }
    return pairs;
}

}  // namespace mq::mesh

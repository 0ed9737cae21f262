// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contact of two triangles against clipping in rational arithmetic, with none, one or two common vertices.
#include <vector>

#include "bytes.h"
#include "mesh/exact_contact.h"
#include "mesh/intersection/triangle_contact.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    constexpr int kVertices = 6;
    fuzz::Bytes bytes(data, size);
    mesh::Triangle p{0, 1, 2};
    mesh::Triangle q{3, 4, 5};
    const int shared = bytes.number(0, 2);
    for (int i = 0; i < shared; ++i) {
        q[static_cast<std::size_t>(i)] = bytes.number(0, 1) + i;
    }
    std::vector<Vec3> vertices;
    Vec3 before = Vec3::Zero();
    for (int v = 0; v < kVertices; ++v) {
        for (int i = 0; i < 3; ++i) {
            before[i] = bytes.near(before[i]);
        }
        vertices.push_back(before);
    }
    if (q[0] == q[1]) {
        return 0;
    }
    const mesh::Contact found = mesh::contact(vertices, p, q);
    fuzz::require(found == exact::contact(vertices, p, q), "the contact is exact");
    fuzz::require(found == mesh::contact(vertices, q, p), "the contact is the same either way");
    return 0;
}

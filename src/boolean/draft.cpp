// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/draft.h"

namespace mq::boolean {

void remove_gone(Draft& draft) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        if (!gone(draft.triangles[t])) {
            draft.triangles[kept] = draft.triangles[t];
            draft.from[kept] = draft.from[t];
            draft.source[kept++] = draft.source[t];
        }
    }
    draft.triangles.resize(kept);
    draft.source.resize(kept);
    draft.from.resize(kept);
}

void remove_unused_vertices(Draft& draft) {
    std::vector<std::int32_t> index(draft.vertices.size(), -1);
    for (const Triangle& t : draft.triangles) {
        for (const std::int32_t v : t) {
            index[static_cast<std::size_t>(v)] = 0;
        }
    }
    std::size_t kept = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
        if (index[v] == 0) {
            draft.vertices[kept] = draft.vertices[v];
            draft.made[kept] = draft.made[v];
            index[v] = static_cast<std::int32_t>(kept++);
        }
    }
    draft.vertices.resize(kept);
    draft.made.resize(kept);
    draft.places.clear();
    for (Triangle& t : draft.triangles) {
        for (std::int32_t& v : t) {
            v = index[static_cast<std::size_t>(v)];
        }
    }
}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/extraction/result_mesh.h"

#include <algorithm>

namespace mq::boolean {

void add_displacements(ResultMesh& draft, const std::vector<double>& of_vertices) {
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const Triangle& c = draft.triangles[t];
        draft.displacement[t] +=
            std::max({of_vertices[static_cast<std::size_t>(c[0])], of_vertices[static_cast<std::size_t>(c[1])],
                      of_vertices[static_cast<std::size_t>(c[2])]});
    }
}

void remove_triangles(ResultMesh& draft, const std::vector<char>& marked) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < marked.size(); ++t) {
        if (marked[t] == 0) {
            draft.triangles[kept] = draft.triangles[t];
            draft.source[kept] = draft.source[t];
            draft.from[kept] = draft.from[t];
            draft.displacement[kept] = draft.displacement[t];
            ++kept;
        }
    }
    draft.triangles.resize(kept);
    draft.source.resize(kept);
    draft.from.resize(kept);
    draft.displacement.resize(kept);
    remove_unused_vertices(draft);
}

void remove_unused_vertices(ResultMesh& draft) {
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
    for (Triangle& t : draft.triangles) {
        for (std::int32_t& v : t) {
            v = index[static_cast<std::size_t>(v)];
        }
    }
}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/vertex_merging.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "mesh/weld_vertices.h"

namespace mq::boolean {

namespace {

/// Whether the edges opposite to a vertex in its triangles, (from, to) each, are one closed loop of at least three.
bool one_loop(std::vector<std::array<std::int32_t, 2>>& link) {
    std::sort(link.begin(), link.end());
    std::size_t length = 0;
    std::int32_t v = link.front()[0];
    do {
        const auto here = std::lower_bound(link.begin(), link.end(), std::array<std::int32_t, 2>{v, -1});
        if (here == link.end() || (*here)[0] != v || ++length > link.size()) {
            return false;
        }
        v = (*here)[1];
    } while (v != link.front()[0]);
    return length == link.size() && length >= 3;
}

class VertexMerging {
  public:
    explicit VertexMerging(ResultMesh& draft) : draft_(draft), place_(mesh::equal_vertices(draft.vertices)) {}

    bool run() {
        while (part_bad_places()) {
        }
        std::vector<char> gone(draft_.triangles.size(), 0);
        bool any = false;
        for (std::size_t t = 0; t < gone.size(); ++t) {
            const Triangle merged = merged_corners(draft_.triangles[t]);
            any = any || merged != draft_.triangles[t];
            gone[t] = mesh::is_collapsed(merged) ? 1 : 0;
            draft_.triangles[t] = merged;
        }
        if (any) {
            remove_triangles(draft_, gone);
        }
        return any;
    }

  private:
    Triangle merged_corners(const Triangle& c) const { return {place(c[0]), place(c[1]), place(c[2])}; }
    std::int32_t place(std::int32_t v) const { return place_[static_cast<std::size_t>(v)]; }

    /// Separates merged vertices around places at which the surface would be no manifold. False if there are none.
    bool part_bad_places() {
        std::vector<char> touched(place_.size(), 0);
        for (const Triangle& c : draft_.triangles) {
            const Triangle merged = merged_corners(c);
            for (std::size_t k = 0; k < 3; ++k) {
                if (merged[k] != c[k] || mesh::is_collapsed(merged)) {
                    touched[static_cast<std::size_t>(merged[k])] = 1;
                }
            }
        }
        std::unordered_map<std::int32_t, std::vector<std::array<std::int32_t, 2>>> links;
        for (const Triangle& c : draft_.triangles) {
            const Triangle merged = merged_corners(c);
            for (std::size_t k = 0; k < 3 && !mesh::is_collapsed(merged); ++k) {
                if (touched[static_cast<std::size_t>(merged[k])] != 0) {
                    links[merged[k]].push_back({merged[(k + 1) % 3], merged[(k + 2) % 3]});
                }
            }
        }
        std::vector<char> bad(place_.size(), 0);
        for (auto& [v, link] : links) {
            bad[static_cast<std::size_t>(v)] = one_loop(link) ? 0 : 1;
        }
        std::vector<char> parted(place_.size(), 0);
        for (const Triangle& c : draft_.triangles) {
            const Triangle merged = merged_corners(c);
            if (std::any_of(merged.begin(), merged.end(),
                            [&](std::int32_t v) { return bad[static_cast<std::size_t>(v)] != 0; })) {
                for (const std::int32_t v : merged) {
                    parted[static_cast<std::size_t>(v)] = 1;
                }
            }
        }
        bool any = false;
        for (std::size_t v = 0; v < place_.size(); ++v) {
            const auto own = static_cast<std::int32_t>(v);
            if (place_[v] != own && parted[static_cast<std::size_t>(place_[v])] != 0) {
                place_[v] = own;
                any = true;
            }
        }
        return any;
    }

    ResultMesh& draft_;
    std::vector<std::int32_t> place_;  ///< for each vertex the vertex with which it is merged
};

}  // namespace

bool merge_coincident_vertices(ResultMesh& draft) {
    return VertexMerging(draft).run();
}

}  // namespace mq::boolean

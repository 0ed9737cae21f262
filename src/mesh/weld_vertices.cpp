// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/weld_vertices.h"

#include <algorithm>
#include <cstring>

#include "base/key_set.h"

namespace mq::mesh {
namespace {

std::uint64_t hash_of(const Vec3& p) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        const double x = p[i] + 0.0;  // -0 becomes 0
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        hash = KeyHash()(hash ^ bits);
    }
    return hash;
}

/// A hash table with open addressing. The slot keeps some bits of the hash, so that a vertex is looked up only when it
/// is most likely equal.
class PlaceTable {
  public:
    PlaceTable(const std::vector<Vec3>& vertices, std::size_t count) : vertices_(vertices) {
        std::size_t size = 16;
        while (size < 2 * count) {
            size *= 2;
        }
        slots_.resize(size, Slot{-1, 0});
    }

    /// The first vertex in the place of v.
    std::int32_t first_at(std::size_t v) {
        const std::uint64_t hash = hash_of(vertices_[v]);
        const auto tag = static_cast<std::uint32_t>(hash >> 32);
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = hash & mask;
        while (slots_[at].vertex >= 0 &&
               !(slots_[at].tag == tag && vertices_[static_cast<std::size_t>(slots_[at].vertex)] == vertices_[v])) {
            at = (at + 1) & mask;
        }
        if (slots_[at].vertex < 0) {
            slots_[at] = {static_cast<std::int32_t>(v), tag};
        }
        return slots_[at].vertex;
    }

  private:
    struct Slot {
        std::int32_t vertex;
        std::uint32_t tag;
    };

    const std::vector<Vec3>& vertices_;
    std::vector<Slot> slots_;
};

}  // namespace

std::vector<std::int32_t> equal_vertices(const std::vector<Vec3>& vertices) {
    PlaceTable table(vertices, vertices.size());
    std::vector<std::int32_t> first(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        first[v] = table.first_at(v);
    }
    return first;
}

std::vector<std::int32_t> equal_vertices(const std::vector<Vec3>& vertices, const std::vector<char>& marked) {
    PlaceTable table(vertices, static_cast<std::size_t>(std::count(marked.begin(), marked.end(), 1)));
    std::vector<std::int32_t> first(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        first[v] = marked[v] != 0 ? table.first_at(v) : static_cast<std::int32_t>(v);
    }
    return first;
}

}  // namespace mq::mesh

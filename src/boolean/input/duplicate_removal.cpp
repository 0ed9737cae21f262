// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/key_set.h"
#include "boolean/input/operand_mesh.h"
#include "boolean/input/tuning.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {

namespace {

/// Triangles on the same three vertices, found in linear time: in buckets by the lowest vertex.
class DuplicateRemoval {
  public:
    explicit DuplicateRemoval(OperandMesh& draft) : draft_(draft), gone_(draft.triangles.size(), 0) {
        std::vector<std::uint32_t> begin(draft.vertices.size() + 2, 0);
        for (const mesh::Triangle& t : draft.triangles) {
            ++begin[*std::min_element(t.begin(), t.end()) + 2];
        }
        for (std::size_t v = 2; v < begin.size(); ++v) {
            begin[v] += begin[v - 1];
        }
        entries_.resize(draft.triangles.size());
        for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
            const Entry entry = entry_of(t);
            entries_[begin[entry.sorted[0] + 1]++] = entry;
        }
        for (std::size_t v = 0; v < draft.vertices.size(); ++v) {
            std::sort(entries_.begin() + begin[v], entries_.begin() + begin[v + 1], [](const Entry& a, const Entry& b) {
                return a.sorted != b.sorted ? a.sorted < b.sorted : a.triangle < b.triangle;
            });
        }
    }

    /// @return the number of triangles removed
    std::size_t run() {
        std::vector<std::array<std::size_t, 2>> balanced;
        for (std::size_t i = 0; i < entries_.size();) {
            std::size_t j = i;
            int balance = 0;
            for (; j < entries_.size() && entries_[j].sorted == entries_[i].sorted; ++j) {
                balance += entries_[j].even ? 1 : -1;
            }
            if (j - i > 1 && balance == 0) {
                balanced.push_back({i, j});
            } else if (j - i > 1) {
                keep_one(i, j, balance);
            }
            i = j;
        }
        if (!balanced.empty()) {
            decide(balanced);
        }
        if (removed_ > 0) {
            draft_.mates.clear();
            draft_.remove(gone_);
        }
        return removed_;
    }

  private:
    struct Entry {
        mesh::Triangle sorted;
        bool even;  ///< the triangle is an even permutation of it
        std::int32_t triangle;
    };

    Entry entry_of(std::size_t t) const {
        mesh::Triangle s = draft_.triangles[t];
        std::rotate(s.begin(), std::min_element(s.begin(), s.end()), s.end());
        const bool even = s[1] < s[2];
        if (!even) {
            std::swap(s[1], s[2]);
        }
        return {s, even, static_cast<std::int32_t>(t)};
    }

    /// Keeps the first of the even triangles (balance > 0), or of the odd ones (< 0), or none.
    void keep_one(std::size_t first, std::size_t last, int balance) {
        bool keep = balance != 0;
        for (std::size_t k = first; k < last; ++k) {
            const bool kept = keep && entries_[k].even == (balance > 0);
            keep = keep && !kept;
            gone_[entries_[k].triangle] = static_cast<char>(!kept);
            removed_ += kept ? 0 : 1;
        }
    }

    /// Decides for sets with as many triangles in one direction as in the other: the neighbours tell which triangle is
    /// needed, if any. One triangle is kept if the whole surface around is drawn from both sides.
    void decide(const std::vector<std::array<std::size_t, 2>>& balanced) {
        const mesh::VertexStars stars(draft_.triangles, draft_.vertices.size());
        std::vector<char> asked(draft_.triangles.size(), 0);
        for (const auto& [first, last] : balanced) {
            for (std::size_t k = first; k < last; ++k) {
                asked[entries_[k].triangle] = 1;
            }
        }
        const std::vector<char> two_sided = find_two_sided(balanced, stars, asked);
        for (std::size_t g = 0; g < balanced.size(); ++g) {
            const auto& [first, last] = balanced[g];
            const mesh::Triangle& t = entries_[first].sorted;
            int wanted = two_sided[g];
            for (int i = 0; i < 3 && two_sided[g] == 0; ++i) {
                wanted +=
                    count_edges(stars[t[(i + 1) % 3]], t[i], asked) - count_edges(stars[t[i]], t[(i + 1) % 3], asked);
            }
            keep_one(first, last, wanted);
        }
    }

    /// Which sets of triangles in balance belong to a surface that is drawn from both sides. Such a surface has no
    /// other surface beside it, and it is closed, or its border is short enough that it may be filled. A border of
    /// length L can be filled with an area of at most L^2 / (4 pi) (isoperimetric inequality).
    std::vector<char> find_two_sided(const std::vector<std::array<std::size_t, 2>>& balanced,
                                     const mesh::VertexStars& stars, const std::vector<char>& asked) const {
        std::unordered_map<std::uint64_t, std::size_t> first_at;  // by edge, the first set that has it
        DisjointSets<std::size_t> surfaces(balanced.size());
        std::unordered_map<std::uint64_t, double> open;  // by edge without a neighbour, its length
        std::vector<double> area(balanced.size(), 0.0);
        std::vector<double> border(balanced.size(), 0.0);
        std::vector<char> alone(balanced.size(), 1);
        for (std::size_t g = 0; g < balanced.size(); ++g) {
            const mesh::Triangle& t = entries_[balanced[g][0]].sorted;
            for (int i = 0; i < 3; ++i) {
                const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
                const auto [other, fresh] = first_at.emplace(pair_key(low, high), g);
                if (fresh) {
                    open[pair_key(low, high)] = (draft_.vertices[low] - draft_.vertices[high]).norm();
                } else {
                    open.erase(pair_key(low, high));
                }
                surfaces.unite(g, other->second);
                if (count_edges(stars[low], high, asked) + count_edges(stars[high], low, asked) > 0) {
                    alone[g] = 0;
                }
            }
        }
        std::vector<char> result(balanced.size(), 1);
        for (std::size_t g = 0; g < balanced.size(); ++g) {
            const std::size_t surface = surfaces.find(g);
            area[surface] += draft_.area(entries_[balanced[g][0]].triangle);
            result[surface] &= alone[g];
        }
        for (const auto& [edge, length] : open) {
            border[surfaces.find(first_at.at(edge))] += length;
        }
        for (std::size_t g = 0; g < balanced.size(); ++g) {
            const std::size_t s = surfaces.find(g);
            const bool closable = border[s] * border[s] <= 4.0 * M_PI * InputTuning::kLargestFilledShare * area[s];
            result[g] = static_cast<char>(result[s] != 0 && closable);
        }
        return result;
    }

    /// Number of directed edges from the star's vertex to `head` in triangles that are not candidates themselves.
    int count_edges(mesh::VertexStars::Star star, std::int32_t head, const std::vector<char>& asked) const {
        return static_cast<int>(std::count_if(star.begin(), star.end(), [&](std::uint32_t corner) {
            return asked[corner / 3] == 0 && draft_.head(static_cast<std::int32_t>(corner)) == head;
        }));
    }

    OperandMesh& draft_;
    std::vector<Entry> entries_;
    std::vector<char> gone_;
    std::size_t removed_ = 0;
};

}  // namespace

void remove_duplicates(OperandMesh& draft) {
    draft.repairs.duplicate += DuplicateRemoval(draft).run();
}

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operand_mesh.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "base/predicates.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {

void OperandMesh::remove(const std::vector<char>& marked) {
    std::vector<std::int32_t> place(triangles.size(), -1);
    std::size_t count = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (marked[t] == 0) {
            place[t] = static_cast<std::int32_t>(count);
            triangles[count] = triangles[t];
            source[count] = source[t];
            ++count;
        }
    }
    if (!mates.empty()) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (int i = 0; i < 3 && place[t] >= 0; ++i) {
                const std::int32_t mate = mates[3 * t + i];
                const std::int32_t moved = mate < 0 ? mate : place[mate / 3];
                mates[3 * place[t] + i] = mate < 0 ? mate : moved < 0 ? mesh::kBorder : 3 * moved + mate % 3;
            }
        }
        mates.resize(3 * count);
    }
    triangles.resize(count);
    source.resize(count);
}

void OperandMesh::turn(const std::vector<char>& marked) {
    const auto moved = [&](std::int32_t h) { return h >= 0 && marked[h / 3] != 0 ? turned(h) : h; };
    std::vector<std::int32_t> mates_then(mates.size());
    for (std::size_t h = 0; h < mates.size(); ++h) {
        mates_then[moved(static_cast<std::int32_t>(h))] = moved(mates[h]);
    }
    mates.swap(mates_then);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (marked[t] != 0) {
            std::swap(triangles[t][1], triangles[t][2]);
            ++repairs.flipped;
        }
    }
}

double OperandMesh::area(std::int32_t triangle) const {
    const mesh::Triangle& t = triangles[triangle];
    return 0.5 * (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]).norm();
}

std::string OperandMesh::position(const Vec3& local) const {
    const Vec3 p = local + origin;
    char text[120];
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g) mm", p.x(), p.y(), p.z());
    return text;
}

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

    /// Decides where as many triangles run one way as the other: the neighbours tell which one is needed, if any.
    void decide(const std::vector<std::array<std::size_t, 2>>& balanced) {
        const mesh::VertexStars stars(draft_.triangles, draft_.vertices.size());
        std::vector<char> asked(draft_.triangles.size(), 0);
        for (const auto& [first, last] : balanced) {
            for (std::size_t k = first; k < last; ++k) {
                asked[entries_[k].triangle] = 1;
            }
        }
        for (const auto& [first, last] : balanced) {
            const mesh::Triangle& t = entries_[first].sorted;
            int wanted = 0;
            for (int i = 0; i < 3; ++i) {
                wanted +=
                    count_edges(stars[t[(i + 1) % 3]], t[i], asked) - count_edges(stars[t[i]], t[(i + 1) % 3], asked);
            }
            keep_one(first, last, wanted);
        }
    }

    /// Directed edges from the star's vertex to `head` of triangles that are not in question themselves.
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

namespace {

/// Removal of degenerate triangles by swapping their long edge into the neighbour.
class DegenerateRemoval {
  public:
    explicit DegenerateRemoval(OperandMesh& draft) : draft_(draft), gone_(draft.triangles.size(), 0) {
        for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
            if (degenerate(draft.triangles[t])) {
                left_.push_back(static_cast<std::int32_t>(t));
            }
        }
    }

    std::size_t run() {
        const std::size_t before = left_.size();
        std::size_t last = 0;
        while (last != left_.size()) {
            last = left_.size();
            left_.erase(std::remove_if(left_.begin(), left_.end(), [this](std::int32_t t) { return remove(t); }),
                        left_.end());
        }
        if (std::find(gone_.begin(), gone_.end(), 1) != gone_.end()) {
            draft_.remove(gone_);
        }
        return before - left_.size();
    }

  private:
    bool degenerate(const mesh::Triangle& t) const {
        return collinear(draft_.vertices[t[0]], draft_.vertices[t[1]], draft_.vertices[t[2]]);
    }

    /// The corner at which the triangle's long edge begins.
    std::int32_t long_edge(std::int32_t t) const {
        for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::int32_t c = mesh::next_corner(h);
            if (sign_dot(draft_.point(h), draft_.point(c), draft_.point(mesh::next_corner(c))) < 0) {
                return c;
            }
        }
        return -1;
    }

    bool remove(std::int32_t t) {
        if (gone_[t] != 0 || remove_fold(t)) {
            return true;
        }
        const std::int32_t h = long_edge(t);
        const std::int32_t g = h < 0 ? mesh::kIrregular : draft_.mates[h];
        if (g == mesh::kIrregular) {
            return false;
        }
        if (g == mesh::kBorder) {
            for (std::int32_t e = 3 * t; e < 3 * t + 3; ++e) {
                if (draft_.mates[e] >= 0) {
                    draft_.mates[draft_.mates[e]] = mesh::kBorder;
                    draft_.mates[e] = mesh::kBorder;
                }
            }
            gone_[t] = 1;
            return true;
        }
        return swap(h, g);
    }

    /// Removes a triangle together with one that coincides with it, its neighbour along two edges or all three.
    bool remove_fold(std::int32_t t) {
        for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::int32_t g = draft_.mates[h];
            const std::int32_t k = draft_.mates[mesh::next_corner(h)];
            if (g < 0 || k < 0 || g / 3 != k / 3) {
                continue;
            }
            const std::int32_t n = g / 3;
            const std::int32_t x = draft_.mates[mesh::previous_corner(h)];
            // The mate of the corner of n that is neither g nor k.
            const std::int32_t y = draft_.mates[9 * n + 3 - g - k];
            if (x >= 0 && x / 3 != n) {
                draft_.mates[x] = y;
            }
            if (y >= 0 && y / 3 != t) {
                draft_.mates[y] = x;
            }
            gone_[t] = 1;
            gone_[n] = 1;
            return true;
        }
        return false;
    }

    /// t = (c, a, b) with h from c to a, and n = (a, c, d) become (a, b, d) and (b, c, d).
    bool swap(std::int32_t h, std::int32_t g) {
        const std::int32_t t = h / 3;
        const std::int32_t n = g / 3;
        const std::int32_t a = draft_.head(h);
        const std::int32_t c = draft_.tail(h);
        const std::int32_t b = draft_.tail(mesh::previous_corner(h));
        const std::int32_t d = draft_.tail(mesh::previous_corner(g));
        const mesh::Triangle first{a, b, d};
        const mesh::Triangle second{b, c, d};
        if (b == d || degenerate(first) || degenerate(second)) {
            return false;
        }
        const std::int32_t ab = draft_.mates[mesh::next_corner(h)];
        const std::int32_t bc = draft_.mates[mesh::previous_corner(h)];
        const std::int32_t cd = draft_.mates[mesh::next_corner(g)];
        const std::int32_t da = draft_.mates[mesh::previous_corner(g)];
        draft_.triangles[t] = first;
        draft_.triangles[n] = second;
        draft_.source[t] = draft_.source[n];
        put(3 * t, ab);
        put(3 * t + 2, da);
        put(3 * n, bc);
        put(3 * n + 1, cd);
        draft_.pair(3 * t + 1, 3 * n + 2);
        return true;
    }

    void put(std::int32_t h, std::int32_t mate) {
        draft_.mates[h] = mate;
        if (mate >= 0) {
            draft_.mates[mate] = h;
        }
    }

    OperandMesh& draft_;
    std::vector<char> gone_;
    std::vector<std::int32_t> left_;
};

}  // namespace

std::size_t remove_degenerate(OperandMesh& draft) {
    return DegenerateRemoval(draft).run();
}

void split_fans(OperandMesh& draft) {
    const mesh::VertexFans fans = mesh::fans(draft.triangles, draft.mates);
    std::vector<char> taken(draft.vertices.size(), 0);
    std::vector<std::int32_t> vertex(fans.vertex_of.size());
    for (std::size_t f = 0; f < vertex.size(); ++f) {
        const std::int32_t v = fans.vertex_of[f];
        vertex[f] = v;
        if (taken[v] != 0) {
            vertex[f] = static_cast<std::int32_t>(draft.vertices.size());
            const Vec3 copy = draft.vertices[v];
            draft.vertices.push_back(copy);
            draft.repairs.nonmanifold_vertices += taken[v] == 1 ? 1 : 0;
            taken[v] = 2;
        } else {
            taken[v] = 1;
        }
    }
    for (std::size_t h = 0; h < fans.fan_of.size(); ++h) {
        draft.triangles[h / 3][h % 3] = vertex[fans.fan_of[h]];
    }
}

}  // namespace mq::boolean

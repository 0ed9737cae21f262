// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operand_mesh.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "base/message.h"
#include "base/predicates.h"

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
    return in_mm(local + origin, 6);
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

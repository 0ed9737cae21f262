// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/perturbation/perturbation.h"

#include <algorithm>

#include "base/predicates.h"

namespace mq::boolean {

namespace {

/// A number from -1 to 1 (Steele, Lea and Flood 2014, the mixing of SplitMix64).
double random_number(std::uint64_t key) {
    key += 0x9E3779B97F4A7C15ULL;
    key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ULL;
    key = (key ^ (key >> 27)) * 0x94D049BB133111EBULL;
    key ^= key >> 31;
    return static_cast<double>(key >> 11) * 0x1p-52 - 1.0;
}

/// The vertices of some triangles, each once; only of triangles that do not belong to operand `but`.
std::vector<std::int32_t> vertices_of(const Soup& soup, const std::vector<std::int32_t>& triangles, std::int32_t but) {
    std::vector<std::int32_t> result;
    for (const std::int32_t t : triangles) {
        if (soup.source[static_cast<std::size_t>(t)].operand != but) {
            const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
            result.insert(result.end(), c.begin(), c.end());
        }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

double move_to(Soup& soup, std::int32_t v, const Vec3& target) {
    Vec3& p = soup.vertices[static_cast<std::size_t>(v)];
    const double length = (target - p).norm();
    p = target;
    soup.moved.resize(soup.vertices.size(), 0);
    soup.moved[static_cast<std::size_t>(v)] = 1;
    return length;
}

}  // namespace

double perturb(Soup& soup, const std::vector<std::int32_t>& triangles, double length, std::uint64_t draw) {
    double largest = 0.0;
    std::vector<std::int32_t> vertices = vertices_of(soup, triangles, 0);
    if (vertices.empty()) {
        vertices = vertices_of(soup, triangles, -1);
    }
    for (const std::int32_t v : vertices) {
        Vec3 way;
        for (int i = 0; i < 3; ++i) {
            way[i] = random_number((draw << 40) + 3 * static_cast<std::uint64_t>(v) + static_cast<std::uint64_t>(i));
        }
        const Vec3 target = to_single(soup.vertices[static_cast<std::size_t>(v)] + length * way);
        largest = std::max(largest, move_to(soup, v, target));
    }
    return largest;
}

void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before) {
    const auto moved = [&](int v) -> char& { return soup.moved[static_cast<std::size_t>(v)]; };
    const auto at = [&](int v) -> Vec3& { return soup.vertices[static_cast<std::size_t>(v)]; };
    for (bool again = !soup.moved.empty(); again;) {
        again = false;
        for (const Triangle& c : soup.triangles) {
            if (std::any_of(c.begin(), c.end(), moved) && collinear(at(c[0]), at(c[1]), at(c[2]))) {
                for (const int v : c) {
                    at(v) = before[static_cast<std::size_t>(v)];
                    moved(v) = 0;
                }
                again = true;
            }
        }
    }
}

}  // namespace mq::boolean

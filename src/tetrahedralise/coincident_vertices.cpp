// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/coincident_vertices.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::tetrahedralise {

namespace {

using Triangle = std::array<int, 3>;

Triangle sorted(Triangle corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// A tetrahedron at a point of several given vertices.
struct Around {
    int tetrahedron;
    std::size_t corner;
    int given = -1;  ///< its vertex at the point, one of the given ones; -1: not known yet
};

/// The three faces of a tetrahedron at one of its corners.
std::array<Triangle, 3> faces_at(const std::array<int, 4>& v, std::size_t corner) {
    std::array<Triangle, 3> faces{};
    for (std::size_t k = 0; k < 3; ++k) {
        faces[k] = sorted({v[corner], v[(corner + 1 + k) % 4], v[(corner + 1 + (k + 1) % 3) % 4]});
    }
    return faces;
}

/// Assigns to each tetrahedron around a point the vertex of the surface triangles that can be reached from it through
/// tetrahedra.
/// @param walls the given vertex of each surface triangle at the point
void find_sides(std::vector<Around>& star, const std::vector<std::array<int, 4>>& tetrahedra,
                const std::map<Triangle, int>& walls) {
    std::map<Triangle, std::vector<Around*>> at_face;
    std::vector<Around*> queue;
    const auto assign = [&](Around& one, int given) {
        if (one.given < 0) {
            one.given = given;
            queue.push_back(&one);
        } else if (one.given != given) {
            throw MeshingFailed(phrases::kVerticesNotParted);
        }
    };
    for (Around& one : star) {
        for (const Triangle& f : faces_at(tetrahedra[one.tetrahedron], one.corner)) {
            if (const auto wall = walls.find(f); wall != walls.end()) {
                assign(one, wall->second);
            } else {
                at_face[f].push_back(&one);
            }
        }
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (const Triangle& f : faces_at(tetrahedra[queue[i]->tetrahedron], queue[i]->corner)) {
            for (Around* other : at_face[f]) {
                assign(*other, queue[i]->given);
            }
        }
    }
}

}  // namespace

CoincidentVertices::CoincidentVertices(const std::vector<Vec3>& all, const std::vector<Triangle>& given,
                                       const EndTangents& given_tangents)
    : given_(given), given_points_(all.size()) {
    std::map<std::array<double, 3>, int> at;
    std::vector<int> number;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec3& p = all[i];
        const auto [found, fresh] = at.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, points.size());
        if (fresh) {
            points.push_back(p);
            first_.push_back(static_cast<int>(i));
            shared_.push_back(0);
        } else {
            shared_[found->second] = 1;
        }
        number.push_back(found->second);
    }
    for (const Triangle& t : given) {
        triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    }
    for (const auto& [edge, tangent] : given_tangents) {
        tangents.emplace(directed_edge(number[edge >> 32], number[edge & 0xFFFFFFFFU]), tangent);
    }
}

Tetrahedra CoincidentVertices::separate(Tetrahedra result) const {
    const auto vertices = static_cast<int>(points.size());
    std::map<int, std::map<Triangle, int>> walls;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (shared_[triangles[t][k]]) {
                walls[triangles[t][k]][sorted(triangles[t])] = given_[t][k];
            }
        }
    }
    std::map<int, std::vector<Around>> stars;
    const std::vector<std::array<int, 4>> welded = result.tetrahedra;
    for (std::size_t i = 0; i < welded.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            const int v = welded[i][k];
            if (v < vertices && shared_[v]) {
                stars[v].push_back({static_cast<int>(i), k});
            }
            result.tetrahedra[i][k] = v < vertices ? first_[v] : v - vertices + static_cast<int>(given_points_);
        }
    }
    for (auto& [v, star] : stars) {
        find_sides(star, welded, walls[v]);
        for (const Around& one : star) {
            result.tetrahedra[one.tetrahedron][one.corner] = one.given;
        }
    }
    return result;
}

}  // namespace mq::tetrahedralise

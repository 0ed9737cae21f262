// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/surface_constraints.h"

#include <algorithm>
#include <utility>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::tetrahedralise {

SurfaceConstraints::SurfaceConstraints(const std::vector<Triangle>& triangles) {
    for (const Triangle& t : triangles) {
        add(t);
    }
    if (faces_.size() != triangles.size()) {
        throw MeshingFailed(phrases::kTrianglesCoincide);
    }
    for (const auto& [edge, around] : edges_) {
        if (around.size() % 2 != 0) {
            throw MeshingFailed(phrases::kSurfaceNotClosed);
        }
    }
}

SurfaceConstraints::Triangle SurfaceConstraints::key(int a, int b, int c) {
    Triangle sorted{a, b, c};
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

void SurfaceConstraints::add(const Triangle& t) {
    faces_[key(t[0], t[1], t[2])] = t;
    for (std::size_t k = 0; k < 3; ++k) {
        edges_[pair_key(t[k], t[(k + 1) % 3])].push_back(t);
    }
}

void SurfaceConstraints::remove(const Triangle& t) {
    faces_.erase(key(t[0], t[1], t[2]));
    for (std::size_t k = 0; k < 3; ++k) {
        const auto found = edges_.find(pair_key(t[k], t[(k + 1) % 3]));
        std::vector<Triangle>& around = found.value();
        around.erase(std::find(around.begin(), around.end(), t));
        if (around.empty()) {
            edges_.erase(found);
        }
    }
}

std::vector<std::array<int, 2>> SurfaceConstraints::edges() const {
    std::vector<std::array<int, 2>> list;
    for (const auto& [edge, around] : edges_) {
        list.push_back({static_cast<int>(edge >> 32), static_cast<int>(edge & 0xFFFFFFFFU)});
    }
    std::sort(list.begin(), list.end());
    return list;
}

std::vector<SurfaceConstraints::Triangle> SurfaceConstraints::triangles() const {
    std::vector<Triangle> list;
    for (const auto& [sorted, triangle] : faces_) {
        list.push_back(triangle);
    }
    std::sort(list.begin(), list.end());
    return list;
}

void SurfaceConstraints::divide_edge(int a, int b, int vertex) {
    Division division{vertex, edges_.at(pair_key(a, b)), {}};
    if (division.parents.size() > 2) {
        throw MeshingFailed(phrases::kShellEdgeNotRecovered);
    }
    for (const Triangle& t : division.parents) {
        for (const int end : {a, b}) {
            Triangle child = t;
            std::replace(child.begin(), child.end(), end, vertex);
            division.children.push_back(child);
        }
    }
    divide(std::move(division));
}

void SurfaceConstraints::divide_triangle(const Triangle& t, int vertex) {
    divide({vertex, {t}, {{t[0], t[1], vertex}, {t[1], t[2], vertex}, {t[2], t[0], vertex}}});
}

void SurfaceConstraints::divide(Division division) {
    for (const Triangle& t : division.parents) {
        remove(t);
    }
    for (const Triangle& t : division.children) {
        add(t);
    }
    divisions_.push_back(std::move(division));
}

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/star_cavity.h"

#include <algorithm>
#include <set>
#include <utility>

namespace mq::tetrahedralise {

bool StarCavity::open(const Vec3& p, const std::vector<int>& start, int own,
                      const std::vector<std::array<int, 3>>& more) {
    /// Most cells that may join: if more are needed, the point is in the wrong place.
    constexpr std::size_t kMostMore = 24;
    cells_ = start;
    Step last = Step::Grown;
    while (last == Step::Grown && cells_.size() <= start.size() + kMostMore) {
        last = step(p, own);
    }
    if (last != Step::Done) {
        return false;
    }
    for (const auto& f : more) {
        if (orient3d(mesh_.point(f[0]), mesh_.point(f[1]), mesh_.point(f[2]), p) <= 0) {
            return false;
        }
        faces_.push_back(f);
    }
    return keeps_all(own);
}

StarCavity::Step StarCavity::step(const Vec3& p, int own) {
    faces_.clear();
    for (const int c : cells_) {
        const Cell& cell = mesh_.cells[c];
        for (int face = 0; face < 4; ++face) {
            const int(&k)[3] = kFaceOf[face];
            const std::array<int, 3> f{cell.v[k[0]], cell.v[k[1]], cell.v[k[2]]};
            const bool inner =
                cell.n[face] >= 0 && std::find(cells_.begin(), cells_.end(), cell.n[face]) != cells_.end();
            if (inner || std::find(f.begin(), f.end(), own) != f.end()) {
                continue;
            }
            if (orient3d(mesh_.point(f[0]), mesh_.point(f[1]), mesh_.point(f[2]), p) > 0) {
                faces_.push_back(f);
                continue;
            }
            if (cell.n[face] < 0 || surface_.has_triangle(f[0], f[1], f[2])) {
                return Step::Blocked;
            }
            cells_.push_back(cell.n[face]);
            return Step::Grown;
        }
    }
    return Step::Done;
}

bool StarCavity::keeps_all(int own) const {
    std::set<std::pair<int, int>> kept;
    std::set<int> corners;
    for (const auto& f : faces_) {
        for (std::size_t k = 0; k < 3; ++k) {
            kept.insert(std::minmax(f[k], f[(k + 1) % 3]));
            corners.insert(f[k]);
        }
    }
    for (const int c : cells_) {
        const auto& v = mesh_.cells[c].v;
        for (std::size_t i = 0; i < 4; ++i) {
            if (v[i] == own) {
                continue;
            }
            if (corners.count(v[i]) == 0) {
                return false;
            }
            for (std::size_t k = 0; k < i; ++k) {
                if (v[k] != own && surface_.has_edge(v[i], v[k]) && kept.count(std::minmax(v[i], v[k])) == 0) {
                    return false;
                }
            }
        }
    }
    return true;
}

std::vector<std::array<int, 4>> StarCavity::cells_of(int vertex) const {
    std::vector<std::array<int, 4>> cells;
    for (const auto& f : faces_) {
        cells.push_back({f[0], f[1], f[2], vertex});
    }
    return cells;
}

}  // namespace mq::tetrahedralise

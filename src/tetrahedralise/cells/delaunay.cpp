// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/cells/delaunay.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/key_set.h"
#include "base/predicates.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::tetrahedralise {

int Locator::find(const Vec3& p, int start) {
    int cell = start;
    // Without the Delaunay property a walk may run in circles; as other faces come first in each step, it ends.
    const std::size_t most = 200 + 8 * mesh_.cells.size();
    for (std::size_t step = 0; step < most && cell >= 0; ++step) {
        const Cell& c = mesh_.cells[cell];
        turn_ = turn_ * 1664525U + 1013904223U;
        int next = cell;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const int face = static_cast<int>((i + (turn_ >> 16)) % 4);
            const int(&f)[3] = kFaceOf[face];
            if (orient3d(mesh_.point(c.v[f[0]]), mesh_.point(c.v[f[1]]), mesh_.point(c.v[f[2]]), p) < 0) {
                next = c.n[face];
                break;
            }
        }
        if (next == cell) {
            return cell;
        }
        cell = next;
    }
    return -1;
}

bool CavityInsertion::open(const Vec3& p, int cell) {
    inside_.resize(mesh_.cells.size(), 0);
    seen_.resize(mesh_.cells.size(), 0);
    grow(p, cell);
    looked_at_ = cavity_;
    looked_at_.insert(looked_at_.end(), corners_.begin(), corners_.end());
    const bool found = shrink(p, cell) && collect_corners();
    for (const int c : cavity_) {
        inside_[c] = 0;
    }
    return found;
}

void CavityInsertion::grow(const Vec3& p, int cell) {
    cavity_ = {cell};
    inside_[cell] = 1;
    corners_.clear();  // cells that were examined and are not in conflict
    for (std::size_t i = 0; i < cavity_.size(); ++i) {
        for (const int other : mesh_.cells[cavity_[i]].n) {
            if (other < 0 || inside_[other] || seen_[other]) {
                continue;
            }
            const std::array<int, 4>& v = mesh_.cells[other].v;
            if (in_sphere(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3]), p) > 0) {
                inside_[other] = 1;
                cavity_.push_back(other);
            } else {
                seen_[other] = 1;
                corners_.push_back(other);
            }
        }
    }
    for (const int c : corners_) {
        seen_[c] = 0;
    }
}

bool CavityInsertion::shrink(const Vec3& p, int cell) {
    while (true) {
        faces_.clear();
        int unseen = -1;
        for (std::size_t i = 0; i < cavity_.size() && unseen < 0; ++i) {
            const Cell& c = mesh_.cells[cavity_[i]];
            for (int face = 0; face < 4; ++face) {
                if (c.n[face] >= 0 && inside_[c.n[face]]) {
                    continue;
                }
                const std::array<int, 4> v{c.v[kFaceOf[face][0]], c.v[kFaceOf[face][1]], c.v[kFaceOf[face][2]], -1};
                if (orient3d(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), p) <= 0) {
                    unseen = static_cast<int>(i);
                    break;
                }
                faces_.push_back(v);
            }
        }
        if (unseen < 0) {
            return true;
        }
        if (cavity_[unseen] == cell) {
            return false;
        }
        inside_[cavity_[unseen]] = 0;
        // A cell that was connected through the removed cell may no longer be connected: the cavity is collected again.
        for (const int c : cavity_) {
            seen_[c] = inside_[c];
            inside_[c] = 0;
        }
        const std::vector<int> before = std::exchange(cavity_, {cell});
        inside_[cell] = 1;
        for (std::size_t i = 0; i < cavity_.size(); ++i) {
            for (const int other : mesh_.cells[cavity_[i]].n) {
                if (other >= 0 && seen_[other] && !inside_[other]) {
                    inside_[other] = 1;
                    cavity_.push_back(other);
                }
            }
        }
        for (const int c : before) {
            seen_[c] = 0;
        }
    }
}

/// The corners of the cavity, which must all lie on its faces: a vertex inside would get lost.
bool CavityInsertion::collect_corners() {
    const auto unique = [](std::vector<int>& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    corners_.clear();
    for (const auto& f : faces_) {
        corners_.insert(corners_.end(), f.begin(), f.end() - 1);
    }
    unique(corners_);
    std::vector<int>& all = created_;
    all.clear();
    for (const int c : cavity_) {
        all.insert(all.end(), mesh_.cells[c].v.begin(), mesh_.cells[c].v.end());
    }
    unique(all);
    return all.size() == corners_.size();
}

void CavityInsertion::close(int v) {
    for (auto& f : faces_) {
        f[3] = v;
    }
    mesh_.replace(cavity_, faces_, created_);
}

namespace {

/// Spreads the bits of a coordinate to every third position.
std::uint64_t spread(std::uint64_t bits) {
    std::uint64_t result = 0;
    for (int i = 0; i < 20; ++i) {
        result |= ((bits >> i) & 1U) << (3 * i);
    }
    return result;
}

/// A biased randomised order (Amenta, Choi and Rote 2003): a random half of the points comes last, a random half of the
/// others before it, and so on; within each round neighbours follow each other. Without the rounds the points of a grid
/// make long flat cells on the way.
std::vector<int> insertion_order(const std::vector<Vec3>& points, const Box& box) {
    const double scale = 0x1p20 / std::max(box.largest_side() * (1.0 + 1e-9), 1e-300);
    std::vector<std::pair<std::uint64_t, int>> keys;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 x = (points[i] - box.low) * scale;
        const std::uint64_t hash = KeyHash()(i + 1);
        std::uint64_t round = 15;
        while (round > 0 && ((hash >> (20 + round)) & 1U) != 0 && (points.size() >> (15 - round)) > 64) {
            --round;
        }
        const std::uint64_t place = spread(static_cast<std::uint64_t>(x.x())) |
                                    (spread(static_cast<std::uint64_t>(x.y())) << 1) |
                                    (spread(static_cast<std::uint64_t>(x.z())) << 2);
        keys.emplace_back((round << 60) | (place >> 4), static_cast<int>(i));
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    for (const auto& key : keys) {
        order.push_back(key.second);
    }
    return order;
}

/// A tetrahedron around the box with no plane in common with it.
void add_surrounding(Tetrahedralisation& mesh, const Box& box) {
    /// Distance of its corners, by the diagonal of the box.
    constexpr double kDistance = 12.0;
    const double r = kDistance * (box.high - box.low).norm();
    const Vec3 center = box.center();
    const Vec3 directions[4] = {
        {0.937, 0.171, -0.683}, {-0.871, 0.353, -0.629}, {0.091, -0.967, -0.571}, {-0.153, 0.137, 1.291}};
    std::array<int, 4> v{};
    for (int k = 0; k < 4; ++k) {
        v[k] = mesh.add_point(center + r * directions[k]);
    }
    if (mesh.orient(v[0], v[1], v[2], v[3]) < 0) {
        std::swap(v[0], v[1]);
    }
    std::vector<int> created;
    mesh.replace({}, {v}, created);
}

}  // namespace

Tetrahedralisation delaunay_tetrahedralisation(const std::vector<Vec3>& points, const Progress& progress) {
    Tetrahedralisation mesh;
    Box box;
    for (const Vec3& p : points) {
        mesh.add_point(p);
        box.add(p);
    }
    add_surrounding(mesh, box);
    Locator locator(mesh);
    CavityInsertion insertion(mesh);
    CancelPace pace(progress);
    int cell = 0;
    for (const int i : insertion_order(points, box)) {
        pace.step();
        cell = locator.find(points[i], cell);
        if (cell < 0 || !insertion.open(points[i], cell)) {
            throw MeshingFailed(phrases::kVerticesCoincide);
        }
        insertion.close(i);
        cell = insertion.created().front();
    }
    return mesh;
}

}  // namespace mq::tetrahedralise

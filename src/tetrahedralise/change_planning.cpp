// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/change_planning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tuning.h"
#include "tetrahedralise/tuning.h"

namespace mq::tetrahedralise {

void ChangePlanner::flip(int cell, Change& change) {
    change.read = {cell};
    for (const int other : mesh_.cells[cell].n) {
        if (other >= 0) {
            change.read.push_back(other);
        }
    }
    change.helps = remove_one_edge(cell, change) || flip_one_face(cell);
    if (change.helps) {
        change.cells = flipper_.removed();
        change.added = flipper_.added();
    }
}

bool ChangePlanner::remove_one_edge(int cell, Change& change) {
    const std::array<int, 4>& v = mesh_.cells[cell].v;
    FlipRule rule;
    rule.measure = &measure_;
    rule.most_around = TetrahedralisationTuning::kMostAround;
    for (int i = 0; i < 4; ++i) {
        for (int k = i + 1; k < 4; ++k) {
            if (!mesh_.ring(cell, v[i], v[k], flipper_.ring())) {
                continue;
            }
            const std::vector<int>& ring = flipper_.ring().cells;
            change.read.insert(change.read.end(), ring.begin(), ring.end());
            rule.floor = std::numeric_limits<double>::max();
            for (const int c : ring) {
                rule.floor = std::min(rule.floor, quality(c));
            }
            rule.floor += kLeastGain * std::abs(rule.floor);
            if (flipper_.plan_ring(v[i], v[k], rule)) {
                return true;
            }
        }
    }
    return false;
}

bool ChangePlanner::flip_one_face(int cell) {
    FlipRule rule;
    rule.measure = &measure_;
    for (int face = 0; face < 4; ++face) {
        const int other = mesh_.cells[cell].n[face];
        if (other < 0) {
            continue;
        }
        rule.floor = std::min(quality(cell), quality(other)) * (1.0 + kLeastGain);
        if (flipper_.plan_face(cell, face, rule)) {
            return true;
        }
    }
    return false;
}

void ChangePlanner::move(int v, Change& change) {
    mesh_.star(v, change.cells, seen_);
    change.read = change.cells;
    placing_.faces.clear();
    double worst = std::numeric_limits<double>::max();
    for (const int c : change.cells) {
        const Cell& cell = mesh_.cells[c];
        const int(&f)[3] = kFaceOf[mesh_.index_of(c, v)];
        placing_.faces.push_back({cell.v[f[0]], cell.v[f[1]], cell.v[f[2]]});
        worst = std::min(worst, quality(c));
    }
    change.place = mesh_.point(v);
    change.helps = worst < TetrahedralisationTuning::kGoodSine && placing_.improve(change.place, worst);
}

void ChangePlanner::insert(int cell, Change& change) {
    change.helps = insert_near(cell, change);
}

bool ChangePlanner::insert_near(int cell, Change& change) {
    const std::array<int, 4>& v = mesh_.cells[cell].v;
    const Vec3 middle = 0.25 * (mesh_.point(v[0]) + mesh_.point(v[1]) + mesh_.point(v[2]) + mesh_.point(v[3]));
    const bool open = insertion_.open(middle, cell);
    change.read = insertion_.seen();
    if (open && insert_into(insertion_.cavity(), middle, change)) {
        return true;
    }
    for (int i = 0; i < 4; ++i) {
        for (int k = i + 1; k < 4; ++k) {
            if (!mesh_.ring(cell, v[i], v[k], ring_)) {
                continue;
            }
            change.read.insert(change.read.end(), ring_.cells.begin(), ring_.cells.end());
            if (insert_into(ring_.cells, 0.5 * (mesh_.point(v[i]) + mesh_.point(v[k])), change)) {
                return true;
            }
        }
    }
    for (int face = 0; face < 4; ++face) {
        if (mesh_.cells[cell].n[face] >= 0) {
            const int(&f)[3] = kFaceOf[face];
            const Vec3 center = (mesh_.point(v[f[0]]) + mesh_.point(v[f[1]]) + mesh_.point(v[f[2]])) / 3.0;
            if (insert_into({cell, mesh_.cells[cell].n[face]}, center, change)) {
                return true;
            }
        }
    }
    return false;
}

bool ChangePlanner::insert_into(const std::vector<int>& cavity, const Vec3& start, Change& change) {
    placing_.faces.clear();
    double before = std::numeric_limits<double>::max();
    for (const int c : cavity) {
        before = std::min(before, quality(c));
        const Cell& cell = mesh_.cells[c];
        for (int face = 0; face < 4; ++face) {
            if (std::find(cavity.begin(), cavity.end(), cell.n[face]) == cavity.end()) {
                const int(&f)[3] = kFaceOf[face];
                placing_.faces.push_back({cell.v[f[0]], cell.v[f[1]], cell.v[f[2]]});
            }
        }
    }
    change.place = start;
    double worst = placing_.worst_at(change.place, -std::numeric_limits<double>::max());
    placing_.improve(change.place, worst);
    if (!(worst > std::max(CellMeasure::folded(), TetrahedralisationTuning::kInsertionGain * before)) ||
        !sees_all(change.place)) {
        return false;
    }
    change.cells = cavity;
    change.added.clear();
    for (const auto& face : placing_.faces) {
        change.added.push_back({face[0], face[1], face[2], -1});
    }
    return true;
}

bool ChangePlanner::sees_all(const Vec3& place) const {
    return std::all_of(placing_.faces.begin(), placing_.faces.end(), [&](const auto& face) {
        return orient3d(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]), place) > 0;
    });
}

}  // namespace mq::tetrahedralise

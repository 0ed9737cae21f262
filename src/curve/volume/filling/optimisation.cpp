// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/optimisation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/volume/filling/tuning.h"

namespace mq::curve {

Optimisation::Optimisation(Tetrahedralisation& mesh, const EndTangents& tangents, int first_inner)
    : mesh_(mesh),
      measure_(mesh, tangents),
      flipper_(mesh),
      placing_(mesh, measure_),
      insertion_(mesh),
      first_inner_(first_inner) {
    tried_.resize(mesh.cells.size(), 0);
    settled_.resize(mesh.points.size(), 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        quality_.push_back(mesh.alive(static_cast<int>(c)) ? measure_.at(mesh.cells[c].v) : 1.0);
    }
}

void Optimisation::run(const Progress& progress) {
    for (int sweep = 0; sweep < FillingTuning::kSweeps; ++sweep) {
        const bool flipped = flip_cells(progress);
        const bool moved = move_vertices(progress);
        const bool inserted = sweep >= FillingTuning::kFirstInsertion && insert_vertices(progress);
        if (sweep >= FillingTuning::kFirstInsertion && !flipped && !moved && !inserted) {
            break;
        }
    }
}

/// What has changed, and what is next to it, is tried again.
void Optimisation::note(const std::vector<int>& changed) {
    quality_.resize(mesh_.cells.size(), 1.0);
    tried_.resize(mesh_.cells.size(), 0);
    settled_.resize(mesh_.points.size(), 0);
    for (const int c : changed) {
        quality_[c] = measure_.at(mesh_.cells[c].v);
        tried_[c] = 0;
        for (const int other : mesh_.cells[c].n) {
            if (other >= 0) {
                tried_[other] = 0;
            }
        }
        for (const int v : mesh_.cells[c].v) {
            settled_[v] = 0;
        }
    }
}

bool Optimisation::flip_cells(const Progress& progress) {
    bool any = false;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        const int cell = static_cast<int>(c);
        if (mesh_.alive(cell) && quality(cell) < FillingTuning::kGoodSine && !tried_[cell]) {
            progress.check();
            if (improve_by_flip(cell)) {
                any = true;
            } else {
                tried_[cell] = 1;
            }
        }
    }
    return any;
}

bool Optimisation::improve_by_flip(int cell) {
    return remove_one_edge(cell) || flip_one_face(cell);
}

bool Optimisation::remove_one_edge(int cell) {
    const std::array<int, 4> v = mesh_.cells[cell].v;
    FlipRule rule;
    rule.measure = &measure_;
    rule.most_around = FillingTuning::kMostAround;
    for (int i = 0; i < 4; ++i) {
        for (int k = i + 1; k < 4; ++k) {
            if (!mesh_.ring(cell, v[i], v[k], flipper_.ring())) {
                continue;
            }
            rule.floor = std::numeric_limits<double>::max();
            for (const int c : flipper_.ring().cells) {
                rule.floor = std::min(rule.floor, quality(c));
            }
            rule.floor += FillingTuning::kLeastGain * std::abs(rule.floor);
            if (flipper_.remove_ring(v[i], v[k], rule)) {
                note(flipper_.created());
                return true;
            }
        }
    }
    return false;
}

bool Optimisation::flip_one_face(int cell) {
    FlipRule rule;
    rule.measure = &measure_;
    for (int face = 0; face < 4; ++face) {
        const int other = mesh_.cells[cell].n[face];
        if (other < 0) {
            continue;
        }
        rule.floor = std::min(quality(cell), quality(other)) * (1.0 + FillingTuning::kLeastGain);
        if (flipper_.flip_face(cell, face, rule)) {
            note(flipper_.created());
            return true;
        }
    }
    return false;
}

bool Optimisation::move_vertices(const Progress& progress) {
    bool any = false;
    for (std::size_t v = first_inner_; v < mesh_.points.size(); ++v) {
        if (settled_[v]) {
            continue;
        }
        progress.check();
        mesh_.star(static_cast<int>(v), star_);
        const bool poor =
            std::any_of(star_.begin(), star_.end(), [&](int c) { return quality(c) < FillingTuning::kGoodSine; });
        if (poor && move_vertex(static_cast<int>(v))) {
            any = true;
        } else {
            settled_[v] = 1;
        }
    }
    return any;
}

bool Optimisation::move_vertex(int v) {
    placing_.faces.clear();
    double worst = std::numeric_limits<double>::max();
    for (const int c : star_) {
        const Cell& cell = mesh_.cells[c];
        const int(&f)[3] = kFaceOf[mesh_.index_of(c, v)];
        placing_.faces.push_back({cell.v[f[0]], cell.v[f[1]], cell.v[f[2]]});
        worst = std::min(worst, quality(c));
    }
    Vec3 place = mesh_.point(v);
    if (!placing_.improve(place, worst)) {
        return false;
    }
    mesh_.move_point(v, place);
    note(star_);
    return true;
}

bool Optimisation::insert_vertices(const Progress& progress) {
    std::vector<std::pair<double, int>> poor;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        const int cell = static_cast<int>(c);
        if (mesh_.alive(cell) && quality(cell) < FillingTuning::kPoorSine) {
            poor.emplace_back(quality(cell), cell);
        }
    }
    std::sort(poor.begin(), poor.end());
    const double share = FillingTuning::kInsertedShare * static_cast<double>(mesh_.cells.size());
    const auto most = static_cast<std::size_t>(share + FillingTuning::kInsertedAlways);
    poor.resize(std::min(poor.size(), most));
    bool any = false;
    for (const auto& [before, cell] : poor) {
        progress.check();
        // Other insertions may have changed the cell.
        any = (mesh_.alive(cell) && quality(cell) == before && insert_near(cell)) || any;
    }
    return any;
}

/// Tries the cavity of the middle of a poor cell, then the cells around its edges and at its faces, until a new vertex
/// in one of them makes the worst cell better.
bool Optimisation::insert_near(int cell) {
    const std::array<int, 4> v = mesh_.cells[cell].v;
    const Vec3 middle = 0.25 * (mesh_.point(v[0]) + mesh_.point(v[1]) + mesh_.point(v[2]) + mesh_.point(v[3]));
    if (insertion_.open(middle, cell) && insert_into(insertion_.cavity(), middle)) {
        return true;
    }
    for (int i = 0; i < 4; ++i) {
        for (int k = i + 1; k < 4; ++k) {
            if (mesh_.ring(cell, v[i], v[k], ring_) &&
                insert_into(ring_.cells, 0.5 * (mesh_.point(v[i]) + mesh_.point(v[k])))) {
                return true;
            }
        }
    }
    for (int face = 0; face < 4; ++face) {
        if (mesh_.cells[cell].n[face] >= 0) {
            const int(&f)[3] = kFaceOf[face];
            const Vec3 center = (mesh_.point(v[f[0]]) + mesh_.point(v[f[1]]) + mesh_.point(v[f[2]])) / 3.0;
            if (insert_into({cell, mesh_.cells[cell].n[face]}, center)) {
                return true;
            }
        }
    }
    return false;
}

bool Optimisation::insert_into(const std::vector<int>& cavity, const Vec3& start) {
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
    Vec3 place = start;
    double worst = placing_.worst_at(place, -std::numeric_limits<double>::max());
    placing_.improve(place, worst);
    if (!(worst > std::max(CellMeasure::folded(), FillingTuning::kInsertionGain * before)) || !sees_all(place)) {
        return false;
    }
    const int vertex = mesh_.add_point(place);
    std::vector<std::array<int, 4>> added;
    for (const auto& face : placing_.faces) {
        added.push_back({face[0], face[1], face[2], vertex});
    }
    std::vector<int> created;
    mesh_.replace(cavity, added, created);
    note(created);
    return true;
}

bool Optimisation::sees_all(const Vec3& place) const {
    return std::all_of(placing_.faces.begin(), placing_.faces.end(), [&](const auto& face) {
        return orient3d(mesh_.point(face[0]), mesh_.point(face[1]), mesh_.point(face[2]), place) > 0;
    });
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/optimisation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/volume/filling/tuning.h"

namespace mq::curve {

Optimisation::Optimisation(Tetrahedralisation& mesh, int first_inner)
    : mesh_(mesh), flipper_(mesh), first_inner_(first_inner) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        quality_.push_back(mesh.alive(static_cast<int>(c)) ? quality_of(mesh, static_cast<int>(c), sine_quality) : 1.0);
    }
}

void Optimisation::run(const Progress& progress) {
    for (int sweep = 0; sweep < FillingTuning::kSweeps; ++sweep) {
        const bool flipped = flip_cells(progress);
        const bool moved = move_vertices(progress);
        if (!flipped && !moved) {
            break;
        }
    }
}

void Optimisation::note_created() {
    quality_.resize(mesh_.cells.size(), 1.0);
    for (const int c : flipper_.created()) {
        quality_[c] = quality_of(mesh_, c, sine_quality);
    }
}

bool Optimisation::flip_cells(const Progress& progress) {
    bool any = false;
    CancelPace pace(progress);
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        const int cell = static_cast<int>(c);
        if (mesh_.alive(cell) && quality(cell) < FillingTuning::kGoodSine) {
            pace.step();
            any = improve_by_flip(cell) || any;
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
    rule.quality = sine_quality;
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
                note_created();
                return true;
            }
        }
    }
    return false;
}

bool Optimisation::flip_one_face(int cell) {
    FlipRule rule;
    rule.quality = sine_quality;
    for (int face = 0; face < 4; ++face) {
        const int other = mesh_.cells[cell].n[face];
        if (other < 0) {
            continue;
        }
        rule.floor = std::min(quality(cell), quality(other)) * (1.0 + FillingTuning::kLeastGain);
        if (flipper_.flip_face(cell, face, rule)) {
            note_created();
            return true;
        }
    }
    return false;
}

bool Optimisation::move_vertices(const Progress& progress) {
    bool any = false;
    CancelPace pace(progress);
    for (std::size_t v = first_inner_; v < mesh_.points.size(); ++v) {
        pace.step();
        mesh_.star(static_cast<int>(v), star_);
        const bool poor = std::any_of(star_.begin(), star_.end(),
                                      [&](int c) { return quality(c) < FillingTuning::kGoodSine; });
        any = (poor && move_vertex(static_cast<int>(v))) || any;
    }
    return any;
}

/// The worst quality around a vertex at another place; no more is computed once it is below `enough`.
double Optimisation::worst_at(int v, const Vec3& place, double enough) const {
    double worst = std::numeric_limits<double>::max();
    for (const int c : star_) {
        const Cell& cell = mesh_.cells[c];
        const int(&f)[3] = kFaceOf[mesh_.index_of(c, v)];
        // The face seen from the vertex, with the vertex last.
        worst = std::min(worst, sine_quality(mesh_.point(cell.v[f[0]]), mesh_.point(cell.v[f[1]]),
                                             mesh_.point(cell.v[f[2]]), place));
        if (worst <= enough) {
            break;
        }
    }
    return worst;
}

bool Optimisation::try_place(int v, const Vec3& place, double& worst) {
    const double value = worst_at(v, place, worst * (1.0 + FillingTuning::kLeastGain));
    if (!(value > worst * (1.0 + FillingTuning::kLeastGain))) {
        return false;
    }
    for (const int c : star_) {
        const Cell& cell = mesh_.cells[c];
        const int(&f)[3] = kFaceOf[mesh_.index_of(c, v)];
        if (orient3d(mesh_.point(cell.v[f[0]]), mesh_.point(cell.v[f[1]]), mesh_.point(cell.v[f[2]]), place) <= 0) {
            return false;
        }
    }
    worst = value;
    mesh_.move_point(v, place);
    return true;
}

/// The direction in which the worst cells around a vertex get better.
Vec3 Optimisation::uphill(int v) const {
    double worst = std::numeric_limits<double>::max();
    for (const int c : star_) {
        worst = std::min(worst, quality_of(mesh_, c, sine_quality));
    }
    Vec3 sum = Vec3::Zero();
    for (const int c : star_) {
        const double here = quality_of(mesh_, c, sine_quality);
        if (here > 1.1 * worst) {
            continue;
        }
        const Cell& cell = mesh_.cells[c];
        const int(&f)[3] = kFaceOf[mesh_.index_of(c, v)];
        const Vec3& p = mesh_.point(cell.v[f[0]]);
        const Vec3& q = mesh_.point(cell.v[f[1]]);
        const Vec3& r = mesh_.point(cell.v[f[2]]);
        const double delta = 1e-5 * (mesh_.point(v) - p).norm();
        Vec3 gradient;
        for (int i = 0; i < 3; ++i) {
            Vec3 moved = mesh_.point(v);
            moved[i] += delta;
            gradient[i] = sine_quality(p, q, r, moved) - here;
        }
        if (gradient.norm() > 0.0) {
            sum += gradient.normalized();
        }
    }
    return sum;
}

bool Optimisation::move_vertex(int v) {
    double worst = worst_at(v, mesh_.point(v), -1.0);
    double length = 0.0;
    Vec3 middle = Vec3::Zero();
    for (const int c : star_) {
        for (const int w : mesh_.cells[c].v) {
            length += (mesh_.point(w) - mesh_.point(v)).norm() / 3.0;
            middle += mesh_.point(w) - mesh_.point(v);
        }
    }
    length /= static_cast<double>(star_.size());
    middle /= 3.0 * static_cast<double>(star_.size());
    bool any = try_place(v, mesh_.point(v) + middle, worst) || try_place(v, mesh_.point(v) + 0.5 * middle, worst);
    for (int step = 0; step < FillingTuning::kVertexSteps; ++step) {
        const Vec3 direction = uphill(v);
        const double norm = direction.norm();
        bool better = false;
        double by = FillingTuning::kFirstStep * length;
        for (int i = 0; i < FillingTuning::kStepHalvings && norm > 1e-9 && !better; ++i, by *= 0.4) {
            better = try_place(v, mesh_.point(v) + by / norm * direction, worst);
        }
        if (!better) {
            break;
        }
        any = true;
    }
    if (any) {
        for (const int c : star_) {
            quality_[c] = quality_of(mesh_, c, sine_quality);
        }
    }
    return any;
}

}  // namespace mq::curve

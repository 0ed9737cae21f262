// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/front/front_boundary.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/disjoint_sets.h"
#include "triangulate/front/tuning.h"

namespace mq::triangulate {

FrontBorder::FrontBorder(const FaceBoundary& border, bool reversed) : border_(border) {
    merge(reversed);
    const std::size_t n = border.sites.size();
    before_.resize(n);
    after_.resize(n);
    scales_.assign(n, 0.0);
    for (const Edge& e : edges_) {
        before_[e.to].push_back(e.from);
        after_[e.from].push_back(e.to);
        const double length = (border.sites[e.to].point - border.sites[e.from].point).norm();
        scales_[e.from] += 0.5 * length;
        scales_[e.to] += 0.5 * length;
    }
    for (std::size_t s = 0; s < n; ++s) {
        scales_[s] /= std::max<double>(1.0, static_cast<double>(after_[s].size()));
        if (before_[s].size() != after_[s].size()) {
            failure_ = "its border is not closed in (u, v)";
        }
    }
    check_angles();
}

void FrontBorder::merge(bool reversed) {
    DisjointSets<int> sets(border_.sites.size());
    for (const FaceBoundary::Piece& p : border_.pieces) {
        if (p.collapsed() && border_.sites[p.from].vertex == border_.sites[p.to].vertex) {
            sets.unite(p.from, p.to);
        }
    }
    for (int s = 0; s < static_cast<int>(border_.sites.size()); ++s) {
        root_.push_back(sets.find(s));
    }
    for (int k = 0; k < static_cast<int>(border_.pieces.size()); ++k) {
        const FaceBoundary::Piece& p = border_.pieces[k];
        if (p.internal) {
            failure_ = "it has edges inside";
        } else if (!p.collapsed()) {
            edges_.push_back({root_[reversed ? p.to : p.from], root_[reversed ? p.from : p.to], k});
            if (border_.sites[p.from].vertex == border_.sites[p.to].vertex) {
                failure_ = "a closed edge of its border is one piece";
            }
        }
    }
}

// Refuses cusps: in space, an angle of zero between two edges cannot be told from the full turn around the end of a
// slit.
void FrontBorder::check_angles() {
    for (std::size_t s = 0; s < root_.size(); ++s) {
        if (before_[s].size() != 1 || after_[s].size() != 1 ||
            border_.sites[before_[s][0]].vertex == border_.sites[after_[s][0]].vertex) {
            continue;
        }
        const Vec3 in = border_.sites[before_[s][0]].point - border_.sites[s].point;
        const Vec3 out = border_.sites[after_[s][0]].point - border_.sites[s].point;
        if (angle_between(in, out) < FrontTuning::kCusp) {
            failure_ = "two edges of its border meet at an angle of zero";
        }
    }
}

void FrontBorder::occupy_outside(int site, AngularSectors& fan) const {
    const Vec3& here = border_.sites[site].point;
    for (const int b : before_[site]) {
        const double in = fan.angle_of(border_.sites[b].point - here);
        double out = in;
        double least = 1e300;
        for (const int a : after_[site]) {
            const double angle = fan.angle_of(border_.sites[a].point - here);
            if (AngularSectors::turn(in, angle) < least) {
                least = AngularSectors::turn(in, angle);
                out = angle;
            }
        }
        fan.occupy(in, out);
    }
}

void FrontBorder::part_merged(FaceMesh& face) const {
    std::vector<std::vector<int>> images(root_.size());
    for (std::size_t s = 0; s < root_.size(); ++s) {
        images[root_[s]].push_back(static_cast<int>(s));
    }
    for (auto& t : face.triangles) {
        const auto corners = t;
        for (int i = 0; i < 3; ++i) {
            if (corners[i] >= static_cast<int>(images.size()) || images[corners[i]].size() < 2) {
                continue;
            }
            const Vec2 others =
                0.5 * border_.scaled(face.sites[corners[(i + 1) % 3]].uv + face.sites[corners[(i + 2) % 3]].uv);
            const auto distance = [&](int s) { return (border_.scaled(face.sites[s].uv) - others).squaredNorm(); };
            const auto& of = images[corners[i]];
            t[i] = *std::min_element(of.begin(), of.end(), [&](int a, int b) { return distance(a) < distance(b); });
        }
    }
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "base/tuning.h"
#include "curve/volume/editor.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

namespace {

double worst(const TetrahedralMesh& volume, const std::vector<int>& tetrahedra) {
    double least = 1.0;
    for (const int t : tetrahedra) {
        least = std::min(least, volume.tetrahedra[static_cast<std::size_t>(t)].quality);
    }
    return least;
}

/// Moves the middle of edge (a, b) by `by`, with a quadratic bubble; keeps it where the elements around become better.
bool bulge(VolumeEditor& editor, int a, int b, const Vec3& by) {
    TetrahedralMesh& volume = editor.volume;
    const std::vector<int> around = volume.of_edge(a, b);
    const bool had = volume.shapes().has_edge(a, b);
    const std::vector<Vec3> before = volume.shapes().edge_inner(a, b);
    const double quality = worst(volume, around);
    const double q = volume.shapes().order();
    std::vector<Vec3> moved = before;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const double k = static_cast<double>(i) + 1.0;
        moved[i] += by * (4.0 * k * (q - k) / (q * (q - 1.0)));
    }
    volume.shapes().set_edge(a, b, moved);
    volume.measure(around);
    if (worst(volume, around) > quality + kLeastGain) {
        return true;
    }
    if (had) {
        volume.shapes().set_edge(a, b, before);
    } else {
        volume.shapes().forget_edge(a, b);
    }
    volume.measure(around);
    return false;
}

}  // namespace

bool curve_region_edge(VolumeEditor& editor, int tetrahedron) {
    const std::array<int, 4> v = editor.tetrahedron(tetrahedron).corners;
    const TetrahedralMesh& volume = editor.volume;
    const double order = volume.shapes().order();
    const double wanted = VolumeTuning::kRestoredJacobian * volume.straight_jacobian(v);
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vec3, 3> t;
        for (std::size_t i = 0; i < 3; ++i) {
            const int other = v[(k + 1 + i) % 4];
            t[i] = order * (volume.shapes().edge_inner(v[k], other).front() - volume.point(v[k]));
        }
        // Corners (k, k + 1, k + 2, k + 3) are an odd permutation of (0, 1, 2, 3) for odd k.
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        const double box = sign * t[0].cross(t[1]).dot(t[2]);
        if (box >= wanted) {
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const int other = v[(k + 1 + i) % 4];
            const Vec3 across = sign * t[(i + 1) % 3].cross(t[(i + 2) % 3]);
            if (volume.fixed_edge(v[k], other) || !(across.norm() > 0.0)) {
                continue;
            }
            const double m = (wanted - box) / (4.0 * across.norm());  // (12)
            if (bulge(editor, v[k], other, m * across.normalized())) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace mq::curve

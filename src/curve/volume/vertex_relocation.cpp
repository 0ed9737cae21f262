// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>

#include "curve/volume/editor.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

void relocate_vertex(VolumeEditor& editor, int p, const std::vector<std::array<int, 4>>& star, double size) {
    Vec3& point = editor.volume.shapes().vertices[static_cast<std::size_t>(p)].point;
    // The value at the present place; if it does not exceed `best`, an upper bound of it that does not either.
    const auto value = [&](double best) {
        double flat = 1.0;
        for (const auto& corners : star) {
            flat = std::min(flat, editor.volume.straight_shape(corners));
        }
        // Flat or inverted straight elements are refused by the editor, however good their curved ones are.
        constexpr double kRefused = -1e6;
        if (!(flat > VolumeTuning::kLeastShape)) {
            return kRefused + flat;
        }
        double quality = 0.3;
        for (std::size_t i = 0; i < star.size() && quality + 0.3 * flat > best; ++i) {
            quality = std::min(quality, editor.score(star[i]).quality);
        }
        return quality + 0.3 * flat;
    };
    double best = value(-std::numeric_limits<double>::infinity());
    double step = 0.25 * size;
    for (int halving = 0; halving < VolumeTuning::kHalvings; ++halving, step *= 0.5) {
        bool moved = true;
        for (int round = 0; round < 4 && moved; ++round) {
            moved = false;
            for (int way = 0; way < 6; ++way) {
                const Vec3 before = point;
                point[way / 2] += way % 2 == 0 ? step : -step;
                const double now = value(best);
                if (now > best) {
                    best = now;
                    moved = true;
                } else {
                    point = before;
                }
            }
        }
    }
}

}  // namespace mq::curve

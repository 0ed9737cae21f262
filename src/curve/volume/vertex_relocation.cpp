// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/volume/editor.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

void relocate_vertex(VolumeEditor& editor, int p, const std::vector<std::array<int, 4>>& star, double size) {
    Vec3& point = editor.volume.shapes().vertices[static_cast<std::size_t>(p)].point;
    const auto value = [&] {
        const VolumeEditor::Score s = editor.worst(star);
        double flat = 1.0;
        for (const auto& corners : star) {
            flat = std::min(flat, editor.volume.straight_shape(corners));
        }
        // Flat or inverted straight elements are refused by the editor, however good their curved ones are.
        constexpr double kRefused = -1e6;
        return flat > VolumeTuning::kLeastShape ? std::min(s.quality, 0.3) + 0.3 * flat : kRefused + flat;
    };
    double best = value();
    double step = 0.25 * size;
    for (int halving = 0; halving < VolumeTuning::kVertexHalvings; ++halving, step *= 0.5) {
        bool moved = true;
        for (int round = 0; round < 4 && moved; ++round) {
            moved = false;
            for (int way = 0; way < 6; ++way) {
                const Vec3 before = point;
                point[way / 2] += way % 2 == 0 ? step : -step;
                const double now = value();
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/dilation.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.h"

namespace mq::offset {

void assign_dilation(const boolean::Arrangement& arrangement, const mesh::NearestTree& tree,
                     const DilationOptions& options, boolean::Cells& cells, const Progress& progress) {
    const double deep = options.distance - options.tolerance;
    std::vector<char> within(arrangement.faces.size(), 0);
    for_chunks(static_cast<int>(within.size()), [&](int f) {
        if (f % 64 == 0) {
            progress.check();
        }
        const auto i = static_cast<std::size_t>(f);
        Vec3 middle = Vec3::Zero();
        for (const std::int32_t p : arrangement.faces[i].points) {
            middle += arrangement.points.approx(p) / 3.0;
        }
        within[i] = tree.any_within(middle, deep, 0) >= 0 ? 1 : 0;
    });
    std::vector<char> inside(cells.windings.size(), 0);
    for (std::size_t c = 0; c < inside.size(); ++c) {
        const std::int32_t times = cells.windings[c].empty() ? 0 : cells.windings[c].front().times;
        inside[c] = times + (options.inward ? 1 : 0) > 0 ? 1 : 0;
    }
    for (std::size_t f = 0; f < within.size(); ++f) {
        if (within[f] != 0) {
            inside[static_cast<std::size_t>(cells.front[f])] = 1;
            inside[static_cast<std::size_t>(cells.back[f])] = 1;
        }
    }
    for (std::size_t c = 0; c < inside.size(); ++c) {
        const bool in_solid = (inside[c] != 0) != options.inward;
        cells.windings[c] = in_solid ? boolean::Windings{{0, 1}} : boolean::Windings{};
    }
}

}  // namespace mq::offset

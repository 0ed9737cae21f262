// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "base/vec.h"

namespace mq::mesh {

/// Points where exact ties are the rule: a small grid, points on its edges and faces, and neighbours of those.
class TiedPoints {
  public:
    explicit TiedPoints(std::uint64_t seed) : random_(seed) {}

    Vec3 operator()() {
        Vec3 p(integer(0, 3), integer(0, 3), integer(0, flat_ ? 0 : 3));
        if (integer(0, 3) == 0) {
            p += 0.5 * Vec3(integer(-1, 1), integer(-1, 1), flat_ ? 0 : integer(-1, 1));
        }
        if (integer(0, 19) == 0 && p.x() != 0.0) {
            p.x() = std::nextafter(p.x(), integer(0, 1) == 0 ? -10.0 : 10.0);
        }
        return p;
    }
    void set_flat(bool flat) { flat_ = flat; }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  private:
    std::mt19937_64 random_;
    bool flat_ = false;
};

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace mq::geometry {

/// 128 bits that are equal where the same numbers were added, bit by bit and in the same order.
using Fingerprint = std::array<std::uint64_t, 2>;

void add_to(Fingerprint& fingerprint, std::uint64_t number);
void add_to(Fingerprint& fingerprint, int number);
/// Adds a number; zeros are equal whatever their sign.
void add_to(Fingerprint& fingerprint, double number);
void add_to(Fingerprint& fingerprint, const Vec3& v);
void add_to(Fingerprint& fingerprint, const Fingerprint& other);

}  // namespace mq::geometry

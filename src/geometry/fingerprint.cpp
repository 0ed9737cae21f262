// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/fingerprint.h"

#include <cstring>

namespace mq::geometry {

namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the result depends on all bits of `x`.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
}

}  // namespace

void add_to(Fingerprint& fingerprint, std::uint64_t number) {
    fingerprint[0] = mixed(fingerprint[0] + 0x9E3779B97F4A7C15ULL + number);
    fingerprint[1] = mixed((fingerprint[1] ^ number) * 0xD6E8FEB86659FD93ULL + 1);
}

void add_to(Fingerprint& fingerprint, int number) {
    add_to(fingerprint, static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
}

void add_to(Fingerprint& fingerprint, double number) {
    const double unsigned_zero = number + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &unsigned_zero, sizeof bits);
    add_to(fingerprint, bits);
}

void add_to(Fingerprint& fingerprint, const Vec3& v) {
    for (int i = 0; i < 3; ++i) {
        add_to(fingerprint, v[i]);
    }
}

void add_to(Fingerprint& fingerprint, const Fingerprint& other) {
    add_to(fingerprint, other[0]);
    add_to(fingerprint, other[1]);
}

}  // namespace mq::geometry

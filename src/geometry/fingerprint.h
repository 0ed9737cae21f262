// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/session.h"

namespace mq::geometry {

/// Of a face and of the edges and nodes around it: 128 bits that are the same where the face is the same, wherever it
/// stands among the faces of its part. Made of exact numbers: topology, tolerances, and points, normals and tangents at
/// fixed parameters. What lies between these is not seen: compare further points before anything depends on it.
using Fingerprint = std::array<std::uint64_t, 2>;

/// Adds a number to a fingerprint; the order counts.
void add_to(Fingerprint& fingerprint, std::uint64_t number);
void add_to(Fingerprint& fingerprint, double number);

/// Of all faces. @throws Cancelled
std::vector<Fingerprint> fingerprints_of_faces(Session& session);

/// The uses of a face in the order of its loops: the same for two faces with the same fingerprint.
std::vector<int> uses_in_order(const Face& face);

}  // namespace mq::geometry

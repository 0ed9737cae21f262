// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/face_keys.h"
#include "triangulate/triangulate.h"

namespace mq::triangulate {

/// What the input of a run is known by.
struct Keys {
    geometry::Fingerprint input{};             ///< all of it: geometry, numbering, place and options
    std::vector<geometry::Fingerprint> faces;  ///< each with the local sizes asked for on and around it
};

/// @throws Cancelled.
Keys keys_of(geometry::Session& session, const Options& options);

}  // namespace mq::triangulate

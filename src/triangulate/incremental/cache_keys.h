// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/incremental/face_fingerprints.h"
#include "triangulate/work_mesh/options.h"

namespace mq::triangulate {

/// Fingerprints that identify the input of a run.
struct CacheKeys {
    geometry::Fingerprint input{};  ///< the complete input: geometry, numbering, placement and options
    /// By face: geometry, and the local sizes on the face and on its edges and nodes, and the size field around it.
    std::vector<geometry::Fingerprint> faces;
};

/// Computes the fingerprints of the session's shape and options. @throws Cancelled.
CacheKeys keys_of(geometry::Session& session, const TriangulateOptions& options);

}  // namespace mq::triangulate

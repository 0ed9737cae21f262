// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/memory.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The faces of a finished mesh, by `keys` (see keys_of_faces), for the next run. `chains` say which edges are
/// collapsed. Faces whose triangles are linked to others' are left out. `chord` mm.
Memory remember(const Workspace& work, const ChordMeasure& measure, const geometry::EdgeChains& chains,
                const std::vector<geometry::Fingerprint>& keys, const Options& options, double chord);

}  // namespace mq::triangulate

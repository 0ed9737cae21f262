// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/memory.h"
#include "triangulate/recall.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The faces of a finished mesh, by `keys`, for later runs: what Run::faces gets. `chains` say which edges are
/// collapsed. Faces whose triangles are linked to others' are left out. `chord` mm; `recall`: null where nothing was.
std::map<geometry::Fingerprint, std::shared_ptr<const RememberedFace>> remember(
    const Workspace& work, const ChordMeasure& measure, const geometry::EdgeChains& chains,
    const std::vector<geometry::Fingerprint>& keys, double chord, const Recall* recall);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "triangulate/incremental/cache_restore.h"
#include "triangulate/incremental/mesh_cache.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Returns the faces of a finished mesh, by `keys`, for later runs (CachedRun::faces). `chains` tell which edges are
/// collapsed. Faces whose triangles are linked to triangles of other faces are omitted. `chord`: chord tolerance in
/// mm; `recall`: null if nothing was restored.
std::map<geometry::Fingerprint, std::shared_ptr<const CachedFace>> store(const Workspace& work,
                                                                         const ChordErrorCache& measure,
                                                                         const EdgeDiscretisation& chains,
                                                                         const std::vector<geometry::Fingerprint>& keys,
                                                                         double chord, const CacheRestore* restore);

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "improve/improve.h"
#include "triangulate/work_mesh/result.h"

namespace mq::workflows {

/// A mesh without CAD with better triangles, measured; a note counts the operations.
/// @throws as improve::improve.
triangulate::Result improve_surface(const mesh::TriangleMesh& mesh, const improve::ImproveOptions& options,
                                    Progress& progress);

}  // namespace mq::workflows

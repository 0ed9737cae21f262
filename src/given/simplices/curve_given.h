// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "curve/curve.h"
#include "given/matching/given_mesh.h"

namespace mq::given {

/// Curves a mesh that another program made to the geometry of the model (Dey, O'Bara, Shephard 1999, whose input are
/// such meshes). Vertices and connectivity stay unless elements would be invalid. Tetrahedra of the given mesh stay,
/// too; `options.volume` is ignored. The report says what was changed: `moved_nodes`, and `given_element` of the mesh.
/// @throws as match(), and tetrahedralise::MeshingFailed if a solid cannot be filled after its surface had to be
/// changed.
curve::CurvedMesh curve_given(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model, GivenMesh given,
                              const curve::CurveOptions& options, Progress* progress = nullptr);

}  // namespace mq::given

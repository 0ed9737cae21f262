// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "base/sizes/size_field.h"
#include "curve/output/curved_mesh.h"
#include "geometry/engine.h"

/// Curvilinear meshes that are proven valid, after Dey, O'Bara, Shephard 1999.
namespace mq::curve {

struct CurveOptions {
    int order = 2;            ///< 1 to 5 for surfaces, 1 to 4 for volumes
    bool volume = false;      ///< fill the solids with tetrahedra
    bool straighten = false;  ///< make elements straight that stay invalid after all repairs
    bool repair = true;       ///< false: surfaces as they are first placed on the CAD, for comparison
    /// Bounds the lengths of edges inside, in the shape's coordinates; null: none.
    std::shared_ptr<const SizeField> size_field;
    int threads = 0;  ///< that work at a time; 0: as many as ThreadLimit says. They change no byte of the result

    /// @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

/// Curves a straight mesh of the model, made by triangulate(), to the model's geometry.
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; Cancelled.
CurvedMesh curve(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                 const mesh::TriangleMesh& straight, const CurveOptions& options = {}, Progress* progress = nullptr);

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

struct DraftOptions {
    Vec3 pull = Vec3::UnitZ();  ///< the direction in which one half of the mould opens, the other one against it
    /// Rays begin at this distance from the surface, mm, so that facets of walls along the pull do not stop them; 0: a
    /// hundred thousandth of the largest side.
    double offset = 0.0;

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// Which half of a mould can leave a triangle.
enum class Release : std::int8_t {
    Undercut = 0,  ///< neither: something is in the way
    Along = 1,     ///< that which opens along the pull
    Against = 2,   ///< the other one
    Both = 3,      ///< a wall along the pull
};

/// The draft of each triangle.
struct MouldDraft {
    /// Degrees between the surface and the pull: 90 where it faces along it, 0 on walls along it, -90 where it faces
    /// against it.
    std::vector<double> angle;
    std::vector<Release> release;
};

/// Measures the draft of a closed, oriented surface, and looks by rays from the middles of its triangles whether they
/// are in the way of the half of the mould that forms them.
/// @param normals  of each triangle, of length 1; empty: those of the triangles themselves
/// @throws InvalidInput for an option out of range; Cancelled
MouldDraft draft(const mesh::TriangleMesh& mesh, const std::vector<Vec3>& normals, const DraftOptions& options,
                 Progress* progress = nullptr);

}  // namespace mq::inspection

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

struct DraftOptions {
    Vec3 pull =
        Vec3::UnitZ();  ///< direction in which one half of the mould opens; the other half opens the opposite way
    /// mm: distance from the surface at which rays start, so that facets of walls parallel to the pull do not stop
    /// them; 0: a hundred thousandth of the largest side.
    double offset = 0.0;

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// The half of a mould that can leave a triangle without obstacle.
enum class Release : std::int8_t {
    Undercut = 0,  ///< neither half: the body is in the way of both
    Along = 1,     ///< the half that opens along the pull
    Against = 2,   ///< the half that opens against the pull
    Both = 3,      ///< both halves: a wall parallel to the pull
};

/// The draft of each triangle.
struct MouldDraft {
    /// Degrees between the surface and the pull: 90 if the normal is the pull, 0 on walls parallel to it, -90 if the
    /// normal is opposite to it.
    std::vector<double> angle;
    std::vector<Release> release;
};

/// Measures the draft of a closed, oriented surface. Rays from the centroids of its triangles find whether the body is
/// in the way of the half of the mould that forms them.
/// @param normals  of each triangle, of length 1; empty: the normals of the triangles' own planes
/// @throws InvalidInput for an option out of range; Cancelled
MouldDraft draft(const mesh::TriangleMesh& mesh, const std::vector<Vec3>& normals, const DraftOptions& options,
                 Progress* progress = nullptr);

}  // namespace mq::inspection

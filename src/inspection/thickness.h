// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::inspection {

struct ThicknessOptions {
    /// Sample points of a triangle are at most about this far apart, mm; 0: a fiftieth of the largest side of the mesh.
    double spacing = 0.0;
    /// Two surfaces are the sides of a wall where they are inclined to each other by at most this angle, degrees. Where
    /// they meet at more, there is a corner, whose thickness is 0 by definition.
    double corner_angle = 45.0;
    /// Whether to measure the gaps outside of the solid, in place of its walls.
    bool outside = false;

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// One measure of all triangles, each at that of its sample points where it is smallest: where walls are, among those
/// that face the other side of a wall.
struct ThicknessValues {
    /// mm. Infinite where nothing is opposite; not a number where the triangle lies inside of another body.
    std::vector<double> value;
    std::vector<Vec3> point;             ///< where that is, in the frame of the mesh
    std::vector<std::int32_t> opposite;  ///< the triangle on the other side; -1: none
    std::vector<char> is_wall;           ///< false: a corner, nothing opposite, or inside of another body
};

/// The thickness of solids, seen from each triangle of their surfaces.
struct Thickness {
    /// From a point of the surface along the inward normal to where the ray leaves the solid.
    ThicknessValues rays;
    /// The diameter of the largest ball in the solid that touches the surface in a point.
    ThicknessValues balls;
};

/// Measures the thickness of closed, oriented surfaces. Points are in the inside of triangles, their normals those of
/// the smooth surface (see SurfaceNormals). A body is where its surface winds around at least once.
///
/// Three to eleven microseconds of a processor a sample point; the same bytes for any number of threads.
/// @param body  the body that each triangle belongs to, numbered from 0 on; each is measured by itself. Empty: there is
///     one.
/// @throws InvalidInput for an option out of range
/// @throws Cancelled
Thickness thickness(const mesh::TriangleMesh& mesh, const std::vector<std::int32_t>& body,
                    const ThicknessOptions& options, Progress* progress = nullptr);

}  // namespace mq::inspection

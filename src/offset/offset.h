// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "mesh/triangle_mesh.h"

namespace mq::offset {

struct OffsetOptions {
    double distance = 0.0;   ///< mm; of a solid: outward where positive, inward where negative
    double tolerance = 0.0;  ///< mm: the largest distance between the result and the exact one, in both directions
    int threads = 0;         ///< as BooleanOptions::threads

    /// @throws InvalidInput naming the option
    void validate() const;
};

/// A closed surface at a distance from another one, and its counts.
struct OffsetResult {
    mesh::TriangleMesh mesh;
    /// The input's triangle from which each triangle is offset; at rounded edges and vertices that of the lowest CAD
    /// face there.
    std::vector<std::int32_t> triangle_source;
    /// mm, proven: no point of the result is farther than this from the exact distance, no point nearer to the surface
    /// than the distance less this is left out, and none farther than the distance and this is taken in.
    double error_bound = 0.0;
    std::size_t cells = 0;  ///< tetrahedra of the lattice
    StageTimes seconds;
};

/// The boundary of all points within a distance of a solid, or of those of its points that are farther than that from
/// its surface: sharp edges are rounded on the outer side and kept on the inner one, as the exact offset has them.
///
/// The contour of the distance (contour) in a lattice that is divided until both sides of it are proven (refine), with
/// edges collapsed as far as the tolerance allows (simplify).
/// @param solid  closed, oriented outward, without self-intersections: what boolean() gives. Where it has CAD faces,
/// the
///     borders between them are kept.
/// @throws InvalidInput for an option out of range, and where the cells would not fit into memory
/// @throws TopologyError where the result cannot be held in single precision
/// @throws Cancelled
OffsetResult offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress);

/// The boundary of all points within a distance of some triangles of a surface, on both of their sides.
/// @param left_out  for each triangle of the surface, which may be open where they are left out
/// @throws as offset; InvalidInput where all triangles are left out, and for a distance below 0
OffsetResult thicken(const mesh::TriangleMesh& surface, const std::vector<char>& left_out, const OffsetOptions& options,
                     Progress& progress);

}  // namespace mq::offset

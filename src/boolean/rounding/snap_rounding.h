// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/extraction/extraction.h"

namespace mq::boolean {

struct RoundingOptions {
    double size = 0.0;       ///< longest side of the operands' box, mm
    double tolerance = 0.0;  ///< mm; vertices are moved apart by at most a twentieth of it in a round
    bool in_single = true;   ///< coordinates become single-precision numbers; else they stay double-precision ones
};

struct RoundingCount {
    std::size_t rounds = 0;     ///< arrangements of the rounded surface
    std::size_t separated = 0;  ///< copies of points that were moved off others in the same place
    double unit = 0.0;          ///< spacing of single-precision numbers at the farthest vertex, mm
    double error_bound = 0.0;   ///< bound for the distance of the surfaces before and after, both ways, mm
    /// Triangles of the soup (ResultMesh::from) still in contact when the rounds allowed are used up; of a
    /// tangle (EmbeddingFaults::is_tangle) only those that were found. Empty: the surface is embedded.
    std::vector<std::int32_t> faulty;
};

/// Rounds the vertices that were made, such that the surface stays embedded: closed, manifold, and without triangles
/// that touch or cross. Triangles that rounding brought into contact are moved apart (relocate_vertices). If that does
/// not suffice, these steps are repeated until no triangles are in contact (Valque and Lazard 2025): crossing triangles
/// are divided exactly (arrange), the boundary of the points around which the surface winds is taken (extract), copies
/// of points in which it touches itself are moved apart, and new vertices are rounded.
///
/// Each triangle carries how far its points were moved at most (`draft.displacement`). A piece that vanishes, since it
/// turned over or closed a gap, had crossed a piece that stays, and is within the sum of their displacements of it: the
/// bound for the distance of the surfaces is the largest displacement, or twice that when the surface was divided
/// again.
/// @throws Cancelled
RoundingCount snap_round(Extraction& extraction, const RoundingOptions& options, const Progress& progress);

}  // namespace mq::boolean

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
    /// Triangles of the soup (ResultMesh::from) that keep contacts, when the rounds allowed are used up, of a tangle
    /// (EmbeddingFaults::is_tangle) those that were found; empty: the surface is embedded.
    std::vector<std::int32_t> faulty;
};

/// Rounds the vertices that were made, such that the surface stays embedded: closed, manifold, and without triangles
/// that touch or cross. What rounding brought into contact is moved apart (relocate_vertices). Where that does not
/// suffice, it is iterated as Valque and Lazard (2025) do: what still crosses is divided exactly (arrange), the
/// boundary of what the surface winds around is taken (extract), copies of points where it touches itself are moved
/// apart, and that is rounded again, until nothing is in contact.
///
/// Each triangle carries how far its points were moved at most (`draft.displacement`). What vanishes, since it turned
/// over or closed a gap, had crossed what stays, and is as near to it as both were moved: the bound for the distance of
/// the surfaces is the largest displacement, or twice that when the surface was divided again.
/// @throws Cancelled
RoundingCount snap_round(Extraction& extraction, const RoundingOptions& options, const Progress& progress);

}  // namespace mq::boolean

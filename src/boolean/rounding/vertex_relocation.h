// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "boolean/extraction/result_mesh.h"

namespace mq::boolean {

struct RelocationOptions {
    double unit = 0.0;                         ///< the least move, mm: the spacing of single-precision numbers
    double reach = 0.0;                        ///< the largest distance of a vertex from its place at the beginning, mm
    std::function<Vec3(const Vec3&)> rounded;  ///< the nearest place of the grid
};

/// The faults that keep a surface from being embedded.
struct EmbeddingFaults {
    std::vector<std::array<std::int32_t, 2>> contacts;  ///< triangles that touch or cross, the lower first, ascending
    std::vector<std::int32_t> flat;                     ///< triangles without area, ascending
    /// Whether a piece of the surface may have turned inside out, or come into or out of another one.
    bool may_have_turned = false;
    /// Whether there are more faults than triangles and than RoundingTuning::kTangle: no repair is known to help, and
    /// the search did not list all faults.
    bool is_tangle = false;
    std::size_t size() const { return contacts.size() + flat.size(); }
};

/// Rounds constructed vertices at faults, merges those in one place (merge_coincident_vertices), and moves others until
/// triangles no longer touch or cross where rounding has laid them on or into each other. Every move leaves fewer
/// faults around the moved vertices than there were, and adds none elsewhere, so that it ends.
///
/// At each fault the constructed vertices are tried one by one, then those of one triangle together, then the operands'
/// own likewise: off the planes of both triangles and in 26 more directions, from one unit on, by factors of four up to
/// the reach. The first distance that helps is taken, and the direction with the fewest faults left.
/// A tangle is left as it is.
/// @return the faults left
EmbeddingFaults relocate_vertices(ResultMesh& draft, const RelocationOptions& options, const Progress& progress);

}  // namespace mq::boolean

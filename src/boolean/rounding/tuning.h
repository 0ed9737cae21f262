// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the rounding to single precision. docs/measurements/tuning.md says what each does at
/// half and at double its value.
struct RoundingTuning {
    /// Rounds of separating contacts at most. Nearly all surfaces take one or two; those that take more seldom end.
    MESHQUALITY_TUNED(std::size_t, kRoundingRounds, 16);
    /// The rounds do not end if there are more contacts than this multiple of those that rounding made at first ...
    MESHQUALITY_TUNED(std::size_t, kMoreContacts, 4);
    /// ... and more than this number.
    MESHQUALITY_TUNED(std::size_t, kManyContacts, 500);
    /// Largest distance between the surfaces before and after, as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kMostRoundingMove, 0.5);
    /// The grid becomes this many times as coarse after a round that left more than half of the contacts.
    MESHQUALITY_TUNED(double, kCoarser, 2.0);
    /// Distance to which copies of a vertex are separated, in units of single precision of the size.
    MESHQUALITY_TUNED(double, kSeparationUnits, 80.0);
    /// Passes of snapping vertices to edges at most.
    MESHQUALITY_TUNED(std::size_t, kSnappingPasses, 24);
    /// Passes after which further ones are made only as long as contacts become fewer.
    MESHQUALITY_TUNED(std::size_t, kFreePasses, 4);
    /// The length of the sum of the normals at a vertex, as a fraction of the sum of the angles, below which the
    /// material is a thin wedge.
    MESHQUALITY_TUNED(double, kThinWedge, 0.2);
    /// Largest displacement of a copy of a vertex, as a fraction of its shortest edge, so that no triangle turns over.
    MESHQUALITY_TUNED(double, kCopyPartOfEdge, 0.1);
};

}  // namespace mq::boolean

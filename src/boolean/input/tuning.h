// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::boolean {

/// The constants that tune the repair of operands. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct InputTuning {
    /// Largest width of a crack, as a fraction of the border edges at a vertex: with one half, the point to which a
    /// vertex is joined is nearer than the vertex's neighbours on the border are to each other.
    MESHQUALITY_TUNED(double, kCrackWidth, 0.5);
    /// Width of a crack at most, as a fraction of the tolerance.
    MESHQUALITY_TUNED(double, kCrackShare, 0.25);
    /// Cosine of about 32 degrees. Edges along a crack make at most this angle with each other; triangles around it
    /// that are nearer to each other, and turn the same side out, lie on one another.
    MESHQUALITY_TUNED(double, kCrackCosine, 0.85);
    /// An open component is closed only if the area to be added is at most this fraction of its own: a box without its
    /// lid (0.2) and most of a sphere are, half a sphere (0.5) and a sheet (1) are not. The mean winding number
    /// (Jacobson 2013) inside a dome as open as this is 0.78.
    MESHQUALITY_TUNED(double, kLargestFilledShare, 1.0 / 3.0);
    /// A component is a sheet, which bounds nothing, if the area that would close it is at least this fraction of its
    /// own area: the mean winding number inside such a dome is 0.6, beside a plane sheet 0.5. Sheets are left out if
    /// together they have at most half of the operand's area (for layered depth images, of the guessed area).
    MESHQUALITY_TUNED(double, kLeastSheetShare, 0.8);
    /// Other components that cannot be closed are left out if together they have at most this fraction of the operand's
    /// area; components attached to the rest along edges of three or more triangles (inner walls, fins) are treated as
    /// sheets.
    MESHQUALITY_TUNED(double, kLargestScrapShare, 0.05);
    /// Most corners of a loop for which every possible triangle is tested against the surface; the time grows with the
    /// third power.
    MESHQUALITY_TUNED(std::size_t, kTestedLoop, 80);
    /// Approximate number of triangles of an open sheet that vote on which side of it is outside.
    MESHQUALITY_TUNED(std::size_t, kVotes, 32);
};

}  // namespace mq::boolean

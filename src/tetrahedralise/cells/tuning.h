// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/tuning.h"

namespace mq::tetrahedralise {

/// The constants that tune how cells are measured.
struct CellTuning {
    /// Fraction of the mean ratio (1: regular) that counts beside the least sine of the dihedral angles (0.94:
    /// regular).
    MESHQUALITY_TUNED(double, kMeanRatioFraction, 0.7);
    /// Longest edge, divided by the size field at its middle, of cells that are not worse for it.
    MESHQUALITY_TUNED(double, kLongestByField, 1.15);
    /// Longest edge of a cell, divided by the least size in it, before it gets a point.
    MESHQUALITY_TUNED(double, kLongestByLeast, 3.0);
    /// Power of the excess by which cells with longer edges are worse.
    MESHQUALITY_TUNED(double, kExcessPower, 6.0);
    /// Sine of a dihedral angle by the tangents of curved edges below which, folds included, an exponential function of
    /// the sine is used instead of the sine.
    MESHQUALITY_TUNED(double, kFoldedSine, 0.1);
};

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::curve {

/// The constants that tune the curving of volumes. docs/measurements/tuning.md says what each does at half and at
/// double its value.
struct VolumeTuning {
    /// I = min J / max J below which a tetrahedron is repaired.
    MESHQUALITY_TUNED(double, kGoodTetrahedron, 0.15);
    /// The least Bernstein coefficient, relative to the straight element, at which the optimisation aims.
    MESHQUALITY_TUNED(double, kTargetJacobian, 0.3);
    /// A corner whose three edges are fixed must keep this fraction of the straight element's J.
    MESHQUALITY_TUNED(double, kFreeCorner, 0.2);
    /// Layers of tetrahedra around bad ones in the first patches, and in those around what they leave.
    MESHQUALITY_TUNED(int, kFirstLayers, 2);
    MESHQUALITY_TUNED(int, kPatchLayers, 1);
    /// Most patches that are made for an element while its neighbours stay the same.
    MESHQUALITY_TUNED(int, kCurvingAttempts, 3);
    /// Sweeps that carry the bulges of the surface's edges inwards.
    MESHQUALITY_TUNED(int, kInwardSweeps, 15);
    /// Fraction of bad tetrahedra up to which single edges are curved before patches.
    MESHQUALITY_TUNED(double, kFewBad, 0.005);
    /// The quality of straight elements flatter than this (mean ratio) is reduced in proportion.
    MESHQUALITY_TUNED(double, kSliverShape, 0.05);
    /// Least shape (mean ratio) of straight elements after an operation, unless those before were flatter.
    MESHQUALITY_TUNED(double, kLeastShape, 0.01);
    /// Times that the step of a vertex, or of the nodes of a face, is halved.
    MESHQUALITY_TUNED(int, kHalvings, 6);
    /// First step of the nodes of a face, as a fraction of the longest edge of the face.
    MESHQUALITY_TUNED(double, kFirstFaceStep, 0.1);
    /// Epsilon of (11), as a fraction of J of the straight element.
    MESHQUALITY_TUNED(double, kRestoredJacobian, 0.4);
    /// Positions of the barrier at most; each needs a minimisation.
    MESHQUALITY_TUNED(int, kBarrierMoves, 10);
    /// A position of the barrier after which more than this fraction of the elements' distances from the target is left
    /// has stalled.
    MESHQUALITY_TUNED(double, kLeastProgress, 0.9);
    /// The barrier of an element at most, relative to the straight element: valid elements may become worse than they
    /// are to help others, but not this bad.
    MESHQUALITY_TUNED(double, kHighestBarrier, 0.1);
    /// Fraction of a patch's elements below the target at which its optimisation ends: those that are still bad get
    /// smaller patches.
    MESHQUALITY_TUNED(double, kPatchShare, 0.02);
    /// Most steps of the minimisation for one position of the barrier.
    MESHQUALITY_TUNED(int, kMinimisationSteps, 30);
    /// Pairs of steps and gradient differences that BFGS keeps; the usual 5 to 10.
    MESHQUALITY_TUNED(int, kBfgsMemory, 8);
};

}  // namespace mq::curve

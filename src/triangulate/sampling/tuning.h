// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::triangulate {

/// The constants that tune sampling. docs/measurements/tuning.md says what each does at half and at double its
/// value.
struct SamplingTuning {
    /// Largest spacing as a fraction of the shape's largest dimension, for flat faces without a bound.
    MESHQUALITY_TUNED(double, kMostSpacing, 0.1);
    /// Smallest spacing as the same fraction, without a chord tolerance.
    MESHQUALITY_TUNED(double, kLeastSpacing, 1e-3);
    /// Largest fraction of the budget that the samples of the edges may take: with too few samples beside them,
    /// triangles from border to border would have to be looked for among all pieces.
    MESHQUALITY_TUNED(double, kMostOnEdges, 0.5);
    /// Least distance between samples of different fronts, in spacings.
    MESHQUALITY_TUNED(double, kStarClosest, 0.7);
    /// Factor on the spacing for tests before the exact one, since the corner in the tangent plane moves when it is
    /// projected.
    MESHQUALITY_TUNED(double, kStarSlack, 0.9);
    /// Largest distance of a corner from the surface, in spacings: farther ones belong to another sheet.
    MESHQUALITY_TUNED(double, kStarLift, 0.5);
    /// Samples in one batch of queries.
    MESHQUALITY_TUNED(std::size_t, kStarBatch, 512);
    /// Ball radius in spacings: at saturation the edges between balls of radius 1 are 1.3 long on average, so that
    /// edges become as long as the spacing.
    MESHQUALITY_TUNED(double, kBallRadius, 0.75);
    /// Factor on the radii in the search for gaps, which treats cells as flat although the surface is slightly
    /// curved.
    MESHQUALITY_TUNED(double, kCovered, 0.95);
    /// Longest side of a cell, in spacings.
    MESHQUALITY_TUNED(double, kCell, 1.0);
    /// In spacings: shortest cell that is halved again.
    MESHQUALITY_TUNED(double, kLeastCell, 0.25);
    /// In spacings: size of gaps that are ignored.
    MESHQUALITY_TUNED(double, kLeastGap, 0.1);
    /// Cells in one batch of queries.
    MESHQUALITY_TUNED(std::size_t, kSprinkleBatch, 1024);
    /// Cells in one block of the shuffle.
    MESHQUALITY_TUNED(std::size_t, kShuffleBlock, 4096);
    /// Radians by which a vertex may rise over the tangent plane beyond an arc to it.
    MESHQUALITY_TUNED(double, kRise, 0.6);
    /// Least cosine between a triangle's normal and those at its corners (75 degrees).
    MESHQUALITY_TUNED(double, kTurned, 0.25);
    /// Fraction of an edge's length: edges farther along the normal lie on another sheet.
    MESHQUALITY_TUNED(double, kSheet, 0.5);
    /// Candidates tried for one edge.
    MESHQUALITY_TUNED(std::size_t, kCandidates, 12);
    /// Search radius in spacings: triangles between samples without gaps are smaller.
    MESHQUALITY_TUNED(double, kSearchRadius, 8.0);
    /// Radius in spacings of the neighbourhood of an apex whose normals are enclosed in the smallest ball.
    MESHQUALITY_TUNED(double, kApexNeighbourhood, 3.0);
    /// Iterations of the search for that ball, whose error decreases with their number.
    MESHQUALITY_TUNED(int, kApexRounds, 100);
};

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "base/tuning.h"

namespace mq::tetrahedralise {

/// The constants that tune tetrahedralisations.
struct TetrahedralisationTuning {
    /// Growth of the wanted length by the distance from the surface, for the usual grading.
    MESHQUALITY_TUNED(double, kGrowth, 0.8);
    /// Largest circumradius of a cell, divided by the wanted length, before it gets a point; 0.61 for a regular
    /// tetrahedron.
    MESHQUALITY_TUNED(double, kLargestRadius, 0.75);
    /// Least distance of a new point from the vertices around, divided by the wanted length.
    MESHQUALITY_TUNED(double, kLeastDistance, 0.6);
    /// Least distance of a new point from the surface around, divided by the wanted length.
    MESHQUALITY_TUNED(double, kLeastHeight, 0.3);
    /// Sine of the dihedral angle below which cells are improved.
    MESHQUALITY_TUNED(double, kGoodSine, 0.5);
    /// Sine of the dihedral angle below which cells get a new vertex, where that helps.
    MESHQUALITY_TUNED(double, kPoorSine, 0.6);
    /// Least factor of the worst quality that a new vertex must bring.
    MESHQUALITY_TUNED(double, kInsertionGain, 1.1);
    /// Largest fraction of the cells, the worst ones first, that may get a new vertex in one sweep.
    MESHQUALITY_TUNED(double, kInsertedShare, 0.01);
    /// Number of cells that may always get one, for the smallest meshes.
    MESHQUALITY_TUNED(double, kInsertedAlways, 30.0);
    /// The sweep from which on cells get new vertices.
    MESHQUALITY_TUNED(int, kFirstInsertion, 2);
    /// Sweeps of flips and smoothing at most.
    MESHQUALITY_TUNED(int, kSweeps, 6);
    /// Cells around an edge that is removed.
    MESHQUALITY_TUNED(std::size_t, kMostAround, 8);
    /// Steps of one vertex in one sweep at most.
    MESHQUALITY_TUNED(int, kVertexSteps, 6);
    /// Halvings of such a step at most.
    MESHQUALITY_TUNED(int, kStepHalvings, 5);
    /// First step of a vertex, divided by the mean length of its edges.
    MESHQUALITY_TUNED(double, kFirstStep, 0.15);
};

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "triangulate/measure/chord_error.h"

namespace mq::triangulate {

/// The number of triangles that the chord tolerance alone asks for, about: that of the mesh if each of its pieces grew
/// until it were as far from the CAD model as it may be. Distances grow with the square of lengths, so that a triangle
/// at a fraction of the tolerance counts as that fraction, a segment as its root, and each edge of a face as one
/// triangle at least.
/// @param measured  the distances of all edges
/// @param chord  the tolerance, mm, above 0
std::size_t chord_triangles(const Workspace& work, const ChordErrorCache& measured, double chord);

}  // namespace mq::triangulate

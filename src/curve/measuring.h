// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <set>
#include <vector>

#include "curve/output/curved_mesh.h"
#include "curve/surface/editor.h"
#include "curve/surface/repair.h"
#include "curve/volume/repair.h"

namespace mq::curve {

/// The triangles of a surface that are not dead.
std::vector<int> live_triangles(const CurvedSurface& surface);

/// Puts the numbers of repairs into a report.
void add_counts(const SurfaceRepairs& repairs, CurveReport& report);
void add_counts(const VolumeRepairs& repairs, CurveReport& report);

/// Numbers and measures the curved elements, after tetrahedra that stay invalid were made straight where `straighten`
/// asks for it.
/// @param straight_triangles  those that were made straight, by their index
/// @param volume  nullptr: there are triangles only
/// @param report  gets the figures
/// @param number  as for assemble()
CurvedMesh measured_mesh(SurfaceEditor& editor, const std::set<int>& straight_triangles, TetrahedralMesh* volume,
                         const geometry::Topology& topology, bool straighten, CurveReport& report, Progress& progress,
                         std::vector<int>* number = nullptr);

}  // namespace mq::curve

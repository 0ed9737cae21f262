// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "base/message.h"
#include "base/progress.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::workflows {

/// A mesh of a shape that is bound by its distance alone: few triangles, of any angles, with the faces on which they
/// lie.
struct DistanceMesh {
    triangulate::Result surface;
    double deviation = 0.0;      ///< mm: its measured distance from the shape and of points of the shape from it
    bool round = false;          ///< whether its vertices may be rounded to single precision, or are such numbers
    std::vector<Message> notes;  ///< which faces are OpenCASCADE's triangulation, and which are left out; empty: none
};

/// Ours, and OpenCASCADE's triangulation of faces that we cannot mesh, which may have holes. Faces that neither can
/// mesh are left out.
/// @param distance  mm, the largest one wanted
/// @throws TopologyError or InvalidInput where no face can be meshed; Cancelled
DistanceMesh mesh_within(geometry::Engine& engine, const TopoDS_Shape& shape, double distance, int threads,
                         Progress& progress);

/// OpenCASCADE's triangulation of a face of a shape: the coarsest one that is measured within a distance, and its
/// deviation, mm. The requested deflection alone would give far too many triangles on faulty faces.
std::pair<mesh::TriangleMesh, double> kernel_mesh(geometry::Engine& engine, const TopoDS_Shape& shape,
                                                  std::int32_t face, double distance, Progress& progress);

/// Adds a piece to a mesh in the model's frame.
void append(mesh::TriangleMesh& mesh, const mesh::TriangleMesh& piece);

/// @throws InvalidInput where the mesh of a shape within this distance, in mm, has reached the limit of triangles
void require_complete(const mesh::MeshReport& report, double distance);

}  // namespace mq::workflows

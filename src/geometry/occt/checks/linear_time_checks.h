// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepCheck_Status.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <vector>

#include "base/progress.h"

namespace mq::geometry {

/// A fault of a sub-shape, by itself or in its context.
struct Finding {
    TopoDS_Shape whose;
    TopoDS_Shape context;  ///< null: by itself
    BRepCheck_Status status = BRepCheck_NoError;
};

/// The checks of faces and shells with many edges and faces, in about linear time. OpenCASCADE's own checks are
/// quadratic and cannot be cancelled: they take 10 s for a plate with 1,600 square holes.

/// Checks vertices, edges and wires of a face, each on a face of its own. Borders that cross are not searched:
/// triangulation finds them.
/// @throws Cancelled
std::vector<Finding> check_large_face(const TopoDS_Face& face, const Progress* progress);

/// Checks whether the shell is closed and its faces are oriented alike across every edge.
/// @throws Cancelled
std::vector<Finding> check_large_shell(const TopoDS_Shell& shell, const Progress* progress);

}  // namespace mq::geometry

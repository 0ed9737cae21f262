// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>

#include "base/progress.h"
#include "geometry/evaluation.h"
#include "geometry/model.h"

class TopoDS_Shape;

namespace mq::geometry {

/// The treatment of lines inside a face across which its normal jumps.
enum class Creases {
    Keep,  ///< creases stay inside of faces: all entities are the shape's own
    Cut,   ///< creases become edges, and the face is cut along them (Topology::parts_of)
};

/// Which entities of a shape count as one in its topology if they lie together. The shape itself does not change.
struct VirtualTopology {
    /// Returns, for the box of a shape, the length below which its edges and faces are not told apart, mm; 0 or no
    /// function: all are.
    std::function<double(const Box&)> detail;
    /// Whether faces without a shell are joined where their borders lie together within that length.
    bool sew = true;
    /// Whether faces of two solids that lie on each other are one face.
    bool imprint = false;
    CornerCuts corner_cuts = CornerCuts::None;
};

/// The live OpenCASCADE shape as a model. The shape is only read: neither its topology, nor its geometry, nor its
/// display triangulation changes. Call it on the engine's thread (Engine::run).
/// @throws InvalidInput for a null shape or one without faces, naming what was given.
/// @throws GeometryError for a face without a surface, naming the face.
/// @throws Cancelled when `progress` says so.
std::shared_ptr<Model> make_shape_model(const TopoDS_Shape& shape, const Progress* progress = nullptr,
                                        Creases creases = Creases::Keep, const VirtualTopology& join = {},
                                        Evaluation evaluation = Evaluation::Fast);

/// The box of a shape without its tolerances; near curved faces as close as Topology::box. Call it on the engine's
/// thread.
/// @throws as make_shape_model
Box box_of_shape(const TopoDS_Shape& shape);

/// The version of OpenCASCADE used in this build, "7.6.3".
const char* occt_version();

}  // namespace mq::geometry

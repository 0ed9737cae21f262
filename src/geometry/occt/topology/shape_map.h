// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "geometry/occt/evaluation/edge_curves.h"
#include "geometry/occt/topology/ordered_shape.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// The curve of an edge in the parameter domain of a face; null where the shape has none.
struct PCurve {
    Handle(Geom2d_Curve) curve;
    double first = 0.0;
    double last = 0.0;
    /// Whether the curve belongs to another edge that was joined with this one within the tolerance: its parameter
    /// differs.
    bool of_neighbour = false;
};

/// The shape's own sub-shapes behind the entities of the topology, by the same indices. Faces and edges are all
/// reoriented to FORWARD.
struct ShapeMap {
    std::vector<TopoDS_Face> faces;
    std::vector<TopoDS_Edge> edges;
    std::vector<TopoDS_Vertex> nodes;
    std::vector<PCurve> uses;
    std::vector<TopoDS_Shape> volumes;
    EdgeCurves curves;
};

/// Fills `live` and returns the entities of `shape`; faults of their connections are in `faults`.
/// @throws Cancelled
Topology build_topology(const OrderedShape& shape, ShapeMap& live, const Progress* progress);

/// Periods of a surface in u and v, 0 where it is open. A surface that is closed within `tolerance` without being
/// periodic counts with its whole range.
std::array<double, 2> periods_of(const GeomAdaptor_Surface& surface, double tolerance);

/// The faults that OpenCASCADE's own checks find, one line each, with the entity's name.
std::vector<std::string> kernel_faults(const TopoDS_Shape& shape, const ShapeMap& live, const Topology& topology,
                                       const Progress* progress);

class FaceEvaluator;

/// The bounding box of the shape, whether or not it has a display triangulation. `face` answers for a face of the
/// topology.
Box bounding_box(const TopoDS_Shape& shape, const ShapeMap& live, const Topology& topology,
                 const std::function<FaceEvaluator&(int)>& face, const Progress* progress);

}  // namespace mq::geometry

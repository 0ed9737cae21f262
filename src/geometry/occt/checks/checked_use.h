// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Curve.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <gp_Trsf.hxx>

namespace mq::geometry {

/// The surface of a face on which edges are looked at.
struct CheckedSurface {
    explicit CheckedSurface(const TopoDS_Face& shape);

    gp_Pnt at(const gp_Pnt2d& uv) const { return adaptor.Value(uv.X(), uv.Y()).Transformed(transformation); }
    /// Whether OpenCASCADE's checks take two points in (u, v) for one place, with this tolerance in space, mm.
    bool is_one_place(const gp_Pnt2d& a, const gp_Pnt2d& b, double tolerance) const;

    TopoDS_Face face;
    TopLoc_Location place;
    Handle(Geom_Surface) surface;
    gp_Trsf transformation;
    GeomAdaptor_Surface adaptor;
};

/// A use of an edge on a face in which OpenCASCADE's checks of edges and vertices find no fault.
class CheckedUse {
  public:
    /// @return whether this is proven: there is one curve in space and one on the surface, with the same range, within
    /// the tolerances of each other and of the vertices
    bool read(const TopoDS_Edge& edge, const CheckedSurface& on);

    TopoDS_Edge edge;
    Handle(Geom2d_Curve) curve;
    double first = 0.0;
    double last = 0.0;
    bool twice = false;                     ///< whether the surface closes there, and the edge has to be met twice
    std::array<TopoDS_Vertex, 2> vertices;  ///< at start and end in the direction of the wire, as in all arrays below
    std::array<gp_Pnt2d, 2> uv;
    std::array<gp_Pnt, 2> points;       ///< at `uv`
    std::array<double, 2> distances{};  ///< mm, from the vertices to the ends of both curves

  private:
    bool read_curves(const CheckedSurface& on);
    bool has_range() const;
    bool read_ends(const CheckedSurface& on);
    bool lies_on(const CheckedSurface& on) const;

    Handle(Geom_Curve) in_space_;  ///< null where it is a point
    TopLoc_Location place_;
};

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/node_placement.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include "curve/placed_surface.h"
#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"

namespace mq::curve {
namespace {

/// A straight edge of length 11 whose speed is 10 up to its middle parameter, and 1 from there.
TopoDS_Edge edge_with_a_jump_of_speed() {
    TColgp_Array1OfPnt poles(1, 3);
    poles.SetValue(1, gp_Pnt(0.0, 0.0, 0.0));
    poles.SetValue(2, gp_Pnt(10.0, 0.0, 0.0));
    poles.SetValue(3, gp_Pnt(11.0, 0.0, 0.0));
    TColStd_Array1OfReal knots(1, 3);
    TColStd_Array1OfInteger multiplicities(1, 3);
    for (int i = 1; i <= 3; ++i) {
        knots.SetValue(i, i);
        multiplicities.SetValue(i, i == 2 ? 1 : 2);
    }
    const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, multiplicities, 1);
    return BRepBuilderAPI_MakeEdge(curve).Edge();
}

TEST(Placement, NodesOnEdgesAreAtEvenLengthsWhereTheSpeedJumps) {
    const TopoDS_Shape face =
        geometry::planar_face({edge_with_a_jump_of_speed(), geometry::line(11.0, 0.0, 11.0, 9.0),
                               geometry::line(11.0, 9.0, 0.0, 9.0), geometry::line(0.0, 9.0, 0.0, 0.0)});
    for (int order = 2; order <= 4; ++order) {
        PlacedCurvedSurface placed(geometry::make_shape_model(face), order, 20.0);
        int segments = 0;
        for (const int t : live_triangles(placed.surface)) {
            const auto& v = placed.editor.triangle(t).corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = v[k];
                const int b = v[(k + 1) % 3];
                if (placed.surface.segment(a, b) == nullptr) {
                    continue;
                }
                ++segments;
                const Vec3 from = placed.editor.point(a);
                const Vec3 step = (placed.editor.point(b) - from) / order;
                const std::vector<Vec3> inner = placed.surface.shapes.edge_inner(a, b);
                for (std::size_t i = 0; i < inner.size(); ++i) {
                    EXPECT_LT((inner[i] - from - static_cast<double>(i + 1) * step).norm(), 1e-6) << order;
                }
            }
        }
        EXPECT_GE(segments, 4);
    }
}

}  // namespace
}  // namespace mq::curve

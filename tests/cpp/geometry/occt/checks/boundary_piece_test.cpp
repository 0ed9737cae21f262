// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/boundary_piece.h"

#include <gtest/gtest.h>

#include <Geom2d_Ellipse.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Elips2d.hxx>

namespace mq::geometry {
namespace {

/// A polynomial over [0, 1].
Handle(Geom2d_Curve) cubic(const gp_Pnt2d& a, const gp_Pnt2d& b, const gp_Pnt2d& c, const gp_Pnt2d& d) {
    TColgp_Array1OfPnt2d poles(1, 4);
    poles(1) = a;
    poles(2) = b;
    poles(3) = c;
    poles(4) = d;
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0.0;
    knots(2) = 1.0;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(4);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 3);
}

Handle(Geom2d_Curve) ellipse(double major, double minor) {
    return new Geom2d_Ellipse(gp_Elips2d(gp::OX2d(), major, minor));
}

/// The largest distance of a curve's points from the nearest chord, over that chord's height.
double largest_excess(const Handle(Geom2d_Curve) & curve, double first, double last,
                      const std::vector<BoundaryPiece>& pieces) {
    double most = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const gp_Pnt2d at = curve->Value(first + (last - first) * i / 1000);
        const Vec2 point(at.X(), at.Y());
        double least = 1e300;
        for (const BoundaryPiece& piece : pieces) {
            const Vec2 chord = piece.end() - piece.start();
            const double share = std::clamp((point - piece.start()).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (piece.start() + share * chord - point).norm() - piece.height());
        }
        most = std::max(most, least);
    }
    return most;
}

TEST(BoundaryPiece, CurvesLieWithinTheHeightsOfTheirChords) {
    const Handle(Geom2d_Curve) loop =
        cubic(gp_Pnt2d(0.0, 0.0), gp_Pnt2d(3.0, 0.0), gp_Pnt2d(0.0, 3.0), gp_Pnt2d(0.0, 0.0));
    for (const auto& [curve, last] : {std::pair(loop, 1.0), std::pair(ellipse(2.0, 1.0), 2.0 * M_PI)}) {
        const std::vector<BoundaryPiece> pieces = BoundaryPiece::of(curve, 0.0, last, true);
        EXPECT_GT(pieces.size(), 3u);  // a closed curve has no chord
        EXPECT_LT(largest_excess(curve, 0.0, last, pieces), 1e-12);
    }
}

TEST(BoundaryPiece, CurvesThatTurnMuchHaveNone) {
    const Handle(Geom2d_Curve) cusp =
        cubic(gp_Pnt2d(0.0, 0.0), gp_Pnt2d(1.0, 1.0), gp_Pnt2d(0.0, 1.0), gp_Pnt2d(1.0, 0.0));
    EXPECT_TRUE(BoundaryPiece::of(cusp, 0.0, 0.9, true).empty());
    EXPECT_FALSE(BoundaryPiece::of(cusp, 0.0, 0.45, true).empty());
    EXPECT_TRUE(BoundaryPiece::of(ellipse(1e4, 1.0), -0.1, 1.0, true).empty());
    EXPECT_FALSE(BoundaryPiece::of(ellipse(1e4, 1.0), 0.8, 1.2, true).empty());
}

}  // namespace
}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/enclosed_volume.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <cmath>

#include "curve/placed_surface.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

double volume_of(const TopoDS_Shape& shape, int order) {
    PlacedCurvedSurface placed(geometry::make_shape_model(shape), order, 1.0);
    return enclosed_volume(placed.surface, placed.session.topology(), Progress());
}

TEST(EnclosedVolume, IsExactWhereTheMeshIs) {
    for (int order = 1; order <= 4; ++order) {
        EXPECT_NEAR(volume_of(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape(), order), 24.0, 1e-5) << order;
    }
}

TEST(EnclosedVolume, NearsThatOfRoundBodiesWithTheOrder) {
    const double sphere = 4.0 / 3.0 * M_PI;
    double last = 1.0;
    for (int order = 1; order <= 4; ++order) {
        const double error = std::abs(volume_of(BRepPrimAPI_MakeSphere(1.0).Shape(), order) - sphere) / sphere;
        EXPECT_LT(error, 0.5 * last) << order;
        last = error;
    }
    EXPECT_LT(last, 1e-4);
}

TEST(EnclosedVolume, FacesAloneEncloseNothing) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shell();
    EXPECT_EQ(volume_of(shape, 2), 0.0);
}

}  // namespace
}  // namespace mq::curve

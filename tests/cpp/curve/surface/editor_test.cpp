// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/editor.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>

#include "curve/surface/invalid_triangles.h"
#include "curve/surface/repair.h"
#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

TEST(SurfaceOperations, SplitsAndCollapsesKeepTheSurfaceClosed) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    SurfaceEditor& editor = filled.surface_editor;
    std::vector<int> fresh;
    const std::size_t count = filled.surface.triangles.size();
    for (std::size_t t = 0; t < count; t += 3) {
        const auto v = filled.surface.triangles[t].corners;
        if (filled.surface.triangles[t].alive) {
            const int p = split_surface_edge(editor, v[0], v[1], SurfaceEditor::Rule::Refine);
            ASSERT_GE(p, 0);
            fresh.push_back(p);
        }
    }
    EXPECT_TRUE(invalid_triangles(filled.surface).empty());
    for (const int p : fresh) {
        EXPECT_LT(std::min(std::abs(editor.point(p).head<2>().norm() - 1.0),
                           std::min(std::abs(editor.point(p).z()), std::abs(editor.point(p).z() - 2.0))),
                  1e-9);
    }
    for (const SurfaceTriangle& t : filled.surface.triangles) {
        for (std::size_t k = 0; k < 3 && t.alive; ++k) {
            EXPECT_EQ(filled.surface.triangles_of_edge(t.corners[k], t.corners[(k + 1) % 3]).size(), 2u);
        }
    }
}

}  // namespace
}  // namespace mq::curve

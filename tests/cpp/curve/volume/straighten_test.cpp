// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/straighten.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <set>

#include "curve/files.h"
#include "curve/surface/invalid_triangles.h"
#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

std::vector<int> invalid_tetrahedra(const TetrahedralMesh& volume) {
    std::vector<int> result;
    for (const int t : volume.live_tetrahedra()) {
        if (!(volume.tetrahedra[static_cast<std::size_t>(t)].quality > 0.0)) {
            result.push_back(t);
        }
    }
    return result;
}

TEST(Straighten, TetrahedraThatStayInvalidBecomeStraight) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), 3);
    TetrahedralMesh& volume = filled.volume;
    int bent = 0;
    for (std::size_t t = 0; t < volume.tetrahedra.size() && bent < 5; ++t) {
        const auto& v = volume.tetrahedra[t].corners;
        if (!volume.fixed_edge(v[0], v[1]) && !volume.shapes().has_edge(v[0], v[1])) {
            const Vec3 far(10.0 + bent, 0.0, 0.0);
            volume.shapes().set_edge(v[0], v[1], {volume.point(v[0]) + far, volume.point(v[1]) + far});
            ++bent;
        }
    }
    ASSERT_EQ(bent, 5);
    volume.measure(volume.live_tetrahedra());
    const std::vector<int> before = invalid_tetrahedra(volume);
    ASSERT_GE(before.size(), 5u);
    const std::set<int> done = straighten_tetrahedra(volume, filled.surface_editor);
    EXPECT_TRUE(invalid_tetrahedra(volume).empty());
    for (const int t : before) {
        EXPECT_EQ(done.count(t), 1u);
        EXPECT_FALSE(volume.curved(volume.tetrahedra[static_cast<std::size_t>(t)].corners));
    }
    EXPECT_TRUE(straighten_tetrahedra(volume, filled.surface_editor).empty()) << "nothing is left to do";
}

TEST(Straighten, TrianglesThatStayInvalidBecomeStraightAndNoOthers) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    CurvedSurface& surface = filled.surface;
    const auto v = surface.triangles[4].corners;
    const Vec3 along = filled.surface_editor.point(v[1]) - filled.surface_editor.point(v[0]);
    surface.shapes.set_edge(v[0], v[1], {filled.surface_editor.point(v[0]) + 4.0 * along});
    filled.surface_editor.placement.measure(surface.triangles_of_edge(v[0], v[1]));
    const std::vector<int> before = invalid_triangles(surface);
    ASSERT_FALSE(before.empty());
    const std::set<int> done = straighten_triangles(filled.surface_editor);
    EXPECT_TRUE(invalid_triangles(surface).empty());
    EXPECT_LT(done.size(), surface.alive() / 4);
    std::set<elements::EdgeKey> straight;
    for (const int t : done) {
        const auto& c = surface.triangles[static_cast<std::size_t>(t)].corners;
        straight.insert({pair_key(c[0], c[1]), pair_key(c[1], c[2]), pair_key(c[2], c[0])});
    }
    for (const auto& [key, segment] : surface.segments) {
        const bool made_straight = straight.count(key) > 0;
        EXPECT_EQ(surface.shapes.has_edge(static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffffu)),
                  !made_straight)
            << "edges on the CAD stay curved elsewhere";
    }
}

TEST(Straighten, NothingIsMadeStraightWithoutNeed) {
    CurveOptions options = of_order(2, true);
    options.straighten = true;
    const CurvedMesh mesh = curved(thin_wall(0.1, 0.5 * M_PI), options);
    EXPECT_EQ(mesh.report.invalid, 0u);
    EXPECT_TRUE(mesh.report.straightened.empty());
    EXPECT_EQ(to_msh(mesh), to_msh(curved(thin_wall(0.1, 0.5 * M_PI), of_order(2, true))));
}

}  // namespace
}  // namespace mq::curve

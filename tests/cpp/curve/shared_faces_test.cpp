// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <cmath>

#include "curve/checks.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

/// Solids that touch or overlap, cut so that their common face, or common solid, is one entity of both.
std::shared_ptr<geometry::Model> fused(const std::vector<TopoDS_Shape>& shapes) {
    TopTools_ListOfShape arguments;
    for (const TopoDS_Shape& shape : shapes) {
        arguments.Append(shape);
    }
    BRepAlgoAPI_BuilderAlgo builder;
    builder.SetArguments(arguments);
    builder.Build();
    return geometry::make_shape_model(builder.Shape());
}

/// Every face of a tetrahedron belongs to two of them, or to one and a triangle of the boundary; on triangles that two
/// volumes share, it belongs to one of each, with the same nodes.
/// @return the number of such triangles.
std::size_t expect_conforming_volumes(const CurvedMesh& mesh) {
    auto faces = tetrahedra_of_faces(mesh);
    const auto volume = [&](std::size_t e) { return mesh.tetrahedron_volume[e]; };
    std::size_t shared = 0;
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        const auto found = faces.find(nodes_of_triangle(mesh, t));
        if (found == faces.end()) {
            ADD_FAILURE() << "a triangle without a tetrahedron";
            continue;
        }
        if (found->second.size() == 2) {
            EXPECT_NE(volume(found->second[0]), volume(found->second[1]));
            ++shared;
        }
        EXPECT_LE(found->second.size(), 2u);
        faces.erase(found);
    }
    for (const auto& [nodes, elements] : faces) {
        EXPECT_EQ(elements.size(), 2u);
        EXPECT_EQ(volume(elements.front()), volume(elements.back()));
    }
    return shared;
}

struct Case {
    const char* name;
    std::vector<TopoDS_Shape> shapes;
    int solids;
    double volume;
};

std::vector<Case> cases() {
    const gp_Ax2 above(gp_Pnt(1.0, 1.0, 1.0), gp::DZ());
    const gp_Ax2 inside(gp_Pnt(1.0, 1.0, -0.5), gp::DZ());
    return {
        {"two boxes side by side",
         {BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(),
          BRepPrimAPI_MakeBox(gp_Pnt(1.0, 0.0, 0.0), 1.0, 1.0, 1.0).Shape()},
         2,
         2.0},
        {"a cylinder on a box",
         {BRepPrimAPI_MakeBox(2.0, 2.0, 1.0).Shape(), BRepPrimAPI_MakeCylinder(above, 0.6, 1.0).Shape()},
         2,
         4.0 + M_PI * 0.36},
        {"a cylinder through a box",
         {BRepPrimAPI_MakeBox(2.0, 2.0, 1.0).Shape(), BRepPrimAPI_MakeCylinder(inside, 0.6, 2.0).Shape()},
         4,
         4.0 + M_PI * 0.36},
        {"a ball in a box",
         {BRepPrimAPI_MakeBox(gp_Pnt(-1.5, -1.5, -1.5), 3.0, 3.0, 3.0).Shape(), BRepPrimAPI_MakeSphere(1.0).Shape()},
         2,
         27.0},
        {"two cylinders one in the other",
         {BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape(), BRepPrimAPI_MakeCylinder(0.5, 1.0).Shape()},
         2,
         M_PI},
    };
}

TEST(SharedFaces, SolidsGetOneConformingMesh) {
    for (const Case& c : cases()) {
        for (const int order : {1, 3}) {
            const CurvedMesh mesh = curved(fused(c.shapes), of_order(order, true));
            EXPECT_EQ(mesh.report.invalid, 0u) << c.name << order << "\n" << to_text(mesh.report);
            EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << c.name << order;
            const std::set<int> volumes(mesh.tetrahedron_volume.begin(), mesh.tetrahedron_volume.end());
            EXPECT_EQ(volumes.size(), static_cast<std::size_t>(c.solids)) << c.name << order;
            EXPECT_GT(expect_conforming_volumes(mesh), 0u) << c.name << order;
            EXPECT_NEAR(volume_of(mesh), c.volume, (order == 1 ? 0.05 : 1e-3) * c.volume) << c.name << order;
        }
    }
}

}  // namespace
}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/brep_text.h"

#include <gtest/gtest.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS_Shape.hxx>
#include <string>

namespace mq::geometry {
namespace {

TEST(BrepText, IsTheSameBeforeAndAfterTheShapeWasTriangulated) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20.0, 8.0).Shape();
    const std::string before = write_brep_text(torus);
    BRepMesh_IncrementalMesh(torus, 0.01);
    EXPECT_EQ(write_brep_text(torus), before);
    EXPECT_NE(write_brep_text(BRepPrimAPI_MakeTorus(20.0, 7.0).Shape()), before);
}

TEST(BrepText, ComesBackAsTheSameShape) {
    const std::string text = write_brep_text(BRepPrimAPI_MakeTorus(20.0, 8.0).Shape());
    EXPECT_EQ(write_brep_text(*read_brep_text(text)), text);
}

}  // namespace
}  // namespace mq::geometry

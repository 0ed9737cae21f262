// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/sub_shapes.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopoDS_Compound.hxx>

#include "geometry/occt/topology/ordered_shape.h"

namespace mq::geometry {
namespace {

TopoDS_Compound boxes(int count) {
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < count; ++i) {
        builder.Add(all, BRepPrimAPI_MakeBox(gp_Pnt(2.0 * i, 0.0, 0.0), 1.0, 1.0, 1.0).Shape());
    }
    return all;
}

TEST(SubShapes, HaveTheOrderOfOpenCascade) {
    const TopoDS_Compound three = boxes(3);
    for (const TopAbs_ShapeEnum kind : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE, TopAbs_SHELL}) {
        TopTools_IndexedMapOfShape found;
        map_sub_shapes(three, kind, found, nullptr);
        TopTools_IndexedMapOfShape wanted;
        TopExp::MapShapes(three, kind, wanted);
        ASSERT_EQ(found.Extent(), wanted.Extent());
        for (int i = 1; i <= wanted.Extent(); ++i) {
            EXPECT_TRUE(found(i).IsEqual(wanted(i)));
        }
    }
}

TEST(SubShapes, AreNotMappedToTheEndAfterACancellation) {
    constexpr int kMany = 200;  // with 48 visits of vertices each: more than lie between two checks
    const TopoDS_Compound many = boxes(kMany);
    Progress progress;
    progress.cancel();
    TopTools_IndexedMapOfShape found;
    EXPECT_THROW(map_sub_shapes(many, TopAbs_VERTEX, found, &progress), Cancelled);
    EXPECT_THROW(ordered(many, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/shape_copy.h"

#include <BRep_Builder.hxx>
#include <BRep_TFace.hxx>
#include <TopoDS_Iterator.hxx>

namespace mq::geometry {

TopoDS_Shape ShapeCopy::in_own_frame(const Definition& own) {
    TopoDS_Shape shape;
    shape.TShape(own);
    return shape;
}

TopoDS_Shape ShapeCopy::of(const TopoDS_Shape& shape) {
    TopoDS_Shape copy = shape;
    copy.TShape(copy_of(shape.TShape()));
    copy.Location(placed(shape.Location()), Standard_False);
    return copy;
}

/// The definition itself where nothing changes.
ShapeCopy::Definition ShapeCopy::copy_of(const Definition& own) {
    const auto known = copies_.find(own.get());
    if (known != copies_.end()) {
        return known->second;
    }
    std::vector<TopoDS_Shape> children;
    bool changed = changes(*own);
    for (TopoDS_Iterator each(in_own_frame(own), Standard_False, Standard_False); each.More(); each.Next()) {
        children.push_back(of(each.Value()));
        changed = changed || !children.back().IsEqual(each.Value());
    }
    const Definition copy = changed ? copy_with(own, children) : own;
    copies_.emplace(own.get(), copy);
    return copy;
}

ShapeCopy::Definition ShapeCopy::copy_with(const Definition& own, const std::vector<TopoDS_Shape>& children) {
    const Definition copy = own->EmptyCopy();
    if (own->ShapeType() == TopAbs_FACE) {
        const auto& from = static_cast<const BRep_TFace&>(*own);
        auto& to = static_cast<BRep_TFace&>(*copy);
        to.NaturalRestriction(from.NaturalRestriction());
        to.Triangulation(from.Triangulation());
    }
    if (changes(*own)) {
        change(*own, *copy);
    }
    TopoDS_Shape shape = in_own_frame(copy);
    for (const TopoDS_Shape& child : children) {
        BRep_Builder().Add(shape, child);
    }
    copy->Free(own->Free());
    copy->Orientable(own->Orientable());
    copy->Closed(own->Closed());
    copy->Infinite(own->Infinite());
    copy->Convex(own->Convex());
    return copy;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/sub_shapes.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace mq::geometry {

namespace {

TopTools_IndexedMapOfShape faces_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return faces;
}

}  // namespace

std::shared_ptr<const TopoDS_Shape> kept(const TopoDS_Shape& shape) {
    return std::make_shared<TopoDS_Shape>(shape);
}

std::size_t face_count(const TopoDS_Shape& shape) {
    return static_cast<std::size_t>(faces_of(shape).Extent());
}

std::shared_ptr<const TopoDS_Shape> copied_face(const TopoDS_Shape& shape, std::size_t face) {
    return std::make_shared<TopoDS_Shape>(BRepBuilderAPI_Copy(faces_of(shape)(static_cast<int>(face) + 1)).Shape());
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "base/progress.h"

namespace mq::geometry {

/// Adds the sub-shapes of one kind in the order of TopExp::MapShapes, which cannot be cancelled.
/// @throws Cancelled
inline void map_sub_shapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopTools_IndexedMapOfShape& map,
                           const Progress* progress) {
    CancelPace pace(progress);
    for (TopExp_Explorer each(shape, kind); each.More(); each.Next()) {
        pace.step();
        map.Add(each.Current());
    }
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <unordered_map>
#include <vector>

namespace mq::geometry {

/// Copies what is to change of a shape, and what consists of that; all else, and all geometry, is shared with it.
/// Sub-shapes keep their order, and a shape at several places stays one.
class ShapeCopy {
  public:
    virtual ~ShapeCopy() = default;

    TopoDS_Shape of(const TopoDS_Shape& shape);

  protected:
    /// A shape where it was defined, before any location.
    using Definition = Handle(TopoDS_TShape);
    static TopoDS_Shape in_own_frame(const Definition& own);

    /// Whether the geometry of a definition is to change, apart from what it consists of.
    virtual bool changes(const TopoDS_TShape& own) = 0;
    /// Changes it in its copy, which has nothing else yet.
    virtual void change(const TopoDS_TShape& own, TopoDS_TShape& copy) = 0;
    /// The location of what a definition consists of.
    virtual TopLoc_Location placed(const TopLoc_Location& own) { return own; }

  private:
    Definition copy_of(const Definition& own);
    Definition copy_with(const Definition& own, const std::vector<TopoDS_Shape>& children);

    std::unordered_map<const TopoDS_TShape*, Definition> copies_;
};

}  // namespace mq::geometry

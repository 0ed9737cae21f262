// SPDX-License-Identifier: LGPL-2.1-or-later
%module occ_shape
%{
#include <TopoDS_Shape.hxx>
%}
// The destructor is declared so that a shape handed out by FreeCAD is released with its Python object.
class TopoDS_Shape {
  public:
    TopoDS_Shape();
    ~TopoDS_Shape();
};

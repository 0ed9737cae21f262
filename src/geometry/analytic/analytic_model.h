// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "geometry/model.h"

/// Simple solids by formula, without a modeler: the right answer to every query on them is known. Indices, directions
/// and parameters are those of OpenCASCADE's primitives of the same name.
namespace mq::geometry {

/// A sphere about the origin.
std::shared_ptr<Model> make_sphere(double radius);
/// A cylinder about the z axis, from z = 0 up.
std::shared_ptr<Model> make_cylinder(double radius, double height);
/// A cone about the z axis, from z = 0 up, with the apex at the top.
std::shared_ptr<Model> make_cone(double radius, double height);
/// A torus about the origin and the z axis; `minor` < `major`.
std::shared_ptr<Model> make_torus(double major, double minor);
/// A box from the origin to (a, b, c).
std::shared_ptr<Model> make_box(double a, double b, double c);

}  // namespace mq::geometry

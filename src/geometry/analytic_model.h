// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "geometry/model.h"

/// Simple solids by formula, without a modeler: what every query must answer on them is known. Indices, directions
/// and parameters are those of OpenCASCADE's primitives of the same name.
namespace mq::geometry {

/// About the origin.
std::shared_ptr<Model> make_sphere(double radius);
/// From z = 0 up, about the z axis.
std::shared_ptr<Model> make_cylinder(double radius, double height);
/// As the cylinder, with an apex at the top.
std::shared_ptr<Model> make_cone(double radius, double height);
/// About the origin and the z axis; `minor` < `major`.
std::shared_ptr<Model> make_torus(double major, double minor);
/// From the origin to (a, b, c).
std::shared_ptr<Model> make_box(double a, double b, double c);

}  // namespace mq::geometry

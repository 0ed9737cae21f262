// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include "geometry/occt/stream/byte_reader.h"

namespace mq::geometry {

/// A curve or a surface of OpenCASCADE's binary BREP, with all bits of its numbers.
/// @throws InvalidInput, Standard_Failure for numbers of which there is none
Handle(Geom2d_Curve) read_plane_curve(ByteReader& bytes);
Handle(Geom_Curve) read_curve(ByteReader& bytes);
Handle(Geom_Surface) read_surface(ByteReader& bytes);

}  // namespace mq::geometry

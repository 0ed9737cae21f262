// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>

namespace mq::geometry {

/// Whether a proof says that OpenCASCADE's checks (BRepCheck) of a face, its wires, edges and vertices find nothing.
/// The proof takes a fraction of their time: boundaries are simple where the hulls of their pieces are apart and
/// neighbours leave each other along one direction. False decides nothing.
/// @param face  without location
bool is_proved_valid(const TopoDS_Face& face);

}  // namespace mq::geometry

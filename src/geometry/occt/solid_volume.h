// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"

class TopoDS_Shape;

namespace mq::geometry {

/// The volume of the solids of the shape by the kernel's adaptive integration, mm^3, each solid once and also of those
/// that are inside out; 0 without a solid. Call it on the engine's thread (Engine::run).
/// @throws GeometryError when the kernel fails.
/// @throws Cancelled
double solid_content(const TopoDS_Shape& shape, const Progress* progress = nullptr);

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"

class TopoDS_Shape;

namespace mq::geometry {

struct SolidContent {
    double volume = 0.0;  ///< mm^3; 0 without a solid
    double error = 0.0;   ///< mm^3: by integration, and by faces that meet only within the tolerance of their edges
};

/// The volume of the solids of the shape, each solid once and also of those that are inside out. Integrated over their
/// trimmed faces, adaptively (divergence theorem); not by BRepGProp, which errs by a third on faces in closed splines.
/// Call it on the engine's thread (Engine::run).
/// @throws GeometryError when the kernel fails.
/// @throws Cancelled
SolidContent solid_content(const TopoDS_Shape& shape, const Progress* progress = nullptr);

}  // namespace mq::geometry

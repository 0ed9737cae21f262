// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace mq::geometry {

/// By whose code the curves and surfaces of a shape are evaluated and points are projected onto them.
enum class Evaluation {
    Fast,    ///< elementary surfaces by formula, B-splines by their polynomial pieces; all else as Native
    Native,  ///< by OpenCASCADE, as Aftosmis 1999 asks; by ours where it has no such function or finds nothing
};

}  // namespace mq::geometry

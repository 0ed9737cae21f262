// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace mq::geometry {

/// Which code evaluates the curves and surfaces of a shape and projects points onto them.
enum class Evaluation {
    Fast,    ///< elementary surfaces by formula, B-splines by their polynomial pieces; all else as Native
    Native,  ///< by OpenCASCADE, as in Aftosmis 1999; by our code if it has no such function or finds nothing
};

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/engine.h"

namespace mq::python {

/// The geometry engine of the process, started on first use. Call it with the GIL held.
geometry::Engine& shared_engine();

/// Ends the engine's main thread, which must have nothing to do; see end_with_python. The engine's threads for jobs
/// wait while the process exits.
void stop_shared_engine();

}  // namespace mq::python

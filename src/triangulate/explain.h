// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// The sentence for the report: why a triangle keeps a small angle, and which CAD entities are the reason.
std::string explain(const Workspace& work, int triangle, const Exemption& exemption);

}  // namespace mq::triangulate

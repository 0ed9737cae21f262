// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "view/colour.h"

class SoSeparator;

namespace mq::view {

/// A scale of colours at the window's right side; empty until it is filled.
SoSeparator* make_legend();

/// Colours from bottom to top, and labels spread evenly over them; none: an empty legend.
void fill_legend(SoSeparator& legend, const std::string& title, const std::vector<Colour>& colours,
                 const std::vector<std::string>& labels);

}  // namespace mq::view

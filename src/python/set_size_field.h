// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "base/sizes/size_field.h"

namespace mq::python {

/// Gives options a copy of a size field, or none.
template <typename Options>
void set_size_field(Options& options, const SizeField* field) {
    options.size_field = field != nullptr ? std::make_shared<const SizeField>(*field) : nullptr;
}

}  // namespace mq::python

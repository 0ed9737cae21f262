// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <string>

namespace mq::geometry {

/// The message of an exception of OpenCASCADE, or its type where it has none.
inline std::string failure_text(const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    return text != nullptr && *text != '\0' ? text : failure.DynamicType()->Name();
}

}  // namespace mq::geometry

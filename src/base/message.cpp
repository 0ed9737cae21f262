// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/message.h"

namespace mq {

std::string Message::text(const std::function<std::string(const std::string&)>& written) const {
    if (is_value) {
        return written ? written(phrase) : phrase;
    }
    std::string result = phrase;
    for (const auto& [name, value] : places) {
        const std::string place = "{" + name + "}";
        if (const std::size_t at = result.find(place); at != std::string::npos) {
            result.replace(at, place.size(), value.text(written));
        }
    }
    return result;
}

}  // namespace mq

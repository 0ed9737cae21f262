// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/message.h"

#include <cstdio>

namespace mq {

Message Message::of(std::string phrase, std::initializer_list<std::pair<const char*, std::string>> values) {
    Message message{std::move(phrase)};
    for (const auto& [place, text] : values) {
        message.places.push_back({place, value(text)});
    }
    return message;
}

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

std::string in_digits(double number, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

}  // namespace mq

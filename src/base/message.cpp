// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/message.h"

#include <algorithm>
#include <cstdio>

namespace mq {

Message::Message(Phrase text, std::initializer_list<Place> in_places) : phrase(text.english), places(in_places) {}

Message Message::value(std::string text) {
    Message message;
    message.phrase = std::move(text);
    message.is_value = true;
    return message;
}

std::string Message::text(const std::function<std::string(const std::string&)>& written) const {
    if (is_value) {
        return written ? written(phrase) : phrase;
    }
    std::string result = phrase;
    for (const Place& place : places) {
        const std::string mark = "{" + place.name + "}";
        if (const std::size_t at = result.find(mark); at != std::string::npos) {
            result.replace(at, mark.size(), place.content.text(written));
        }
    }
    return result;
}

bool operator==(const Message& a, const Message& b) {
    return a.phrase == b.phrase && a.is_value == b.is_value &&
           std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                      [](const Place& p, const Place& q) { return p.name == q.name && p.content == q.content; });
}

Message counted(const Phrase (&one_and_many)[2], std::size_t count, std::initializer_list<Place> others) {
    Message message(one_and_many[count == 1 ? 0 : 1], others);
    message.places.emplace_back("count", count);
    return message;
}

std::string in_digits(double number, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

std::string in_mm(double length, int digits) {
    return in_digits(length, digits) + " mm";
}

std::string in_mm(const Vec3& point, int digits) {
    return "(" + in_digits(point.x(), digits) + ", " + in_digits(point.y(), digits) + ", " +
           in_digits(point.z(), digits) + ") mm";
}

}  // namespace mq

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace mq {

/// A text of the catalogue (Mod/MeshQuality/phrases.py) with places such as {face}. The build makes all of them
/// (tools/core_phrases), so that a text that nobody can translate does not compile where a message is needed.
struct Phrase {
    const char* english;
};

struct Place;

/// A text that keeps what it is made of, so that a window can say it in the user's language: a phrase of the catalogue
/// and what stands in its places.
struct Message {
    std::string phrase;
    std::vector<Place> places;
    bool is_value = false;  ///< no phrase, but what stands in the place of one: "Face3", "7.25"

    Message() = default;
    Message(Phrase text, std::initializer_list<Place> in_places = {});
    static Message value(std::string text);
    bool empty() const { return phrase.empty(); }
    /// Returns the text, with each value as `written` gives it; by default as it is.
    std::string text(const std::function<std::string(const std::string&)>& written = {}) const;
};

bool operator==(const Message& a, const Message& b);

/// What stands in a place of a phrase: a message again, a name or a number.
struct Place {
    std::string name;
    Message content;

    Place(const char* place, Message message) : name(place), content(std::move(message)) {}
    Place(const char* place, std::string text) : Place(place, Message::value(std::move(text))) {}
    template <class Count, std::enable_if_t<std::is_integral_v<Count>, int> = 0>
    Place(const char* place, Count count) : Place(place, std::to_string(count)) {}
};

/// One of two phrases, for one and for many, by the number in its place {count}.
Message counted(const Phrase (&one_and_many)[2], std::size_t count, std::initializer_list<Place> others = {});

/// A number with this many significant digits.
std::string in_digits(double number, int digits);
/// A length or a point with its unit, to this many digits.
std::string in_mm(double length, int digits = 4);
std::string in_mm(const Vec3& point, int digits = 4);

}  // namespace mq

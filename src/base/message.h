// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace mq {

/// A text that keeps what it is made of, so that a window can say it in the user's language: a phrase of the catalogue
/// (Mod/MeshQuality/phrases.py) and what stands in its places, such as {face}.
struct Message {
    std::string phrase;
    std::vector<std::pair<std::string, Message>> places{};
    bool is_value = false;  ///< no phrase, but what stands in the place of one: "Face3", "7.25"

    static Message value(std::string text) { return {std::move(text), {}, true}; }
    /// A phrase with a value in each place.
    static Message of(std::string phrase, std::initializer_list<std::pair<const char*, std::string>> values);
    bool empty() const { return phrase.empty(); }
    friend bool operator==(const Message& a, const Message& b) {
        return a.phrase == b.phrase && a.is_value == b.is_value && a.places == b.places;
    }
    /// Returns the text, with each value as `written` gives it; by default as it is.
    std::string text(const std::function<std::string(const std::string&)>& written = {}) const;
};

/// A number with this many significant digits.
std::string in_digits(double number, int digits);

}  // namespace mq

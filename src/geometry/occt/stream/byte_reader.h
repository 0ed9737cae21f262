// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/error.h"

namespace mq::geometry {

/// Reads numbers in their order from bytes, the lowest byte first, never past their end.
/// Every function throws InvalidInput where the bytes end early, or are not what is expected.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <typename T>
    T get() {
        static_assert(std::is_arithmetic_v<T>);
        T value;
        std::memcpy(&value, taken(sizeof(T)).data(), sizeof(T));
        return value;
    }
    bool flag() { return get<char>() != 0; }

    template <std::size_t N>
    std::array<double, N> numbers() {
        std::array<double, N> values;
        std::memcpy(values.data(), taken(sizeof(values)).data(), sizeof(values));
        return values;
    }

    /// A count of what follows, each of at least this many bytes.
    int count(std::size_t least_bytes) { return checked(get<std::int32_t>(), least_bytes); }
    int checked(std::int64_t count, std::size_t least_bytes) const {
        if (count < 0 || static_cast<std::uint64_t>(count) > rest_.size() / least_bytes) {
            refuse("a count is larger than what follows");
        }
        return static_cast<int>(count);
    }

    std::string_view line() {
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) {
            refuse("a line does not end");
        }
        const std::string_view found = taken(end + 1);
        return found.substr(0, end);
    }

    /// The count in a line with this name, after what space there is.
    int section(std::string_view name) {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) {
            rest_.remove_prefix(1);
        }
        const std::string_view found = line();
        int value = 0;
        const char* const end = found.data() + found.size();
        const bool named = found.size() > name.size() && found.substr(0, name.size()) == name;
        if (!named || std::from_chars(found.data() + name.size() + 1, end, value).ptr != end) {
            refuse("the section " + std::string(name) + " is missing");
        }
        return checked(value, 1);
    }

    [[noreturn]] static void refuse(const std::string& why) {
        throw InvalidInput("the binary BREP of the shape cannot be read: " + why);
    }

  private:
    std::string_view taken(std::size_t size) {
        if (size > rest_.size()) {
            refuse("it ends early");
        }
        const std::string_view found = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return found;
    }

    std::string_view rest_;
};

/// An object of OpenCASCADE with these very bits. Its constructors scale directions to length 1 once more, which
/// changes last bits.
template <typename T, typename Bits>
T with_bits(const Bits& bits) {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_copyable_v<Bits> && sizeof(T) == sizeof(Bits));
    T object;
    std::memcpy(static_cast<void*>(&object), &bits, sizeof(T));
    return object;
}

template <typename T>
T read_bits(ByteReader& bytes) {
    return with_bits<T>(bytes.numbers<sizeof(T) / sizeof(double)>());
}

}  // namespace mq::geometry

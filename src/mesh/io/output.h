// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace mq::mesh {

/// The text that writers append to. It passes its content on in pieces that stay in the processor's cache: a file is
/// never in memory as a whole, and no byte is copied again because a text grows.
class Output {
  public:
    using Sink = std::function<void(const char* bytes, std::size_t count)>;

    explicit Output(Sink sink) : sink_(std::move(sink)), buffer_(new char[kSize]) {}

    Output& operator+=(char c) {
        *place(1) = c;
        ++used_;
        return *this;
    }
    Output& operator+=(std::string_view text) {
        append(text.data(), text.size());
        return *this;
    }

    void append(const char* bytes, std::size_t count) {
        if (count > kSize) {
            flush();
            handed_on_ += count;
            sink_(bytes, count);
            return;
        }
        std::memcpy(place(count), bytes, count);
        used_ += count;
    }

    void append(std::size_t count, char c) {
        std::memset(place(count), c, count);
        used_ += count;
    }

    /// Appends the shortest text that reads back as the same number.
    template <typename Number>
    void append_number(Number value) {
        char* first = place(kNumber);
        used_ += static_cast<std::size_t>(std::to_chars(first, first + kNumber, value).ptr - first);
    }

    /// Bytes that were appended.
    std::size_t size() const { return handed_on_ + used_; }

    /// Passes the remaining text on.
    void flush() {
        if (used_ > 0) {
            handed_on_ += used_;
            sink_(buffer_.get(), used_);
            used_ = 0;
        }
    }

  private:
    static constexpr std::size_t kSize = std::size_t{1} << 17;
    static constexpr std::size_t kNumber = 32;  ///< more characters than the shortest text of any number has

    /// Where the next bytes go, up to `count` of them.
    char* place(std::size_t count) {
        if (used_ + count > kSize) {
            flush();
        }
        return buffer_.get() + used_;
    }

    Sink sink_;
    std::unique_ptr<char[]> buffer_;
    std::size_t used_ = 0;
    std::size_t handed_on_ = 0;
};

/// The text that a writer appends for a mesh.
template <typename Mesh>
std::string text_of(void (*write)(Output&, const Mesh&), const Mesh& mesh) {
    std::string text;
    Output out([&](const char* bytes, std::size_t count) { text.append(bytes, count); });
    write(out, mesh);
    out.flush();
    return text;
}

}  // namespace mq::mesh

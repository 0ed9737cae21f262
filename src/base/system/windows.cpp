// SPDX-License-Identifier: LGPL-2.1-or-later
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <malloc.h>
#include <windows.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <new>

#include "base/system/system.h"

namespace mq {

namespace {

/// UTF-8 as UTF-16
std::wstring wide(const std::string& text) {
    const int bytes = static_cast<int>(text.size());
    std::wstring found(static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, nullptr, 0)),
                       L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), bytes, found.data(), static_cast<int>(found.size()));
    return found;
}

}  // namespace

double cpu_seconds() {
    FILETIME start{};
    FILETIME end{};
    FILETIME kernel{};
    FILETIME user{};
    GetProcessTimes(GetCurrentProcess(), &start, &end, &kernel, &user);
    double ticks = 0.0;  // a tick is 100 ns
    for (const FILETIME& t : {kernel, user}) {
        ticks += 4294967296.0 * t.dwHighDateTime + t.dwLowDateTime;
    }
    return 1e-7 * ticks;
}

void* allocate_block(std::size_t bytes) {
    void* const block = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
    if (block == nullptr) {
        throw std::bad_alloc();
    }
    return block;
}

void free_block(void* block, std::size_t /*bytes*/) noexcept {
    VirtualFree(block, 0, MEM_RELEASE);
}

void release_freed_memory() {
    _heapmin();
}

void at_fork(void (* /*before*/)(), void (* /*in_parent*/)(), void (* /*in_child*/)()) {}

void at_exit(void (* /*call*/)()) {}

void at_thread_end(void (* /*call*/)()) {}

void skip_destructors() {}

std::FILE* open_for_writing(const std::string& path) {
    return _wfopen(wide(path).c_str(), L"wb");
}

void* symbol_of_library(const std::string& path, const char* name) {
    HMODULE library = nullptr;
    return GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_PIN, wide(path).c_str(), &library) != 0
               ? reinterpret_cast<void*>(GetProcAddress(library, name))
               : nullptr;
}

}  // namespace mq

#ifdef __MINGW32__

namespace mq {

namespace {

struct Rounded {
    double value;
    double error;  // value + error is exact
};

Rounded two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The upper half of the bits (Veltkamp).
double upper(double a) {
    const double scaled = 134217729.0 * a;  // 2^27 + 1
    return scaled - (scaled - a);
}

Rounded two_product(double a, double b) {
    const double product = a * b;
    const double a_upper = upper(a);
    const double b_upper = upper(b);
    const double a_lower = a - a_upper;
    const double b_lower = b - b_upper;
    return {product, a_lower * b_lower - (((product - a_upper * b_upper) - a_lower * b_upper) - a_upper * b_lower)};
}

/// a + b rounded to odd: where it is not exact, to the neighbour whose last bit is 1.
double sum_to_odd(double a, double b) {
    const Rounded sum = two_sum(a, b);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &sum.value, sizeof(bits));
    if (sum.error == 0.0 || bits % 2 == 1) {
        return sum.value;
    }
    bits += (sum.error > 0.0) == (sum.value > 0.0) ? 1 : -1;
    double odd = 0.0;
    std::memcpy(&odd, &bits, sizeof(odd));
    return odd;
}

}  // namespace

}  // namespace mq

/// std::fma in the place of that of MinGW-w64 (10 at least), which rounds twice: expansions and double-doubles are
/// exact by it. For factors below 2^996, and where nothing over- or underflows. By Boldo and Melquiond, Emulation of
/// FMA and correctly rounded sums, IEEE Transactions on Computers 57 (2008), algorithm Fmac.
extern "C" double fma(double a, double b, double c) {
    const mq::Rounded product = mq::two_product(a, b);
    const mq::Rounded low = mq::two_sum(c, product.error);
    const mq::Rounded high = mq::two_sum(product.value, low.value);
    return high.value + mq::sum_to_odd(high.error, low.error);
}

#endif

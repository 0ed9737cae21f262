// SPDX-License-Identifier: LGPL-2.1-or-later
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <malloc.h>
#include <windows.h>

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
    double ticks = 0.0;  // of 100 ns
    for (const FILETIME& t : {kernel, user}) {
        ticks += 4294967296.0 * t.dwHighDateTime + t.dwLowDateTime;
    }
    return 1e-7 * ticks;
}

void* take_block(std::size_t bytes) {
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

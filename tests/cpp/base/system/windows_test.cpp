// SPDX-License-Identifier: LGPL-2.1-or-later
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <gtest/gtest.h>
#include <windows.h>

#include "base/system/system.h"

namespace mq {
namespace {

TEST(Windows, SymbolsOfLoadedLibrariesAreFound) {
    void* const found = symbol_of_library("kernel32.dll", "GetCurrentProcessId");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(reinterpret_cast<DWORD(WINAPI*)()>(found)(), GetCurrentProcessId());
    EXPECT_EQ(symbol_of_library("kernel32.dll", "NoSuchFunction"), nullptr);
    EXPECT_EQ(symbol_of_library("no_such_library.dll", "GetCurrentProcessId"), nullptr);
}

}  // namespace
}  // namespace mq

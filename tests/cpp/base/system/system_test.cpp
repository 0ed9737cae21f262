// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/system/system.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <new>

namespace mq {
namespace {

TEST(System, ABlockCanBeWrittenFromEndToEnd) {
    constexpr std::size_t kBytes = (std::size_t{1} << 24) + 4097;
    auto* block = static_cast<unsigned char*>(allocate_block(kBytes));
    block[0] = 1;
    block[kBytes - 1] = 2;
    EXPECT_EQ(block[0] + block[kBytes - 1], 3);
    free_block(block, kBytes);
    release_freed_memory();
}

TEST(System, ABlockThatNoMemoryHoldsIsRefused) {
    EXPECT_THROW(allocate_block(std::size_t{1} << 62), std::bad_alloc);
}

TEST(System, FilesAreWrittenByteByByteUnderAnyName) {
    const auto path = std::filesystem::temp_directory_path() / std::filesystem::u8path("meshquality größe 測試");
    std::FILE* file = open_for_writing(path.u8string());
    ASSERT_NE(file, nullptr);
    EXPECT_GE(std::fputs("a\nb\r\n", file), 0);
    EXPECT_EQ(std::fclose(file), 0);
    EXPECT_EQ(std::filesystem::file_size(path), 5U);
    std::filesystem::remove(path);
    EXPECT_EQ(open_for_writing((path / "none").u8string()), nullptr);
}

}  // namespace
}  // namespace mq

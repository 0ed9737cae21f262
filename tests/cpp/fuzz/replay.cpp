// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Runs a fuzz target on files, or on all files of folders, without libFuzzer:  replay_TARGET FILE|FOLDER ...
// Or on random bytes, by seeds, where there is no clang:  replay_TARGET --random FIRST LAST
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "bytes.h"

namespace {

using Path = std::filesystem::path;

std::vector<Path> files_of(const Path& path) {
    std::vector<Path> files;
    if (std::filesystem::is_directory(path)) {
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
    } else {
        files.push_back(path);
    }
    return files;
}

void replay(const Path& path) {
    // Printed before: a broken promise ends the program.
    std::printf("%s\n", path.string().c_str());
    std::fflush(stdout);
    std::ifstream stream(path, std::ios::binary);
    mq::fuzz::require(stream.good(), "the file can be read");
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// Small bytes are more frequent, as most counts and choices are.
std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
    constexpr int kLongest = 400;
    std::mt19937_64 engine(seed);
    std::vector<std::uint8_t> bytes(20 + engine() % kLongest);
    for (std::uint8_t& byte : bytes) {
        byte = static_cast<std::uint8_t>(engine() % (engine() % 3 == 0 ? 8 : 256));
    }
    return bytes;
}

int run_random(std::uint64_t first, std::uint64_t last) {
    for (std::uint64_t seed = first; seed < last; ++seed) {
        std::printf("\rseed %llu", static_cast<unsigned long long>(seed));
        std::fflush(stdout);
        const std::vector<std::uint8_t> bytes = random_bytes(seed);
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::printf("\n%llu inputs\n", static_cast<unsigned long long>(last - first));
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 4 && std::string(arguments[1]) == "--random") {
        return run_random(std::strtoull(arguments[2], nullptr, 10), std::strtoull(arguments[3], nullptr, 10));
    }
    std::size_t files = 0;
    for (int i = 1; i < count; ++i) {
        for (const Path& path : files_of(arguments[i])) {
            replay(path);
            ++files;
        }
    }
    std::printf("%zu inputs\n", files);
    return files > 0 ? 0 : 2;
}

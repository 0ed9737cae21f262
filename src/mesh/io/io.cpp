// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/error.h"
#include "mesh/edge_table.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

using Writer = std::string (*)(const TriangleMesh&);

/// The writers by file extension.
constexpr std::array<std::pair<const char*, Writer>, 6> kWriters{
    {{".stl", to_stl}, {".ply", to_ply}, {".obj", to_obj}, {".off", to_off}, {".msh", to_msh}, {".vtu", to_vtu}}};

std::string extension_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./\\");
    if (dot == std::string::npos || path[dot] != '.') {
        return "";
    }
    std::string extension = path.substr(dot);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

void save(const std::string& path, const std::string& bytes) {
    const auto fail = [&](const char* what) {
        throw IoError(std::string("cannot ") + what + " '" + path + "': " + std::strerror(errno));
    };
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
    if (!file) {
        fail("open");
    }
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
        fail("write to");
    }
    // A full disk may be reported only when the last buffer is written.
    if (std::fclose(file.release()) != 0) {
        fail("finish");
    }
}

}  // namespace

void write(const TriangleMesh& mesh, const std::string& path) {
    const std::string extension = extension_of(path);
    for (const auto& [name, writer] : kWriters) {
        if (extension == name) {
            require_valid(mesh);
            save(path, writer(mesh));
            return;
        }
    }
    throw IoError("cannot write '" + path + "': the extension must be .stl, .ply, .obj, .off, .msh or .vtu");
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/error.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

struct Format {
    const char* name;
    void (*write)(Output&, const ExportMesh&);
    int most_order;
};

/// The writers by extension. The first ones can do without patches.
constexpr std::size_t kPlain = 6;
constexpr std::array<Format, 17> kFormats{{{"stl", to_stl, 1},
                                           {"ply", to_ply, 1},
                                           {"obj", to_obj, 1},
                                           {"off", to_off, 1},
                                           {"msh", to_msh, 1},
                                           {"vtu", to_vtu, 1},
                                           {"3mf", to_3mf_model, 1},
                                           {"amf", to_amf, 1},
                                           {"tri", to_tri, 1},
                                           {"emesh", to_emesh, 1},
                                           {"fms", to_fms, 1},
                                           {"su2", to_su2, 1},
                                           {"nas", to_nastran, 2},
                                           {"bdf", to_nastran, 2},
                                           {"inp", to_abaqus, 2},
                                           {"unv", to_unv, 2},
                                           {"msh2", to_msh2, 5}}};

const Format* format_of(const std::string& name, std::size_t among) {
    const auto end = kFormats.begin() + static_cast<std::ptrdiff_t>(among);
    const auto found = std::find_if(kFormats.begin(), end, [&](const Format& format) { return name == format.name; });
    return found == end ? nullptr : &*found;
}

}  // namespace

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

void save(const std::string& path, const std::function<void(Output&)>& append) {
    const auto fail = [&](const char* what) {
        throw IoError(std::string("cannot ") + what + " '" + path + "': " + std::strerror(errno));
    };
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
    if (!file) {
        fail("open");
    }
    std::setvbuf(file.get(), nullptr, _IONBF, 0);  // Output has a buffer
    Output out([&](const char* bytes, std::size_t count) {
        if (std::fwrite(bytes, 1, count, file.get()) != count) {
            fail("write to");
        }
    });
    append(out);
    out.flush();
    // A full disk may be reported only when the file is closed.
    if (std::fclose(file.release()) != 0) {
        fail("finish");
    }
}

void write(const TriangleMesh& mesh, const std::string& path) {
    const std::string extension = extension_of(path);
    const Format* format = extension.empty() ? nullptr : format_of(extension.substr(1), kPlain);
    if (format == nullptr) {
        throw IoError("cannot write '" + path + "': the extension must be .stl, .ply, .obj, .off, .msh or .vtu");
    }
    const ExportMesh whole = exported(mesh);
    save(path, [&](Output& out) { format->write(out, whole); });
}

void write(const ExportMesh& mesh, const std::string& path, const std::string& format, bool ascii) {
    const Format* found = format_of(format, kFormats.size());
    if (found == nullptr) {
        throw IoError("cannot write '" + path + "': " + format + " is no format of meshes that is known here");
    }
    if (mesh.order > found->most_order) {
        throw InvalidInput("." + format + " files hold elements of an order up to " +
                           std::to_string(found->most_order) + ", not " + std::to_string(mesh.order) +
                           ": use .msh or .vtu");
    }
    const auto to_format = ascii && format == "stl" ? to_stl_text : found->write;
    save(path, [&](Output& out) { to_format(out, mesh); });
}

}  // namespace mq::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/system/system.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// The writer of a format, and the types of elements that it can write: those with a number or name in it.
struct Format {
    const char* name;
    void (*write)(Output&, const ExportMesh&);
    bool (*holds)(const ElementType&);
    int below = -1;  ///< how much lower dimensions of elements may be than the highest; -1: for triangulations alone
};

constexpr auto is_flat = [](const ElementType& type) { return type.kind == "triangle" && type.order == 1; };
constexpr auto is_straight = [](const ElementType& type) { return type.nodes == type.corners; };
constexpr auto has_gmsh = [](const ElementType& type) { return type.gmsh > 0; };
constexpr auto has_vtk = [](const ElementType& type) { return type.vtk > 0; };
constexpr auto has_unv = [](const ElementType& type) { return type.unv > 0; };
constexpr auto has_nastran = [](const ElementType& type) { return !type.nastran.empty(); };
constexpr auto has_abaqus = [](const ElementType& type) { return !type.abaqus.empty(); };

/// The writers by extension. The first kPlain ones do not need patches.
constexpr std::size_t kPlain = 6;
constexpr std::array<Format, 17> kFormats{{{"stl", to_stl, is_flat},
                                           {"ply", to_ply, is_flat},
                                           {"obj", to_obj, is_flat},
                                           {"off", to_off, is_flat},
                                           {"msh", to_msh, has_gmsh, 2},
                                           {"vtu", to_vtu, has_vtk, 2},
                                           {"3mf", to_3mf_mesh, is_flat},
                                           {"amf", to_amf, is_flat},
                                           {"tri", to_tri, is_flat},
                                           {"emesh", to_emesh, is_flat},
                                           {"fms", to_fms, is_flat},
                                           {"su2", to_su2, is_straight, 1},
                                           {"nas", to_nastran, has_nastran, 1},
                                           {"bdf", to_nastran, has_nastran, 1},
                                           {"inp", to_abaqus, has_abaqus, 0},
                                           {"unv", to_unv, has_unv, 2},
                                           {"msh2", to_msh2, has_gmsh, 2}}};

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
    const auto fail = [&](Phrase what) { throw IoError(what, {{"value", path}, {"text", std::strerror(errno)}}); };
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_for_writing(path), &std::fclose);
    if (!file) {
        fail(phrases::kOpening);
    }
    std::setvbuf(file.get(), nullptr, _IONBF, 0);  // Output has a buffer
    Output out([&](const char* bytes, std::size_t count) {
        if (std::fwrite(bytes, 1, count, file.get()) != count) {
            fail(phrases::kWriting);
        }
    });
    append(out);
    out.flush();
    // A full disk may be reported only when the file is closed.
    if (std::fclose(file.release()) != 0) {
        fail(phrases::kFinishing);
    }
}

void write(const TriangleMesh& mesh, const std::string& path) {
    const std::string extension = extension_of(path);
    const Format* format = extension.empty() ? nullptr : format_of(extension.substr(1), kPlain);
    if (format == nullptr) {
        throw IoError(phrases::kFileEndings, {{"value", path}});
    }
    const ExportMesh whole = exported(mesh);
    save(path, [&](Output& out) { format->write(out, whole); });
}

std::vector<ElementFormat> element_formats() {
    std::vector<ElementFormat> found;
    for (const Format& format : kFormats) {
        if (format.below >= 0) {
            ElementFormat& of_elements = found.emplace_back(ElementFormat{format.name, format.below, {}});
            for (const ElementType& type : element_types()) {
                if (format.holds(type)) {
                    of_elements.types.push_back(&type);
                }
            }
        }
    }
    return found;
}

void write(const ExportMesh& mesh, const std::string& path, const std::string& format, bool ascii) {
    const Format* found = format_of(format, kFormats.size());
    if (found == nullptr) {
        throw IoError(phrases::kFileFormat, {{"value", path}, {"value2", format}});
    }
    for (const auto& [block, first] : mesh.numbered(mesh.lowest(std::max(found->below, 0)))) {
        if (!found->holds(*block->type)) {
            throw InvalidInput(
                phrases::kFileElements,
                {{"value", "." + format}, {"kind", std::string(block->type->kind)}, {"count", block->type->order}});
        }
    }
    const auto to_format = ascii && format == "stl" ? to_stl_text : found->write;
    save(path, [&](Output& out) { to_format(out, mesh); });
}

}  // namespace mq::mesh

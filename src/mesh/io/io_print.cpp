// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// The numbers of the file; single-precision numbers have as few digits as they need.
class Numbers {
  public:
    explicit Numbers(const ExportMesh& mesh) : single_(fits_single_precision(mesh)) {}

    void append(Output& out, double value) const {
        if (single_) {
            out.append_number(static_cast<float>(value));
        } else {
            out.append_number(value);
        }
    }

  private:
    bool single_;
};

/// The unit of scaled coordinates, which formats for printing name.
std::string unit_of(double scale) {
    constexpr std::array<std::pair<double, const char*>, 3> kUnits{
        {{0.001, "meter"}, {0.1, "centimeter"}, {1.0 / 25.4, "inch"}}};
    for (const auto& [factor, name] : kUnits) {
        if (std::abs(scale / factor - 1.0) < 1e-6) {
            return name;
        }
    }
    return "millimeter";
}

std::string shortest(float value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

void to_3mf_mesh(Output& out, const ExportMesh& mesh) {
    const Numbers numbers(mesh);
    out += "<mesh>\n<vertices>\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3 p = mesh.point(i);
        out += "<vertex x=\"";
        numbers.append(out, p.x());
        out += "\" y=\"";
        numbers.append(out, p.y());
        out += "\" z=\"";
        numbers.append(out, p.z());
        out += "\"/>\n";
    }
    out += "</vertices>\n<triangles>\n";
    constexpr std::array<const char*, 3> kCorners{"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            out += kCorners[i];
            out.append_number(static_cast<long long>(mesh.triangles().of(k)[i]));
        }
        if (mesh.patches_given) {
            out += "\" pid=\"1\" p1=\"";
            out.append_number(static_cast<long long>(mesh.triangles().group[k]));
        }
        out += "\"/>\n";
    }
    out += "</triangles>\n</mesh>\n";
}

void to_amf(Output& out, const ExportMesh& mesh) {
    const Numbers numbers(mesh);
    out += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf unit=\"" + unit_of(mesh.scale) +
           "\" version=\"1.1\">\n<metadata type=\"cad\">MeshQuality</metadata>\n<object id=\"1\">\n<mesh>\n"
           "<vertices>\n";
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3 p = mesh.point(i);
        out += "<vertex><coordinates><x>";
        numbers.append(out, p.x());
        out += "</x><y>";
        numbers.append(out, p.y());
        out += "</y><z>";
        numbers.append(out, p.z());
        out += "</z></coordinates></vertex>\n";
    }
    out += "</vertices>\n<volume>\n";
    std::vector<std::string> colours;
    for (const Group& patch : mesh.patches()) {
        std::string& text = colours.emplace_back("<color>");
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string name(1, "rgb"[i]);
            text += "<" + name + ">";
            text += shortest(patch.colour[i] / 255.0F);
            text += "</" + name + ">";
        }
        text += "</color>";
    }
    constexpr std::array<const char*, 3> kCorners{"<v1>", "</v1><v2>", "</v2><v3>"};
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        out += "<triangle>";
        if (mesh.patches_given) {
            out += colours[static_cast<std::size_t>(mesh.triangles().group[k])];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            out += kCorners[i];
            out.append_number(static_cast<long long>(mesh.triangles().of(k)[i]));
        }
        out += "</v3></triangle>\n";
    }
    out += "</volume>\n</mesh>\n</object>\n</amf>\n";
}

}  // namespace mq::mesh

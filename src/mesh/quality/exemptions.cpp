// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exemptions.h"

#include <algorithm>
#include <unordered_map>

#include "mesh/quality/triangle_quality.h"

namespace mq::mesh {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Replaces every number, with its fraction, by one '#'.
std::string without_numbers(const std::string& reason) {
    std::string text;
    for (std::size_t i = 0; i < reason.size();) {
        if (!is_digit(reason[i])) {
            text += reason[i++];
            continue;
        }
        while (i < reason.size() && (is_digit(reason[i]) || (reason[i] == '.' && is_digit(reason[i + 1])))) {
            ++i;
        }
        text += '#';
    }
    return text;
}

/// "Face12" of a reason that ends with "on Face12"; empty when it names no face.
std::string face_of(const std::string& reason) {
    const std::size_t start = reason.rfind("Face");
    if (start == std::string::npos) {
        return "";
    }
    const auto end = std::find_if_not(reason.begin() + static_cast<std::ptrdiff_t>(start) + 4, reason.end(), is_digit);
    return std::string(reason.begin() + static_cast<std::ptrdiff_t>(start), end);
}

std::string list_of(const std::vector<std::string>& names) {
    // Names listed at most; a message should stay on a few lines.
    constexpr std::size_t kShown = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) {
        text += (i > 0 ? ", " : "") + names[i];
    }
    return names.size() > kShown ? text + " and " + std::to_string(names.size() - kShown) + " more" : text;
}

}  // namespace

void set_exempt(const TriangleMesh& mesh, std::vector<std::pair<std::int32_t, std::string>> exempt,
                MeshReport& report) {
    std::vector<char> listed(mesh.triangles.size(), 0);
    for (const auto& [triangle, why] : exempt) {
        listed[static_cast<std::size_t>(triangle)] = 1;
    }
    report.exempt = std::move(exempt);
    report.min_angle_unexempted = 180.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& v = mesh.triangles[t];
        if (listed[t] == 0) {
            const TriangleShape shape = shape_of({mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]});
            report.min_angle_unexempted = std::min(report.min_angle_unexempted, shape.min_angle);
        }
    }
}

std::vector<ExemptCause> exempt_causes(const MeshReport& report) {
    std::vector<ExemptCause> causes;
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < report.exempt.size(); ++i) {
        const std::string& reason = report.exempt[i].second;
        const auto [found, fresh] = known.emplace(without_numbers(reason), causes.size());
        if (fresh) {
            causes.push_back({found->first, 0, i, {}});
        }
        ExemptCause& cause = causes[found->second];
        ++cause.count;
        const std::string face = face_of(reason);
        if (!face.empty() && std::find(cause.faces.begin(), cause.faces.end(), face) == cause.faces.end()) {
            cause.faces.push_back(face);
        }
    }
    std::stable_sort(causes.begin(), causes.end(),
                     [](const ExemptCause& a, const ExemptCause& b) { return a.count > b.count; });
    return causes;
}

std::string exemptions_text(const MeshReport& report) {
    std::string text;
    for (const ExemptCause& cause : exempt_causes(report)) {
        const auto& [triangle, reason] = report.exempt[cause.first];
        const std::string example = "triangle " + std::to_string(triangle) + ": " + reason + "\n";
        if (cause.count == 1) {
            text += "  1 triangle below the limit: " + example;
        } else {
            text += "  " + counted(cause.count, "triangle") + " below the limit, same cause, e.g. " + example;
            text += cause.faces.size() < 2 ? "" : "    on " + list_of(cause.faces) + "\n";
        }
    }
    return text;
}

}  // namespace mq::mesh

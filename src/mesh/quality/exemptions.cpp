// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exemptions.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/quality/triangle_quality.h"

namespace mq::mesh {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// A value of a reason with '#' for its number: "#" of "7.25", "Edge#" of "Edge12".
std::string without_number(const std::string& value) {
    return std::string(value.begin(), std::find_if(value.begin(), value.end(), is_digit)) + "#";
}

}  // namespace

Message list_of(const std::vector<Message>& all) {
    // Messages listed at most: all kinds of repairs, but few enough to stay on a few lines.
    constexpr std::size_t kShown = 9;
    Message shown;
    for (std::size_t i = 0; i < std::min(all.size(), kShown); ++i) {
        const std::string place = "phrase" + std::to_string(i);
        shown.phrase += (i > 0 ? ", {" : "{") + place + "}";
        shown.places.emplace_back(place.c_str(), all[i]);
    }
    return all.size() > kShown ? Message(phrases::kAndMore, {{"list", shown}, {"count", all.size() - kShown}}) : shown;
}

Message list_of(const std::vector<std::string>& names) {
    std::vector<Message> all;
    std::transform(names.begin(), names.end(), std::back_inserter(all), Message::value);
    return list_of(all);
}

void set_exempt(const TriangleMesh& mesh, std::vector<std::pair<std::int32_t, ExemptReason>> exempt,
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

std::vector<SameCause> exempt_causes(const MeshReport& report) {
    std::vector<SameCause> causes;
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < report.exempt.size(); ++i) {
        const ExemptReason& reason = report.exempt[i].second;
        const auto [found, fresh] = known.emplace(message_of(reason).text(without_number), causes.size());
        if (fresh) {
            causes.push_back({found->first, 0, i, {}});
        }
        SameCause& cause = causes[found->second];
        ++cause.count;
        const std::string face = reason.face.dimension < 0 ? "" : name_of(reason.face).text();
        if (!face.empty() && std::find(cause.faces.begin(), cause.faces.end(), face) == cause.faces.end()) {
            cause.faces.push_back(face);
        }
    }
    std::stable_sort(causes.begin(), causes.end(),
                     [](const SameCause& a, const SameCause& b) { return a.count > b.count; });
    return causes;
}

std::string exemptions_text(const MeshReport& report) {
    std::string text;
    for (const SameCause& cause : exempt_causes(report)) {
        const auto& [triangle, reason] = report.exempt[cause.first];
        const std::string example = "triangle " + std::to_string(triangle) + ": " + message_of(reason).text() + "\n";
        if (cause.count == 1) {
            text += "  1 triangle below the limit: " + example;
        } else {
            text += "  " + counted(cause.count, "triangle") + " below the limit, same cause, e.g. " + example;
            text += cause.faces.size() < 2 ? "" : "    on " + list_of(cause.faces).text() + "\n";
        }
    }
    return text;
}

}  // namespace mq::mesh

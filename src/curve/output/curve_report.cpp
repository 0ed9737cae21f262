// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>

#include "curve/output/curved_mesh.h"

namespace mq::curve {

double CurveReport::volume_error() const {
    return cad_volume > 0.0 ? std::abs(volume - cad_volume) / cad_volume : -1.0;
}

std::string to_text(const CurveReport& report) {
    char text[512];
    std::snprintf(text, sizeof text,
                  "%zu elements, %zu vertices, %zu invalid (%zu before repair)\n"
                  "min J / J straight %.3f, min J / max J %.3f (mean %.3f), shape distortion at most %.3f\n"
                  "deviation from the shape at most %.3g mm, rms %.3g mm; %zu vertices moved\n",
                  report.elements, report.vertices, report.invalid, report.invalid_before, report.min_scaled_jacobian,
                  report.min_distortion, report.mean_distortion, report.max_shape_distortion, report.max_deviation,
                  report.rms_deviation, report.moved_vertices);
    std::string result = text;
    if (report.straight.triangles > 0) {
        std::snprintf(text, sizeof text,
                      "before curving: smallest angle %.3f (requested %.3f); largest deviation requested %.3g mm\n",
                      report.straight.min_angle, report.straight.min_angle_asked, report.chord_height_asked);
        result += text;
    }
    if (report.size_ratio >= 0.0) {
        std::snprintf(text, sizeof text,
                      "edges at most %.3f of the size field, at (%.6g, %.6g, %.6g); %.1f %% below half of it\n",
                      report.size_ratio, report.size_ratio_point.x(), report.size_ratio_point.y(),
                      report.size_ratio_point.z(), 100.0 * report.short_share);
        result += text;
    }
    if (report.volume_error() >= 0.0) {
        std::snprintf(text, sizeof text, "volume deviates from that of the shape by a fraction of %.3g\n",
                      report.volume_error());
        result += text;
    }
    if (report.curved_intersections >= 0) {
        result += "pairs of curved triangles that cross: " + std::to_string(report.curved_intersections) +
                  ", not proven apart: " + std::to_string(report.not_proven_apart) + "\n";
    }
    for (const auto& [operation, count] : report.repairs) {
        if (count > 0) {
            result += operation + ": " + std::to_string(count) + "\n";
        }
    }
    for (const std::string& element : report.invalid_elements) {
        result += "invalid: " + element + "\n";
    }
    for (const std::string& element : report.straightened) {
        result += "made straight: " + element + "\n";
    }
    for (const Message& note : report.notes) {
        result += note.text() + "\n";
    }
    for (const auto& [stage, seconds] : report.seconds) {
        std::snprintf(text, sizeof text, "%-24s %.3f s\n", stage.c_str(), seconds);
        result += text;
    }
    return result;
}

}  // namespace mq::curve

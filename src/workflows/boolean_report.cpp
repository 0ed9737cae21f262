// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/boolean_report.h"

#include <array>
#include <cstdio>

namespace mq::workflows {

std::string to_text(const BooleanReport& report) {
    std::string text = mesh::to_text(report);
    const auto number = [](double value) {
        std::array<char, 32> buffer;
        return std::string(buffer.data(), std::snprintf(buffer.data(), buffer.size(), "%.6g", value));
    };
    if (report.method != "exact") {
        text += "method       " + report.method + "\n";
    }
    if (report.guessed_share > 0.0) {
        text += "guessed      " + number(100.0 * report.guessed_share) + " % of the surface, where operands are open\n";
    }
    text += "retained     " + std::to_string(report.retained) + " triangles of the operands, bit for bit; " +
            std::to_string(report.reconstructed) + " made or changed\n";
    text += "deviation    " + number(report.error_bound) + " mm; requested at most " + number(report.tolerance_asked) +
            " mm\n";
    if (report.fitted_vertices + report.unfitted_vertices > 0) {
        text += "on surfaces  " + std::to_string(report.fitted_vertices) + " vertices put there, " +
                std::to_string(report.unfitted_vertices) + " left on the meshes of the shapes\n";
    }
    for (std::size_t k = 0; k < report.operands.size(); ++k) {
        text += (k == 0 ? "operands     " : "             ") +
                mesh::counted(report.operands[k].components, "component") + ", Euler number " +
                std::to_string(report.operands[k].euler) + "\n";
    }
    for (const Message& sentence : report.repaired) {
        text += "repaired     " + sentence.text() + "\n";
    }
    return text;
}

std::string in_short(const BooleanReport& report) {
    std::array<char, 80> bound;
    std::snprintf(bound.data(), bound.size(), ", max. deviation %.3g mm of %.3g mm", report.error_bound,
                  report.tolerance_asked);
    return mesh::in_short(report) + bound.data();
}

bool met(const BooleanReport& report) {
    return !mesh::has_faults(report) && report.error_bound <= report.tolerance_asked && report.faults_left == 0;
}

}  // namespace mq::workflows

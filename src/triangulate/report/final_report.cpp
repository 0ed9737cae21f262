// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/final_report.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/message.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/quality/exemptions.h"
#include "triangulate/measure/self_intersections.h"
#include "triangulate/report/body_overlaps.h"
#include "triangulate/report/exemption.h"
#include "triangulate/report/solid_contacts.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

/// Angles of neighbouring triangles.
struct Angles {
    double least = 180.0;                                  ///< degrees, of triangles without exemptions
    std::vector<std::pair<std::size_t, Exemption>> below;  ///< exempted triangles below the bound, by output triangle
};

/// `bound` in degrees.
Angles angles_of(const Workspace& work, const Output& out, double bound, std::size_t first, std::size_t last) {
    Angles angles;
    double beyond = 2.0;  // squared sine: larger angles are neither below the bound nor the smallest found
    for (std::size_t i = first; i < last; ++i) {
        const int t = out.source[i];
        if (squared_sine_of_smallest_angle(work.mesh, t) > beyond) {
            continue;
        }
        const double angle = smallest_angle(work.mesh, t).angle / kDegree;
        static constexpr Exemption kUnfinished{Cause::Budget, -1, -1, 0};
        const Exemption* exemption = work.exemption_of(t);
        if (exemption == nullptr && work.over_budget()) {
            exemption = &kUnfinished;
        }
        if (angle < bound && exemption != nullptr) {
            angles.below.emplace_back(i, *exemption);
        } else {
            angles.least = std::min(angles.least, angle);
            beyond = sine_squared_above(std::max(angles.least, bound) * kDegree);
        }
    }
    return angles;
}

void report_exemptions(const Workspace& work, const Output& out, JoinedCorners& joined, double bound,
                       mesh::MeshReport& report) {
    constexpr std::size_t kBlock = 8192;  // triangles, measured in about half a millisecond
    std::vector<Angles> blocks((out.source.size() + kBlock - 1) / kBlock);
    parallel_for(static_cast<int>(blocks.size()), [&](int k) {
        work.progress.check();
        const std::size_t first = kBlock * static_cast<std::size_t>(k);
        blocks[static_cast<std::size_t>(k)] =
            angles_of(work, out, bound, first, std::min(first + kBlock, out.source.size()));
    });
    report.min_angle_unexempted = 180.0;
    InfeasibleCorner forces(work, bound * kDegree);
    CancelPace pace(work.progress);
    for (const Angles& angles : blocks) {
        report.min_angle_unexempted = std::min(report.min_angle_unexempted, angles.least);
        for (const auto& [triangle, exemption] : angles.below) {
            pace.step();
            report.exempt.emplace_back(
                static_cast<std::int32_t>(triangle),
                explain(work, {forces, joined}, out.source[triangle], exemption, bound * kDegree));
        }
    }
}

void report_spanning(const Workspace& work, const Output& out, mesh::MeshReport& report) {
    for (std::size_t i = 0; i < out.source.size(); ++i) {
        const auto found = work.spanning.find(out.source[i]);
        if (found == work.spanning.end() || found->second.faces.size() < 2) {
            continue;
        }
        std::vector<std::string> names;
        for (const int face : found->second.faces) {
            const std::string name = work.session.topology().name_of({2, face});
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
        if (names.size() < 2) {
            continue;  // pieces of one face
        }
        std::string text = "spans ";
        for (std::size_t k = 0; k < names.size(); ++k) {
            text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
        }
        report.spanning.emplace_back(static_cast<std::int32_t>(i), std::move(text));
    }
}

void report_chord_height(const Workspace& work, const MaxChordError& worst, const Output& out, bool keeps_bounds,
                         mesh::MeshReport& report) {
    const double asked = report.chord_height_asked;
    report.max_chord_height = worst.distance;
    const auto found = std::find(out.source.begin(), out.source.end(), worst.triangle);
    if (found == out.source.end()) {
        return;
    }
    report.max_chord_triangle = static_cast<std::int32_t>(found - out.source.begin());
    report.max_chord_point = worst.point;
    if (asked > 0.0 && worst.distance > asked) {
        const std::string face = work.session.topology().name_of({2, work.mesh.face_of(worst.triangle)});
        report.notes.push_back({phrases::kDeviates,
                                {{"length", in_mm(worst.distance, 3)},
                                 {"length2", in_mm(asked, 3)},
                                 {"phrase", !keeps_bounds        ? phrases::kSamplesDecide
                                            : worst.of_the_shape ? Message(phrases::kEdgesDeviate, {{"name", face}})
                                                                 : phrases::kEdgesNotSplit}}});
    }
}

Message sentence_of(const mesh::BodyOverlap& found) {
    const auto phrase = [&] {
        switch (found.kind) {
            case mesh::BodyOverlap::Kind::Inside:
                return phrases::kLiesInside;
            case mesh::BodyOverlap::Kind::Equal:
                return phrases::kOneBodyTwice;
            case mesh::BodyOverlap::Kind::Near:
                return phrases::kCrossWhereNear;
            default:
                return phrases::kOverlap;
        }
    };
    return {phrase(), {{"name", found.bodies[0]}, {"name2", found.bodies[1]}}};
}

// Solids of a shape are to be apart, or to touch. Where solids touch, their chords cross unless they are imprinted.
void report_bodies(const Workspace& work, MeasurementCache& findings, const Output& out, mesh::MeshReport& report) {
    const double deviation = std::max({report.max_chord_height, report.chord_height_asked, 0.0});
    const std::vector<FaceContact>& contacts = findings.bodies.find(deviation);
    const SelfIntersections& finder = findings.crossings;
    std::size_t touching = 0;
    report.overlaps = 0;
    for (const FaceContact& contact : contacts) {
        if (contact.worst() == BodyContact::Touching) {
            touching += static_cast<std::size_t>(
                std::count_if(contact.pairs.begin(), contact.pairs.end(),
                              [&](const auto& pair) { return finder.depth(pair) > work.grid.resolution(); }));
        } else {
            report.overlaps += static_cast<std::int64_t>(contact.pairs.size());
        }
    }
    report.overlapping_bodies = body_overlaps(work, contacts, out, deviation);
    std::vector<Message> said;
    for (const mesh::BodyOverlap& found : report.overlapping_bodies) {
        said.push_back(sentence_of(found));
    }
    if (!said.empty()) {
        report.notes.push_back({phrases::kBodiesOverlap, {{"list", mesh::list_of(said)}}});
    }
    if (touching > 0) {
        report.notes.push_back(counted(phrases::kBodiesTouch, touching));
    }
}

// Faces that belong to no solid or shell are meant to form one surface.
void report_crossings(const Workspace& work, MeasurementCache& findings, const Output& out, mesh::MeshReport& report) {
    SelfIntersections& finder = findings.crossings;
    const geometry::Topology& topology = work.session.topology();
    std::vector<std::array<int, 2>> faults = finder.pairs();
    const std::vector<std::array<int, 2>> loose = finder.deep_loose_pairs(report.max_chord_height);
    faults.insert(faults.end(), loose.begin(), loose.end());
    report_bodies(work, findings, out, report);
    if (finder.incomplete()) {
        report.notes.emplace_back(phrases::kManyMeet);
    }
    report.self_intersections = 0;
    for (const auto& [faces, count] : finder.by_faces(faults)) {
        report.self_intersections += static_cast<std::int64_t>(count);
        report.crossings.push_back(
            {{topology.of_shape({2, faces.first}).index, topology.of_shape({2, faces.second}).index}, count});
        const bool same = topology.of_shape({2, faces.first}) == topology.of_shape({2, faces.second});
        report.notes.push_back(
            counted(same ? phrases::kCrossesItself : phrases::kFacesCross, count,
                    {{"name", topology.name_of({2, faces.first})}, {"name2", topology.name_of({2, faces.second})}}));
    }
}

}  // namespace

MaxChordError measure_against_part(Workspace& work, MeasurementCache& findings, double chord) {
    const MaxChordError farthest = measure_chord_height(work, findings.chords, chord);
    if (!work.over_budget()) {
        findings.crossings.pairs();
    }
    return farthest;
}

mesh::MeshReport final_report(const Workspace& work, MeasurementCache& findings, const MaxChordError& farthest,
                              const Output& out, JoinedCorners& joined, const TriangulateOptions& options,
                              double chord) {
    mesh::MeshReport report = mesh::measure(out.mesh, &work.progress);
    report.min_angle_asked = options.keeps_bounds() ? options.min_angle : 0.0;
    report.chord_height_asked = chord;
    report.detail = work.session.topology().detail;
    report.imprinted = work.session.topology().imprinted;
    report.contacts = solid_contacts(out.mesh);
    report.sewn = work.session.topology().sewn;
    report.cut_corners = work.session.topology().cut_corners.size();
    report.cut_pinches = work.session.topology().corner_cuts == geometry::CornerCuts::Infeasible;
    report_exemptions(work, out, joined, report.min_angle_asked, report);
    report_spanning(work, out, report);
    for (const std::string& fault : work.session.topology().faults) {
        report.notes.push_back(Message::value(fault));
    }
    report_chord_height(work, farthest, out, options.keeps_bounds(), report);
    if (!work.over_budget()) {
        report_crossings(work, findings, out, report);
    }
    report.complete = !work.over_budget();
    if (work.left_by_mending > 0) {
        report.notes.push_back(counted(phrases::kMendingEnded, work.left_by_mending));
    }
    if (work.over_budget()) {
        report.notes.push_back({work.triangles() > work.budget ? phrases::kCoarsestAboveLimit : phrases::kStopped,
                                {{"count", work.budget}}});
    }
    return report;
}

}  // namespace mq::triangulate

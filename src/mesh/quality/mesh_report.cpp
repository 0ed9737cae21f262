// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/mesh_report.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/memory/large_vector.h"
#include "base/parallel.h"
#include "base/predicates.h"
#include "mesh/edge_table.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/triangle_quality.h"

namespace mq::mesh {

namespace {

using Sets = DisjointSets<std::uint32_t>;

/// Sums and extremes over the shapes of neighbouring triangles.
struct Shapes {
    std::size_t degenerate = 0;
    double min_angle = 180.0;
    double max_angle = 0.0;
    double max_aspect = 0.0;
    double sum_of_min_angles = 0.0;
    double area = 0.0;
    std::array<std::size_t, std::tuple_size<decltype(MeshReport::angle_histogram)>::value> histogram{};

    void add(const TriangleShape& shape) {
        degenerate += shape.degenerate;
        min_angle = std::min(min_angle, shape.min_angle);
        max_angle = std::max(max_angle, shape.max_angle);
        max_aspect = std::max(max_aspect, shape.aspect);
        ++histogram[std::min(static_cast<std::size_t>(shape.min_angle), histogram.size() - 1)];
        sum_of_min_angles += shape.min_angle;
        area += shape.area;
    }
    void add(const Shapes& other) {
        degenerate += other.degenerate;
        min_angle = std::min(min_angle, other.min_angle);
        max_angle = std::max(max_angle, other.max_angle);
        max_aspect = std::max(max_aspect, other.max_aspect);
        for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
            histogram[bin] += other.histogram[bin];
        }
        sum_of_min_angles += other.sum_of_min_angles;
        area += other.area;
    }
};

/// Adds up in blocks, whatever the number of threads: it does not change how sums are rounded.
Shapes shapes_of(const TriangleMesh& mesh, const Progress* progress) {
    constexpr std::size_t kBlock = 4096;  // triangles, measured in about half a millisecond
    const std::size_t count = mesh.triangles.size();
    std::vector<Shapes> blocks((count + kBlock - 1) / kBlock);
    parallel_for(static_cast<int>(blocks.size()), [&](int k) {
        check_cancelled(progress);
        Shapes shapes;
        const std::size_t first = kBlock * static_cast<std::size_t>(k);
        for (std::size_t i = first; i < std::min(first + kBlock, count); ++i) {
            const Triangle& t = mesh.triangles[i];
            shapes.add(shape_of({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}));
        }
        blocks[static_cast<std::size_t>(k)] = shapes;
    });
    Shapes all;
    for (const Shapes& block : blocks) {
        all.add(block);
    }
    return all;
}

void measure_shapes(const TriangleMesh& mesh, MeshReport& report, const Progress* progress) {
    const Shapes shapes = shapes_of(mesh, progress);
    const bool empty = mesh.triangles.empty();
    report.degenerate_triangles = shapes.degenerate;
    report.min_angle = empty ? 0.0 : shapes.min_angle;
    report.max_angle = shapes.max_angle;
    report.max_aspect = shapes.max_aspect;
    report.angle_histogram = shapes.histogram;
    report.mean_min_angle = empty ? 0.0 : shapes.sum_of_min_angles / static_cast<double>(mesh.triangles.size());
    report.area = shapes.area;
    report.min_angle_unexempted = report.min_angle;
}

/// Triangles of one edge that also share their third vertex. Counted at the edge of their two lowest vertices only,
/// so that each pair is met once.
std::size_t duplicates_at(const TriangleMesh& mesh, std::int32_t high, const std::uint32_t* first,
                          const std::uint32_t* last, std::vector<std::int32_t>& opposite) {
    opposite.clear();
    for (const std::uint32_t* corner = first; corner != last; ++corner) {
        const std::int32_t v = mesh.triangles[*corner / 3][(*corner % 3 + 2) % 3];
        if (v > high) {
            opposite.push_back(v);
        }
    }
    std::sort(opposite.begin(), opposite.end());
    const auto end = std::unique(opposite.begin(), opposite.end());
    return static_cast<std::size_t>(opposite.end() - end);
}

/// Unites the corners of one vertex that belong to triangles joined across an edge: they form one fan.
void unite_fans(const TriangleMesh& mesh, std::int32_t low, const std::uint32_t* first, const std::uint32_t* last,
                Sets& fans) {
    const auto at = [&](std::uint32_t corner, bool at_low) {
        const bool starts_low = mesh.triangles[corner / 3][corner % 3] == low;
        return starts_low == at_low ? corner : corner / 3 * 3 + (corner % 3 + 1) % 3;
    };
    for (const std::uint32_t* corner = first + 1; corner < last; ++corner) {
        fans.unite(at(*first, true), at(*corner, true));
        fans.unite(at(*first, false), at(*corner, false));
    }
}

void measure_fans(const TriangleMesh& mesh, std::size_t edges, Sets& fans, Sets& bodies, MeshReport& report) {
    LargeVector<std::uint8_t> fans_at(mesh.vertices.size(), 0);
    long faces = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (is_collapsed(mesh.triangles[k])) {
            continue;
        }
        ++faces;
        report.components += bodies.find(static_cast<std::uint32_t>(k)) == k;
        for (std::size_t corner = 3 * k; corner < 3 * k + 3; ++corner) {
            if (fans.find(static_cast<std::uint32_t>(corner)) == corner) {
                std::uint8_t& n = fans_at[mesh.triangles[k][corner - 3 * k]];
                n = static_cast<std::uint8_t>(std::min(n + 1, 2));
            }
        }
    }
    report.pinched_vertices = static_cast<std::size_t>(std::count(fans_at.begin(), fans_at.end(), 2));
    const long used = static_cast<long>(fans_at.size()) - std::count(fans_at.begin(), fans_at.end(), 0);
    report.euler = used - static_cast<long>(edges) + faces;
}

/// By triangle.
LargeVector<double> squared_longest_edges(const TriangleMesh& mesh) {
    LargeVector<double> longest;
    longest.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3& b = mesh.vertices[t[1]];
        const Vec3& c = mesh.vertices[t[2]];
        longest.push_back(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    }
    return longest;
}

/// Largest ratio of the longest edges of triangles that share an edge, squared.
double squared_stretching(const LargeVector<double>& longest, const std::uint32_t* first, const std::uint32_t* last) {
    const auto [least, most] = std::minmax_element(
        first, last, [&](std::uint32_t a, std::uint32_t b) { return longest[a / 3] < longest[b / 3]; });
    return longest[*most / 3] / longest[*least / 3];
}

void measure_topology(const TriangleMesh& mesh, MeshReport& report, const Progress* progress) {
    CancelPace pace(progress);
    const EdgeTable table(mesh.triangles, mesh.vertices.size());
    check_cancelled(progress);
    Sets fans(3 * mesh.triangles.size());
    Sets bodies(mesh.triangles.size());
    std::vector<std::int32_t> opposite;
    LargeVector<std::uint32_t> degrees(mesh.vertices.size(), 0);
    const LargeVector<double> longest = squared_longest_edges(mesh);
    double stretching = 0.0;
    std::size_t edges = 0;
    table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        ++edges;
        report.max_degree = std::max<std::size_t>({report.max_degree, ++degrees[low], ++degrees[high]});
        pace.step();
        const auto count = last - first;
        if (count == 1) {
            ++report.border_edges;
            return;
        }
        const auto forward =
            std::count_if(first, last, [&](std::uint32_t c) { return mesh.triangles[c / 3][c % 3] == low; });
        stretching = std::max(stretching, squared_stretching(longest, first, last));
        report.nonmanifold_edges += count > 2;
        report.misoriented_edges += count != 2 || forward != 1;
        report.duplicate_triangles += duplicates_at(mesh, high, first, last, opposite);
        for (const std::uint32_t* corner = first + 1; corner < last; ++corner) {
            bodies.unite(*first / 3, *corner / 3);
        }
        unite_fans(mesh, low, first, last, fans);
    });
    report.max_stretching = std::sqrt(stretching);
    check_cancelled(progress);
    measure_fans(mesh, edges, fans, bodies, report);
}

/// The volume by the divergence theorem, about a corner of the box to keep the terms small.
double signed_volume(const TriangleMesh& mesh, const Vec3& reference) {
    double six = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[t[0]] - reference;
        const Vec3 b = mesh.vertices[t[1]] - reference;
        const Vec3 c = mesh.vertices[t[2]] - reference;
        six += a.dot(b.cross(c));
    }
    return six / 6.0;
}

template <typename... Values>
std::string line(const char* format, Values... values) {
    std::array<char, 512> buffer;
    const int length = std::snprintf(buffer.data(), buffer.size(), format, values...);
    return std::string(buffer.data(), std::min<std::size_t>(length, buffer.size() - 1)) + "\n";
}

std::string faults_text(const MeshReport& r) {
    std::string text;
    const auto fault = [&](std::size_t count, const char* what) {
        if (count > 0) {
            text += (text.empty() ? "" : ", ") + counted(count, what);
        }
    };
    fault(r.border_edges, "open edge");
    fault(r.nonmanifold_edges, "non-manifold edge");
    fault(r.misoriented_edges, "inconsistently oriented edge");
    if (r.pinched_vertices > 0) {
        const char* what = r.pinched_vertices == 1 ? " pinched vertex" : " pinched vertices";
        text += (text.empty() ? "" : ", ") + std::to_string(r.pinched_vertices) + what;
    }
    fault(r.degenerate_triangles, "degenerate triangle");
    fault(r.duplicate_triangles, "duplicate triangle");
    fault(r.self_intersections > 0 ? static_cast<std::size_t>(r.self_intersections) : 0, "self-intersection");
    return text.empty() ? "none" : text;
}

/// Says which distance it is: to the triangle's own face, or to the nearest face.
std::string distance_text(const MeshReport& r) {
    std::string text =
        line(r.to_nearest_face ? "deviation    %.6g mm: largest distance from the nearest CAD face"
                               : "deviation    %.6g mm: largest deviation of a triangle from its own CAD face",
             r.max_chord_height);
    text.pop_back();
    if (r.chord_height_asked > 0.0) {
        return text + line("; requested at most %.6g mm", r.chord_height_asked);
    }
    return text + (r.to_nearest_face ? "\n" : "; no bound was requested\n");
}

std::string work_text(const MeshReport& r) {
    std::string text;
    double total = 0.0;
    for (const auto& [stage, seconds] : r.seconds) {
        total += seconds;
        text += line("  %s %.3f s", stage.c_str(), seconds);
    }
    if (total > 0.0 || r.queries > 0) {
        text = line("time         %.3f s (%.3f s of processor), %llu geometry queries", total, r.cpu_seconds,
                    static_cast<unsigned long long>(r.queries)) +
               text;
    }
    return text;
}

}  // namespace

SurfaceTopology topology_of(const TriangleMesh& mesh) {
    const EdgeTable table(mesh.triangles, mesh.vertices.size());
    Sets bodies(mesh.triangles.size());
    LargeVector<std::uint8_t> used(mesh.vertices.size(), 0);
    SurfaceTopology topology;
    table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        --topology.euler;
        used[low] = used[high] = 1;
        for (const std::uint32_t* corner = first + 1; corner < last; ++corner) {
            bodies.unite(*first / 3, *corner / 3);
        }
    });
    topology.euler += std::count(used.begin(), used.end(), 1);
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (!is_collapsed(mesh.triangles[k])) {
            ++topology.euler;
            topology.components += bodies.find(static_cast<std::uint32_t>(k)) == k ? 1 : 0;
        }
    }
    return topology;
}

double mean_thickness(const TriangleMesh& mesh) {
    double doubled_area = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        doubled_area += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return doubled_area > 0.0 ? 4.0 * std::abs(signed_volume(mesh, mesh.vertices.front())) / doubled_area : 0.0;
}

MeshReport measure(const TriangleMesh& mesh, const Progress* progress) {
    require_valid(mesh);
    MeshReport report;
    report.triangles = mesh.triangles.size();
    report.vertices = mesh.vertices.size();
    Box local;
    for (const Vec3& p : mesh.vertices) {
        local.add(p);
    }
    if (!local.empty()) {
        report.box.low = local.low + mesh.origin;
        report.box.high = local.high + mesh.origin;
    }
    measure_shapes(mesh, report, progress);
    measure_topology(mesh, report, progress);
    report.closed = !mesh.triangles.empty() && report.border_edges == 0;
    report.oriented = report.misoriented_edges == 0;
    report.manifold = report.nonmanifold_edges == 0 && report.pinched_vertices == 0 && report.degenerate_triangles == 0;
    report.volume = report.closed ? signed_volume(mesh, local.center()) : 0.0;
    return report;
}

namespace {

std::string contacts_text(const MeshReport& r) {
    std::string text;
    for (const SolidContact& contact : r.contacts) {
        text += line("contact      Solid%d and Solid%d: %s on each side, %.6g mm^2", contact.solids[0] + 1,
                     contact.solids[1] + 1, counted(contact.triangles, "triangle").c_str(), contact.area);
    }
    return text;
}

}  // namespace

std::string to_text(const MeshReport& r) {
    const auto yes = [](bool value) { return value ? "yes" : "no"; };
    std::string text = line("triangles    %zu, vertices %zu, components %zu, Euler number %ld", r.triangles, r.vertices,
                            r.components, r.euler);
    text += line("closed       %s, oriented %s, manifold %s", yes(r.closed), yes(r.oriented), yes(r.manifold));
    text += "faults       " + faults_text(r) + "\n";
    text += line("angles       %.3f° to %.3f°, mean of the smallest %.3f°", r.min_angle, r.max_angle, r.mean_min_angle);
    if (r.min_angle_asked > 0.0) {
        text += line("             requested %.3f°; %s below the limit, %.3f° without them", r.min_angle_asked,
                     counted(r.exempt.size(), "triangle").c_str(), r.min_angle_unexempted);
    }
    text += exemptions_text(r);
    text += line(
        "aspect       at most %.3f (longest to shortest edge); stretching at most %.3f (longest edges of "
        "neighbours)",
        r.max_aspect, r.max_stretching);
    text += line("degree       at most %s at a vertex", counted(r.max_degree, "edge").c_str());
    if (r.max_chord_height >= 0.0) {
        text += distance_text(r);
        if (r.max_chord_triangle >= 0) {
            text += line("             largest at (%.6g, %.6g, %.6g), triangle %d", r.max_chord_point.x(),
                         r.max_chord_point.y(), r.max_chord_point.z(), r.max_chord_triangle);
        }
    }
    if (r.size_ratio >= 0.0) {
        text +=
            line("sizes        edges at most %.3f of the size field, at (%.6g, %.6g, %.6g); %.1f %% below half of it",
                 r.size_ratio, r.size_ratio_point.x(), r.size_ratio_point.y(), r.size_ratio_point.z(),
                 100.0 * r.short_share);
    }
    text += line("area         %.8g mm^2", r.area);
    if (r.closed) {
        text += line("volume       %.8g mm^3", r.volume);
    }
    if (!r.box.empty()) {
        const Vec3 size = r.box.high - r.box.low;
        text += line("size         %.6g x %.6g x %.6g mm", size.x(), size.y(), size.z());
    }
    text += contacts_text(r);
    text += work_text(r);
    if (!r.complete) {
        text += "incomplete   a limit ended the work early\n";
    }
    for (const auto& [face, why] : r.fallback) {
        text += line("fallback     Face%d: %s", face + 1, why.c_str());
    }
    for (const Message& note : r.notes) {
        text += "note         " + note.text() + "\n";
    }
    return text;
}

std::string counted(std::size_t count, const std::string& noun) {
    std::string digits = std::to_string(count);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), ",");
    }
    return digits + " " + noun + (count == 1 ? "" : "s");
}

std::string in_short(const MeshReport& r) {
    if (r.triangles == 0) {
        return "no triangles";
    }
    std::string text = counted(r.triangles, "triangle") + (r.closed ? ", closed" : ", open");
    text += line(", smallest angle %.3g°", r.min_angle);
    text.pop_back();
    return text;
}

const char* to_string(BodyOverlap::Kind kind) {
    switch (kind) {
        case BodyOverlap::Kind::Inside:
            return "inside";
        case BodyOverlap::Kind::Equal:
            return "equal";
        case BodyOverlap::Kind::Near:
            return "near";
        default:
            return "overlapping";
    }
}

bool has_faults(const MeshReport& r) {
    return !r.oriented || !r.manifold || r.self_intersections > 0 || !r.missing.empty() || !r.complete ||
           r.min_angle < r.min_angle_asked || r.size_ratio > kMostOfSizeField ||
           (r.chord_height_asked > 0.0 && r.max_chord_height > r.chord_height_asked);
}

}  // namespace mq::mesh

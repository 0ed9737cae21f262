// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/distance_mesh.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "geometry/occt/distance/shape_distance.h"
#include "geometry/occt/kernel_triangles.h"
#include "geometry/occt/sub_shapes.h"
#include "mesh/quality/deviation_samples.h"
#include "mesh/quality/surface_distance.h"
#include "workflows/operands/triangulate_shape.h"

namespace mq::workflows {

namespace {

using mesh::TriangleMesh;

/// "Face1, Face4 and 3 more"
std::string named(const std::vector<std::int32_t>& faces) {
    constexpr std::size_t kNamed = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(kNamed, faces.size()); ++i) {
        text += (i == 0 ? "Face" : ", Face") + std::to_string(faces[i] + 1);
    }
    return faces.size() > kNamed ? text + " and " + std::to_string(faces.size() - kNamed) + " more" : text;
}

/// The largest distance, mm, of points of the coarse mesh from its face, and of points of the fine mesh, which stand
/// for the face, from the coarse one.
double deviation_of(const TopoDS_Shape& face, const TriangleMesh& coarse, const TriangleMesh& fine,
                    Progress& progress) {
    const std::vector<double> from_face =
        geometry::distances_to_faces(face, mesh::deviation_samples(coarse).points, &progress);
    const double largest = from_face.empty() ? 0.0 : *std::max_element(from_face.begin(), from_face.end());
    return std::max(largest, mesh::surface_distance(fine, coarse, progress).largest);
}

/// The faces that our mesher could not mesh, and the reasons.
struct Missing {
    std::vector<std::int32_t> faces;
    std::string why;
    std::exception_ptr refused;  ///< set if it meshed no face at all
};

Missing missing_of(const mesh::MeshReport& report) {
    Missing missing;
    std::vector<std::string> reasons;
    for (const auto& [face, reason] : report.missing) {
        missing.faces.push_back(face);
        if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
            missing.why += (reasons.empty() ? "" : "; ") + reason;
            reasons.push_back(reason);
        }
    }
    std::sort(missing.faces.begin(), missing.faces.end());
    return missing;
}

Missing all_missing(std::size_t faces, const Error& error) {
    Missing missing{{}, error.what(), std::current_exception()};
    for (std::size_t i = 0; i < faces; ++i) {
        missing.faces.push_back(static_cast<std::int32_t>(i));
    }
    return missing;
}

}  // namespace

void append(TriangleMesh& mesh, const TriangleMesh& piece) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Vec3& p : piece.vertices) {
        mesh.vertices.push_back(p + piece.origin);
    }
    for (const mesh::Triangle& t : piece.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    mesh.triangle_face.insert(mesh.triangle_face.end(), piece.triangle_face.begin(), piece.triangle_face.end());
}

void require_complete(const mesh::MeshReport& report, double distance) {
    if (!report.complete) {
        throw InvalidInput("more than " + std::to_string(report.triangles) + " triangles at a max. deviation of " +
                           in_digits(distance, 6) + " mm: give a larger tolerance");
    }
}

std::pair<TriangleMesh, double> kernel_mesh(geometry::Engine& engine, const TopoDS_Shape& shape, std::int32_t face,
                                            double distance, Progress& progress) {
    constexpr double kCoarsest = 16.0;  // times the distance: the first triangulation; ...
    constexpr double kFiner = 4.0;      // ... by how much the next one is finer, whose points are looked for on it; ...
    constexpr int kRounds = 3;          // ... at most this often
    std::shared_ptr<const TopoDS_Shape> copy;
    double wanted = kCoarsest * distance;
    const auto made = [&] {
        geometry::KernelTriangles found;
        engine.run([&] { found = geometry::kernel_triangles(*copy, wanted); }, &progress);
        TriangleMesh mesh;
        mesh.triangle_face.assign(found.triangles.size(), face);
        mesh.vertices = std::move(found.vertices);
        mesh.triangles = std::move(found.triangles);
        return mesh;
    };
    engine.run([&] { copy = geometry::copied_face(shape, static_cast<std::size_t>(face)); }, &progress);
    TriangleMesh now = made();
    std::optional<double> deviation;
    for (int round = 0; round < kRounds; ++round) {
        TriangleMesh coarse = std::move(now);
        wanted /= kFiner;
        now = made();
        if (now.triangles.empty()) {
            now = std::move(coarse);
        } else if (!coarse.triangles.empty()) {
            deviation = deviation_of(*copy, coarse, now, progress);
            if (*deviation <= distance) {
                return {std::move(coarse), *deviation};
            }
        }
    }
    if (!deviation) {  // only one triangulation succeeded
        deviation = now.triangles.empty() ? 0.0 : deviation_of(*copy, now, now, progress);
    }
    return {std::move(now), *deviation};  // the last measured deviation, of the coarser one
}

DistanceMesh mesh_within(geometry::Engine& engine, const TopoDS_Shape& shape, double distance, int threads,
                         Progress& progress) {
    triangulate::TriangulateOptions options;
    options.min_angle = 0.0;
    options.chord_height = distance;
    options.allow_missing_faces = true;
    options.threads = threads;
    std::size_t faces = 0;
    engine.run([&] { faces = geometry::face_count(shape); }, &progress);
    DistanceMesh result;
    Missing missing;
    try {
        triangulate::Result mesh = triangulate_shape(engine, shape, options, progress);
        require_complete(mesh.report, distance);
        missing = missing_of(mesh.report);
        result.deviation = mesh.report.max_chord_height;
        if (missing.faces.empty()) {
            result.surface = std::move(mesh);
            return result;
        }
        append(result.surface.mesh, mesh.mesh);
    } catch (const InvalidInput& error) {
        missing = all_missing(faces, error);
    } catch (const TopologyError& error) {
        missing = all_missing(faces, error);
    }
    std::vector<std::int32_t> taken;
    std::vector<std::int32_t> left_out;
    for (const std::int32_t face : missing.faces) {
        const auto [mesh, deviation] = kernel_mesh(engine, shape, face, distance, progress);
        append(result.surface.mesh, mesh);
        result.deviation = std::max(result.deviation, deviation);
        (mesh.triangles.empty() ? left_out : taken).push_back(face);
    }
    if (missing.refused && left_out.size() == faces) {
        std::rethrow_exception(missing.refused);
    }
    result.round = true;
    if (!taken.empty()) {
        result.note = named(taken) + ": not meshed; OpenCASCADE's triangulation is taken, which may have holes";
    }
    if (!left_out.empty()) {
        result.note +=
            (taken.empty() ? "" : "; ") + named(left_out) + ": meshed neither by us nor by OpenCASCADE, and left out";
    }
    result.note += " (" + missing.why + ")";
    return result;
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/distance_mesh.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/distance/shape_distance.h"
#include "geometry/occt/kernel_triangles.h"
#include "geometry/occt/sub_shapes.h"
#include "mesh/quality/deviation_samples.h"
#include "mesh/quality/exemptions.h"
#include "mesh/quality/surface_distance.h"
#include "workflows/operands/triangulate_shape.h"

namespace mq::workflows {

namespace {

using mesh::TriangleMesh;

/// "Face1, Face4 and 3 more"
Message names_of(const std::vector<std::int32_t>& faces) {
    std::vector<std::string> names;
    for (const std::int32_t face : faces) {
        names.push_back("Face" + std::to_string(face + 1));
    }
    return mesh::list_of(names);
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
    Message why;
    std::exception_ptr refused;  ///< where it has meshed no face at all
};

Missing missing_of(const mesh::MeshReport& report) {
    Missing missing;
    std::vector<std::string> reasons;
    for (const auto& [face, reason] : report.missing) {
        missing.faces.push_back(face);
        if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) {
            reasons.push_back(reason);
        }
    }
    missing.why = mesh::list_of(reasons);
    std::sort(missing.faces.begin(), missing.faces.end());
    return missing;
}

Missing all_missing(std::size_t faces, const Error& error) {
    Missing missing{{}, error.message(), std::current_exception()};
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
        throw InvalidInput(phrases::kTooManyTriangles, {{"count", report.triangles}, {"length", in_mm(distance, 6)}});
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
    for (const auto& [phrase, named] :
         {std::pair(phrases::kTakenFromKernel, taken), std::pair(phrases::kNotMeshed, left_out)}) {
        if (!named.empty()) {
            result.notes.push_back({phrase, {{"list", names_of(named)}, {"phrase", missing.why}}});
        }
    }
    return result;
}

}  // namespace mq::workflows

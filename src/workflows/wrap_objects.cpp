// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/wrap_objects.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/sub_shapes.h"
#include "mesh/intersection/self_intersection.h"
#include "workflows/operands/operand_frame.h"

namespace mq::workflows {

namespace {

/// Several meshes in one list, each CAD face of each with a number of its own.
struct Joined {
    mesh::TriangleMesh mesh;
    std::vector<std::array<std::int32_t, 2>> source;  ///< by triangle: its object, and its index in that
};

Joined joined(const std::vector<const mesh::TriangleMesh*>& meshes, const std::vector<BooleanOperand>& objects,
              const std::vector<std::int32_t>& faces) {
    Joined result;
    std::int32_t first_face = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const auto first = static_cast<std::int32_t>(result.mesh.vertices.size());
        result.mesh.origin = meshes[i]->origin;
        for (const Vec3& p : meshes[i]->vertices) {
            if (!p.allFinite()) {
                throw InvalidInput(phrases::kObjectNotFinite, {{"count", i + 1}});
            }
            result.mesh.vertices.push_back(p);
        }
        const std::vector<std::int32_t>& its_faces = objects[i].surface->mesh.triangle_face;
        for (std::size_t t = 0; t < meshes[i]->triangles.size(); ++t) {
            const mesh::Triangle& c = meshes[i]->triangles[t];
            result.mesh.triangles.push_back({first + c[0], first + c[1], first + c[2]});
            result.mesh.triangle_face.push_back(first_face + (faces[i] <= 1 ? 0 : its_faces[t]));
            result.source.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(t)});
        }
        first_face += std::max(faces[i], 1);
    }
    return result;
}

void measure_gaps(WrapSurface& surface, const std::vector<std::int32_t>& source) {
    const mesh::TriangleMesh& mesh = surface.mesh;
    for (std::size_t t = 0; t < source.size(); ++t) {
        if (source[t] < 0) {
            const mesh::Triangle& c = mesh.triangles[t];
            const Vec3& a = mesh.vertices[static_cast<std::size_t>(c[0])];
            surface.gap_area += 0.5 * (mesh.vertices[static_cast<std::size_t>(c[1])] - a)
                                          .cross(mesh.vertices[static_cast<std::size_t>(c[2])] - a)
                                          .norm();
            ++surface.gap_triangles;
        }
    }
}

/// Sorts triangles by face, as meshers do, so that a document has few numbers to store.
void sort_by_face(wrap::WrapResult& wrapped, const std::vector<std::int32_t>& faces) {
    const std::vector<std::int32_t> source = wrapped.triangle_source;
    const std::vector<mesh::Triangle> triangles = wrapped.mesh.triangles;
    const auto face = [&](std::size_t t) { return source[t] < 0 ? -1 : faces[static_cast<std::size_t>(source[t])]; };
    std::vector<std::size_t> order(source.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return face(a) < face(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        wrapped.triangle_source[i] = source[order[i]];
        wrapped.mesh.triangles[i] = triangles[order[i]];
    }
}

/// The number of CAD faces of an object; 0: not all of its triangles have one.
std::int32_t faces_of(const BooleanOperand& object) {
    const std::vector<std::int32_t>& faces = object.surface->mesh.triangle_face;
    if (object.shape != nullptr) {
        return static_cast<std::int32_t>(geometry::face_count(*object.shape));
    }
    const auto [least, most] = std::minmax_element(faces.begin(), faces.end());
    return faces.empty() || *least < 0 ? 0 : *most + 1;
}

WrapSurface wrap_meshes(const std::vector<BooleanOperand>& objects, const wrap::WrapOptions& options,
                        const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    WrapSurface result;
    std::vector<FramedOperand> framed;
    for (const BooleanOperand& object : objects) {
        framed.push_back({&object.surface->mesh, object.round});
        result.faces.push_back(faces_of(object));
    }
    const OperandFrame frame(framed);
    const Joined input = joined(frame.meshes(), objects, result.faces);
    wrap::WrapOptions in_frame = options;
    for (Vec3& dry : in_frame.dry) {
        dry -= input.mesh.origin;
    }
    wrap::WrapResult wrapped = wrap::wrap(input.mesh, in_frame, progress);
    sort_by_face(wrapped, input.mesh.triangle_face);
    result.mesh = std::move(wrapped.mesh);
    for (const std::int32_t t : wrapped.triangle_source) {
        result.triangle_source.push_back(t < 0 ? std::array<std::int32_t, 2>{-1, -1}
                                               : input.source[static_cast<std::size_t>(t)]);
        result.mesh.triangle_face.push_back(t < 0 ? -1 : input.mesh.triangle_face[static_cast<std::size_t>(t)]);
    }
    measure_gaps(result, wrapped.triangle_source);
    result.distance = wrapped.distance;
    result.leaks = std::move(wrapped.leaks);
    for (wrap::Leak& leak : result.leaks) {
        leak.dry += input.mesh.origin;
        leak.narrowest += input.mesh.origin;
        for (Vec3& p : leak.path) {
            p += input.mesh.origin;
        }
    }
    BooleanReport& figures = result.figures;
    figures.method = "wrap";
    figures.error_bound = std::max(wrapped.distance.to_input, wrapped.distance.from_input);
    figures.reconstructed = result.mesh.triangles.size();
    figures.seconds = std::move(wrapped.seconds);
    const std::vector<mesh::ContactPair> contacts =
        mesh::self_intersections(result.mesh.vertices, result.mesh.triangles, mesh::kMostCounted, &progress);
    figures.self_intersections = static_cast<std::int64_t>(contacts.size());
    figures.faults_left = contacts.size();
    complete_report(result, before, phrases::kNothingAsLarge, progress);
    figures.cpu_seconds = before.cpu_seconds + watch.cpu();
    result.report = figures;
    return result;
}

}  // namespace

WrapSurface wrap_objects(const Operands& objects, wrap::WrapOptions options, Progress& progress) {
    constexpr double kRelative = 2e-2;   // the tolerance as a fraction of the size, where none is given, ...
    constexpr double kOfGap = 0.25;      // ... and at most as one of the gap
    constexpr double kLargest = 0.5;     // fraction of the gap: the lattice must not pass openings
    constexpr double kDeviation = 0.05;  // meshes of shapes, as a fraction of the tolerance
    constexpr double kMeshing = 0.1;     // fraction of the progress
    const double size = objects.size();  // 0 without triangles, which is refused later
    if (options.spacing <= 0.0) {
        options.spacing = std::min(kRelative * (size > 0.0 ? size : options.gap), kOfGap * options.gap);
    }
    if (options.spacing > kLargest * options.gap) {
        throw InvalidInput(phrases::kHalfOfGap,
                           {{"length", in_mm(options.spacing, 6)}, {"length2", in_mm(options.gap, 6)}});
    }
    OperandMeshing meshing;
    meshing.tolerance = options.spacing;
    meshing.share = kDeviation;
    meshing.any_faces = true;
    meshing.threads = options.threads;
    MeshedOperands meshed = objects.meshed(meshing, progress, 0.0, kMeshing);
    meshed.work.tolerance = options.spacing;
    const ProgressShare rest(progress, objects.any_shapes() ? kMeshing : 0.0, 1.0);
    return wrap_meshes(meshed.operands, options, meshed.work, progress);
}

}  // namespace mq::workflows

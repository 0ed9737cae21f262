// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_draft.h"

#include <memory>
#include <utility>

#include "geometry/occt/shape_model.h"
#include "geometry/session.h"

namespace mq::workflows {

std::vector<Vec3> cad_normals(geometry::Engine& engine, const mesh::TriangleMesh& mesh, const TopoDS_Shape& shape,
                              Progress& progress, std::size_t& exact) {
    std::shared_ptr<geometry::Model> model;
    engine.run([&] { model = geometry::make_shape_model(shape, &progress); }, &progress);
    geometry::Session session(engine, model, &progress);
    std::vector<Vec3> normals;
    geometry::Engine::Batch batch;
    std::vector<std::size_t> asked;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const mesh::Triangle& t = mesh.triangles[k];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        normals.push_back((b - a).cross(c - a).normalized());
        if (!mesh.triangle_face.empty() && mesh.triangle_face[k] >= 0) {
            batch.push_back(
                geometry::Query::face_nearest_global(mesh.triangle_face[k], (a + b + c) / 3.0 + mesh.origin));
            asked.push_back(k);
        }
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const Vec3& normal = answers[i].normal;
        if (answers[i].status == geometry::Status::Ok && normal.squaredNorm() > 0.5) {
            // Outward of the solid, whichever way the face is turned.
            Vec3& found = normals[asked[i]];
            found = found.dot(normal) < 0.0 ? Vec3(-normal) : normal;
            ++exact;
        }
    }
    return normals;
}

DraftSurface measure_draft(geometry::Engine& engine, const triangulate::Result& given, const TopoDS_Shape* shape,
                           const inspection::DraftOptions& options, Progress& progress) {
    options.validate();
    DraftSurface found;
    progress.stage("preparing the solids", 0.0, 0.1);
    found.solids = solid_surface(given, progress);
    progress.stage("measuring the draft", 0.1, 1.0);
    const mesh::TriangleMesh& mesh = found.solids.surface.mesh;
    std::vector<Vec3> normals;
    if (shape != nullptr) {
        normals = cad_normals(engine, mesh, *shape, progress, found.exact_normals);
    }
    found.draft = inspection::draft(mesh, normals, options, &progress);
    return found;
}

}  // namespace mq::workflows

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/measure_deviation.h"

#include <algorithm>
#include <memory>

#include "geometry/occt/shape_model.h"
#include "geometry/session.h"

namespace mq::workflows {

inspection::Deviation measure_deviation(geometry::Engine& engine, const std::vector<Vec3>& points,
                                        const triangulate::Result& reference, const TopoDS_Shape* shape,
                                        const inspection::DeviationOptions& options, Progress& progress) {
    // mm a mm: vertices are rounded to single precision.
    constexpr double kVertexRounding = 2.5e-7;
    mesh::TriangleMesh mesh = reference.mesh;
    Box box;
    for (Vec3& p : mesh.vertices) {
        p += mesh.origin;
        box.add(p);
    }
    mesh.origin = Vec3::Zero();
    if (shape == nullptr) {
        return inspection::measure_deviation(points, mesh, nullptr, 0.0, options, progress);
    }
    std::shared_ptr<geometry::Model> model;
    engine.run([&] { model = geometry::make_shape_model(*shape, &progress); }, &progress);
    geometry::Session session(engine, model, &progress);
    const double largest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
    // The distances that the report knows are those of samples: twice the largest one is beyond all others. What is
    // smaller than its detail has no triangles.
    const double deviation =
        2.0 * std::max(reference.report.max_chord_height, 0.0) + reference.report.detail + kVertexRounding * largest;
    return inspection::measure_deviation(points, mesh, &session, deviation, options, progress);
}

}  // namespace mq::workflows

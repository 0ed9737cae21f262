// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/backward_distance.h"

#include <algorithm>
#include <cmath>

#include "triangulate/measure/tuning.h"

namespace mq::triangulate {

namespace {

struct Projection {
    std::array<double, 3> weights{};  // barycentric
    double height = 0.0;              // distance from the plane, mm
    bool inside() const { return weights[lowest()] >= 0.0; }
    std::size_t lowest() const {
        return static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    }
};

// Projects a point onto the plane of a triangle; none if the triangle has no area.
std::optional<Projection> project(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    if (!(area > 0.0)) {
        return std::nullopt;
    }
    const double of_b = (p - a).cross(c - a).dot(normal) / area;
    const double of_c = (b - a).cross(p - a).dot(normal) / area;
    return Projection{{1.0 - of_b - of_c, of_b, of_c}, std::abs((p - a).dot(normal)) / std::sqrt(area)};
}

std::optional<Projection> project(const ClassifiedMesh& mesh, const Vec3& p, int triangle) {
    const int h = 3 * triangle;
    return project(p, mesh.point_of(h), mesh.point_of(h + 1), mesh.point_of(h + 2));
}

}  // namespace

void for_each_cad_sample_over(Workspace& work, int triangle,
                              const std::function<void(const CadSampleOverTriangle&)>& see) {
    const ClassifiedMesh& mesh = work.mesh;
    const auto uv = [&](int k) { return mesh.site(mesh.site_of(3 * triangle + k)).uv; };
    work.span_points.inside(mesh.face_of(triangle), {uv(0), uv(1), uv(2)}, [&](const Vec3& p) {
        std::optional<Projection> projection = project(mesh, p, triangle);
        int under = triangle;
        for (int step = 0; step < MeasureTuning::kMaxSteps && projection && !projection->inside(); ++step) {
            const int side = 3 * under + (static_cast<int>(projection->lowest()) + 1) % 3;
            if (mesh.twin(side) < 0) {
                break;
            }
            under = ClassifiedMesh::triangle_of(mesh.twin(side));
            projection = project(mesh, p, under);
        }
        if (!projection) {
            return;
        }
        CadSampleOverTriangle over{projection->height, Vec3::Zero(), under, projection->weights};
        double sum = 0.0;
        for (double& w : over.weights) {
            w = std::max(w, 0.0);
            sum += w;
        }
        for (int k = 0; k < 3; ++k) {
            over.weights[k] /= sum;
            over.below += over.weights[k] * mesh.point_of(3 * under + k);
        }
        see(over);
    });
}

double backward_distance(Workspace& work, int face, const ClassifiedMesh::VertexUse& a,
                         const ClassifiedMesh::VertexUse& b, const ClassifiedMesh::VertexUse& c) {
    double farthest = 0.0;
    work.span_points.inside(face, {a.uv, b.uv, c.uv}, [&](const Vec3& p) {
        const std::optional<Projection> projection = project(p, a.point, b.point, c.point);
        if (projection && projection->inside()) {
            farthest = std::max(farthest, projection->height);
        }
    });
    return farthest;
}

BackwardDistance backward_distance(Workspace& work, int edge, const PointOfEdge& a, const PointOfEdge& b) {
    BackwardDistance farthest{0.0, a.point};
    const Vec3 along = b.point - a.point;
    work.span_points.between(edge, a.t, b.t, [&](const Vec3& p) {
        const double at = std::clamp((p - a.point).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vec3 nearest = a.point + at * along;
        if ((p - nearest).norm() > farthest.distance) {
            farthest = {(p - nearest).norm(), nearest};
        }
    });
    return farthest;
}

}  // namespace mq::triangulate

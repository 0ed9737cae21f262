// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/component_work.h"

#include <algorithm>
#include <utility>

#include "base/angle.h"
#include "triangulate/components/placed_body.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

// Measured distances are stored in single precision.
constexpr double kSinglePrecision = 1.0 - 1e-6;

}  // namespace

bool PlacedBodies::add(geometry::Session& session, const SinglePrecisionGrid& grid, const RefinedBody& original,
                       int copy, const ClassifiedMesh& whole, const std::vector<int>& triangles) {
    const Copy added{original, copy, component_.mesh.vertex_count(), component_.mesh.triangle_count()};
    if (!add_placed(session, grid, original.mesh, equal_, copy, whole, vertices_of_nodes(whole, triangles),
                    component_)) {
        return false;
    }
    component_.triangles.insert(component_.triangles.end(), triangles.begin(), triangles.end());
    copies_.push_back(added);
    return true;
}

ComponentWork::ComponentWork(MeshComponent component, const Common& common, bool placed)
    : component_(std::move(component)),
      placed_(placed),
      session_(common.session),
      progress_(&common.progress),
      maxmin_(component_.mesh),
      work_{session_,
            common.whole.work().grid,
            component_.mesh,
            maxmin_,
            progress_,
            common.whole.work().floor,
            common.whole.work().min_edge,
            common.budget},
      findings_(work_) {
    work_.unresolved = common.whole.work().unresolved;
    work_.unseen = common.whole.work().unseen;
}

ComponentWork::ComponentWork(MeshComponent component, const Common& common)
    : ComponentWork(std::move(component), common, false) {
    read_from(common.whole.work(), common.measured);
    start(common.whole, index_of(common.whole.first_vertex()));
}

ComponentWork::ComponentWork(PlacedBodies& placed, const Common& common)
    : ComponentWork(placed.release_component(), common, true) {
    read_from(placed);
    mark_settled(common.whole.options().min_angle * kDegree);
    start(common.whole, work_.mesh.vertex_count());
}

void ComponentWork::start(Refinement& whole, int first_vertex) {
    refinement_.emplace(work_, findings_, whole.options(), whole.chord(), first_vertex,
                        [this](const char* stage) { clock_.end(stage); });
}

// Frees data that only refinement needs: `write_to` passes the rest on.
void ComponentWork::run() {
    refinement_->run();
    refinement_.reset();
    if (placed_) {
        work_.settled.clear();  // since triangles of the original are not settled
    }
}

int ComponentWork::index_of(int vertex_of_whole) const {
    const std::vector<int>& vertices = component_.vertices;
    return static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), vertex_of_whole) - vertices.begin());
}

void ComponentWork::read_from(const Workspace& whole, const ChordErrorCache& measured) {
    for (std::size_t i = 0; i < component_.triangles.size(); ++i) {
        const int t = static_cast<int>(i);
        for (int k = 0; k < 3; ++k) {
            findings_.chords.set_measured(3 * t + k, measured.measured(3 * component_.triangles[i] + k));
        }
        if (const Exemption* exemption = whole.exemption_of(component_.triangles[i])) {
            work_.exempt[t] = {exemption->cause, exemption->vertex < 0 ? -1 : index_of(exemption->vertex),
                               exemption->edge, work_.mesh.stamp(t)};
        }
        if (whole.settled.marked(whole.mesh, component_.triangles[i])) {
            work_.settled.mark(work_.mesh, t);
        }
    }
}

void ComponentWork::read_from(const PlacedBodies& placed) {
    for (const PlacedBodies::Copy& copy : placed.copies()) {
        progress_.check();
        work_.shrinks.insert(work_.shrinks.end(), copy.original.shrinks.begin(), copy.original.shrinks.end());
        for (const auto& [triangle, of_original] : copy.original.exempt) {
            const int t = copy.first_triangle + triangle;
            Exemption& exemption = work_.exempt[t];
            exemption.cause = of_original.cause;
            exemption.vertex = of_original.vertex < 0 ? -1 : copy.first_vertex + of_original.vertex;
            exemption.edge = of_original.edge < 0 ? -1 : placed.equal().in_copy({1, of_original.edge}, copy.body);
            exemption.stamp = work_.mesh.stamp(t);
        }
        read_measured(copy, placed.equal().motion[static_cast<std::size_t>(copy.body)]);
    }
}

// A piece of a copy is as far from the CAD model as the piece of the original, up to the distance by which rounding has
// moved its ends. So pieces that may exceed the tolerance by that distance are measured again.
void ComponentWork::read_measured(const PlacedBodies::Copy& copy, const geometry::RigidMotion& motion) {
    const ClassifiedMesh& original = copy.original.mesh;
    std::vector<double> moved(
        static_cast<std::size_t>(original.vertex_count()));  // by vertex, mm: how far rounding moved it
    for (int v = 0; v < original.vertex_count(); ++v) {
        const Vec3 exact = motion.of_point(work_.grid.to_shape(original.vertex(v).point));
        const Vec3 point = work_.grid.to_shape(work_.mesh.vertex(copy.first_vertex + v).point);
        moved[static_cast<std::size_t>(v)] = (point - exact).norm();
    }
    for (int h = 0; h < original.half_edge_count(); ++h) {
        ChordErrorCache::Measured measured = copy.original.measured[static_cast<std::size_t>(h)];
        const double most = std::max(moved[static_cast<std::size_t>(original.vertex_of(h))],
                                     moved[static_cast<std::size_t>(original.vertex_of(ClassifiedMesh::next(h)))]);
        if (static_cast<double>(measured.distance) + most <=
            kSinglePrecision * static_cast<double>(measured.tolerance)) {
            const Vec3 offset = motion.of_direction(Vec3(measured.offset[0], measured.offset[1], measured.offset[2]));
            measured.offset = {offset.x(), offset.y(), offset.z()};
            findings_.chords.set_measured(3 * copy.first_triangle + h, measured);
        }
    }
}

// Marks triangles whose refinement was finished in the original.
void ComponentWork::mark_settled(double bound) {
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        if (work_.exemption_of(t) != nullptr || smallest_angle(work_.mesh, t).angle >= bound) {
            work_.settled.mark(work_.mesh, t);
        }
    }
}

RefinedBody ComponentWork::body(const std::vector<int>& faces) const {
    std::vector<int> triangles;
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        if (std::binary_search(faces.begin(), faces.end(), work_.mesh.face_of(t))) {
            triangles.push_back(t);
        }
    }
    MeshComponent cut = component_of(work_.mesh, std::move(triangles), &work_.progress);
    RefinedBody body;
    for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
        if (const Exemption* exemption = work_.exemption_of(cut.triangles[i])) {
            const auto vertex = std::lower_bound(cut.vertices.begin(), cut.vertices.end(), exemption->vertex);
            body.exempt[static_cast<int>(i)] = {
                exemption->cause, exemption->vertex < 0 ? -1 : static_cast<int>(vertex - cut.vertices.begin()),
                exemption->edge, 0};
        }
        for (int k = 0; k < 3; ++k) {
            body.measured.push_back(findings_.chords.measured(3 * cut.triangles[i] + k));
        }
    }
    for (const int v : cut.vertices) {
        const auto i = static_cast<std::size_t>(v);
        body.shrinks.push_back(i < work_.shrinks.size() ? work_.shrinks[i] : 0);
    }
    body.mesh = std::move(cut.mesh);
    return body;
}

void ComponentWork::write_to(Workspace& whole, ChordErrorCache& measured, int first, const std::vector<int>& vertices) {
    measured.adopt(findings_.chords, 3 * first);
    for (const auto& [triangle, exemption] : work_.exempt) {
        if (exemption.stamp == work_.mesh.stamp(triangle)) {
            const int vertex = exemption.vertex < 0 ? -1 : vertices[static_cast<std::size_t>(exemption.vertex)];
            whole.exempt[first + triangle] = {exemption.cause, vertex, exemption.edge,
                                              whole.mesh.stamp(first + triangle)};
        }
    }
    for (int t = 0; t < work_.mesh.triangle_count(); ++t) {
        if (work_.settled.marked(work_.mesh, t)) {
            whole.settled.mark(whole.mesh, first + t);
        }
    }
    for (std::size_t v = 0; v < work_.shrinks.size(); ++v) {
        whole.shrinks[static_cast<std::size_t>(vertices[v])] = work_.shrinks[v];
    }
    whole.left_by_mending += work_.left_by_mending;
    whole.span_points.adopt(work_.span_points);
}

}  // namespace mq::triangulate

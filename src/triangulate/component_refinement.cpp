// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/component_refinement.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/disjoint_sets.h"
#include "triangulate/components/mesh_components.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/triangle_measures.h"

namespace mq::triangulate {

namespace {

// Components that are refined apart: enough for the cores of a large computer; each has tables of all CAD entities.
constexpr std::size_t kMost = 64;
// Largest fraction of the work on one component: otherwise its steps gain more from several threads.
constexpr double kLargest = 0.75;

/// A component of a mesh and all that refines it.
class ComponentWork {
  public:
    ComponentWork(MeshComponent component, Refinement& whole, const ChordErrorCache& measured,
                  const geometry::Session& session)
        : component_(std::move(component)),
          session_(session),
          progress_(&whole.work().progress),
          maxmin_(component_.mesh),
          work_{session_,  whole.work().grid,  component_.mesh,       maxmin_,
                progress_, whole.work().floor, whole.work().min_edge, whole.work().budget},
          findings_(work_) {
        take(whole.work(), measured);
        refinement_.emplace(work_, findings_, whole.options(), whole.chord(), first_vertex(whole.first_vertex()),
                            [this](const char* stage) { clock_.end(stage); });
    }

    /// Frees what was known for refinement only: `give` passes the rest on.
    void run() {
        refinement_->run();
        refinement_.reset();
    }

    const MeshComponent& component() const { return component_; }
    const StageTimes& stages() const { return stages_; }
    const Workspace& work() const { return work_; }

    /// Passes what is known of triangles, edges and vertices on to the whole mesh, where the component's first triangle
    /// is `first` and its vertices are `vertices`.
    void give(Workspace& whole, ChordErrorCache& measured, int first, const std::vector<int>& vertices) {
        measured.take_over(findings_.chords, 3 * first);
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
        whole.span_points.take_over(work_.span_points);
    }

  private:
    int first_vertex(int of_whole) const {
        const std::vector<int>& vertices = component_.vertices;
        return static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), of_whole) - vertices.begin());
    }

    void take(const Workspace& whole, const ChordErrorCache& measured) {
        work_.unresolved = whole.unresolved;
        work_.unseen = whole.unseen;
        for (std::size_t i = 0; i < component_.triangles.size(); ++i) {
            const int t = static_cast<int>(i);
            for (int k = 0; k < 3; ++k) {
                findings_.chords.take(3 * t + k, measured.measured(3 * component_.triangles[i] + k));
            }
            if (const Exemption* exemption = whole.exemption_of(component_.triangles[i])) {
                const std::vector<int>& vertices = component_.vertices;
                const auto vertex = std::lower_bound(vertices.begin(), vertices.end(), exemption->vertex);
                work_.exempt[t] = {exemption->cause,
                                   exemption->vertex < 0 ? -1 : static_cast<int>(vertex - vertices.begin()),
                                   exemption->edge, work_.mesh.stamp(t)};
            }
            if (whole.settled.marked(whole.mesh, component_.triangles[i])) {
                work_.settled.mark(work_.mesh, t);
            }
        }
    }

    MeshComponent component_;
    geometry::Session session_;
    Progress progress_;
    StageTimes stages_;
    StageClock clock_{stages_};
    MaxMinSwaps maxmin_;
    Workspace work_;
    MeasurementCache findings_;
    std::optional<Refinement> refinement_;
};

using Works = std::vector<std::unique_ptr<ComponentWork>>;

// Whether components may be refined for themselves: a limit that the caller sets concerns all of them, and a record of
// angles and the paper's insertions have one order.
bool may_divide(const Workspace& work, const TriangulateOptions& options) {
    return !work.over_budget() && options.max_triangles == 0 && !options.record_angles &&
           options.insertion != Insertion::Paper;
}

// Triangles of one volume, or of one face of the shape, must not cross: such faces are refined together.
std::vector<int> bodies_of_faces(const geometry::Topology& topology) {
    DisjointSets<int> together(topology.faces.size());
    std::map<int, int> first;  // by face of the shape
    for (int face = 0; face < static_cast<int>(topology.faces.size()); ++face) {
        together.unite(first.emplace(topology.of_shape({2, face}).index, face).first->second, face);
    }
    for (const geometry::Volume& volume : topology.volumes) {
        for (const geometry::Volume::Side& side : volume.sides) {
            if (volume.kind != geometry::Volume::Kind::Faces) {
                together.unite(volume.sides.front().face, side.face);
            }
        }
    }
    int count = 0;
    return together.number(count);
}

// Estimates how many triangles one becomes. Edges over a surface that bends by k per mm get a length of sqrt(8 h / k)
// at the chord tolerance h; equilateral triangles with these have an area of 3.5 h / k.
double triangles_expected(const ClassifiedMesh& mesh, int triangle, double chord) {
    double bend = 0.0;
    for (int h = 3 * triangle; chord > 0.0 && h < 3 * triangle + 3; ++h) {
        const Vec3& normal = mesh.site(mesh.site_of(h)).normal;
        const Vec3& other = mesh.site(mesh.site_of(ClassifiedMesh::next(h))).normal;
        const double length = side_length(mesh, h);
        bend = length > 0.0 ? std::max(bend, angle_between(normal, other) / length) : bend;
    }
    const double area = 0.5 * doubled_area(mesh, triangle).norm();
    return chord > 0.0 ? 1.0 + area * bend / (3.5 * chord) : 1.0;
}

std::vector<double> work_expected(const ClassifiedMesh& mesh, double chord) {
    std::vector<double> work;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        work.push_back(triangles_expected(mesh, t, chord));
    }
    return work;
}

// @return none where all together would have more triangles than the budget
Works refined(Refinement& whole, const ChordErrorCache& measured, std::vector<MeshComponent> components) {
    Works works(components.size());
    const Workspace& work = whole.work();
    std::atomic<std::size_t> triangles{0};
    std::atomic<std::size_t> done{0};  // triangles before refinement
    work.session.run_apart(static_cast<int>(works.size()), [&](geometry::Session& session, int k) {
        const auto i = static_cast<std::size_t>(k);
        if (triangles > work.budget) {
            return;
        }
        const std::size_t before = components[i].triangles.size();
        works[i] = std::make_unique<ComponentWork>(std::move(components[i]), whole, measured, session);
        works[i]->run();
        const Workspace& refined = works[i]->work();
        triangles += refined.over_budget() ? work.budget + 1 : refined.triangles();
        done += before;
        whole.work().progress.advance(static_cast<double>(done) / static_cast<double>(work.triangles()));
    });
    return triangles > work.budget ? Works() : std::move(works);
}

void join_into(Refinement& whole, ChordErrorCache& measured, const Works& works) {
    Workspace& work = whole.work();
    std::vector<const MeshComponent*> changed;
    for (const auto& of_component : works) {
        changed.push_back(&of_component->component());
    }
    JoinedComponents joined = join(work.mesh, changed);
    work.mesh = std::move(joined.mesh);
    work.maxmin.rebuild();
    measured.clear();
    work.exempt.clear();
    work.settled.clear();
    work.shrinks.resize(static_cast<std::size_t>(work.mesh.vertex_count()), 0);
    for (std::size_t i = 0; i < works.size(); ++i) {
        works[i]->give(work, measured, joined.first[i], joined.vertices[i]);
    }
}

}  // namespace

bool refine_components(Refinement& whole, ChordErrorCache& measured, StageTimes& stages) {
    Workspace& work = whole.work();
    std::vector<MeshComponent> components = may_divide(work, whole.options())
                                                ? divide(work.mesh, bodies_of_faces(work.session.topology()),
                                                         work_expected(work.mesh, whole.chord()), kMost, kLargest)
                                                : std::vector<MeshComponent>();
    if (components.empty()) {
        return false;
    }
    work.progress.stage("refining bodies", share_before_refinement(whole.options()), 0.9);
    const Works works = refined(whole, measured, std::move(components));
    if (works.empty()) {
        return false;
    }
    join_into(whole, measured, works);
    for (const auto& of_component : works) {
        stages.insert(stages.end(), of_component->stages().begin(), of_component->stages().end());
    }
    return true;
}

}  // namespace mq::triangulate

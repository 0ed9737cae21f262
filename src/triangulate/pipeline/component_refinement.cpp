// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/component_refinement.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/disjoint_sets.h"
#include "triangulate/components/equal_bodies.h"
#include "triangulate/components/mesh_components.h"
#include "triangulate/components/run_apart.h"
#include "triangulate/pipeline/component_work.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Components that are refined apart: enough for the cores of a large computer; each has tables of all CAD entities.
// Copies of bodies are as many further ones.
constexpr std::size_t kMostGroups = 64;
// Largest fraction of the work on one body: otherwise its steps gain more from several threads.
constexpr double kLargest = 0.75;

using ComponentWorks = std::vector<std::unique_ptr<ComponentWork>>;

// Whether components may be refined for themselves: a limit that the caller sets concerns all of them, and a record of
// angles and the paper's insertions have one order.
bool may_divide(const Workspace& work, const TriangulateOptions& options) {
    return !work.over_budget() && options.max_triangles == 0 && !options.record_angles &&
           options.insertion != Insertion::Circumcentre;
}

// Triangles of one volume, or of one face of the shape, must not cross: such faces are refined together.
std::vector<int> faces_together(const geometry::Topology& topology) {
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

// Estimates the number of triangles into which a triangle is divided. Edges over a surface that bends by k per mm get a
// length of sqrt(8 h / k) at the chord tolerance h, and of w / k at the largest turn w; bounds on edges are lengths
// themselves. Equilateral triangles with edges of length l have an area of 0.43 l^2.
double triangles_expected(const ClassifiedMesh& mesh, int triangle, const Sizing& sizing) {
    constexpr double kOfEquilateral = 0.25 * 1.7320508075688772;
    double bend = 0.0;
    double longest = std::numeric_limits<double>::infinity();
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const Vec3& normal = mesh.site(mesh.site_of(h)).normal;
        const Vec3& other = mesh.site(mesh.site_of(ClassifiedMesh::next(h))).normal;
        const double length = side_length(mesh, h);
        bend = length > 0.0 ? std::max(bend, angle_between(normal, other) / length) : bend;
        longest = sizing.bounds.any() ? std::min(longest, sizing.bounds.of(mesh, h)) : longest;
    }
    if (bend > 0.0) {
        longest = sizing.tolerance > 0.0 ? std::min(longest, std::sqrt(8.0 * sizing.tolerance / bend)) : longest;
        longest = sizing.turn > 0.0 ? std::min(longest, sizing.turn / bend) : longest;
    }
    const double area = 0.5 * doubled_area(mesh, triangle).norm();
    return 1.0 + area / (kOfEquilateral * longest * longest);
}

std::vector<double> work_expected(const ClassifiedMesh& mesh, const Sizing& sizing) {
    std::vector<double> work;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        work.push_back(triangles_expected(mesh, t, sizing));
    }
    return work;
}

// The faces of a body that have triangles, ascending.
std::vector<int> faces_of(const ClassifiedMesh& mesh, const MeshBody& body) {
    std::set<int> faces;
    for (const int t : body.triangles) {
        faces.insert(mesh.face_of(t));
    }
    return {faces.begin(), faces.end()};
}

/// Conditions besides geometry that decide how an entity is refined: local sizes, and whether it is in the mesh at all.
class LocalSizesByEntity {
  public:
    LocalSizesByEntity(const ClassifiedMesh& mesh, const std::vector<LocalSize>& sizes) {
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            if (mesh.vertex(v).entity[0] == 0) {
                in_mesh_[0].insert(mesh.vertex(v).entity[1]);
            }
        }
        for (int s = 0; s < mesh.segment_count(); ++s) {
            in_mesh_[1].insert(mesh.segment(s).edge);
        }
        for (const LocalSize& size : sizes) {
            sizes_[static_cast<std::size_t>(size.dimension)].emplace(size.index, size.max_edge);
        }
    }

    void add(geometry::Entity entity, geometry::Fingerprint& key) const {
        const auto d = static_cast<std::size_t>(entity.dimension);
        geometry::add_to(key, static_cast<int>(in_mesh_[d].count(entity.index)));
        const auto [first, last] = sizes_[d].equal_range(entity.index);
        for (auto size = first; size != last; ++size) {
            geometry::add_to(key, size->second);
        }
    }

  private:
    std::array<std::set<int>, 3> in_mesh_;  // by dimension; no faces, since bodies have those in the mesh only
    std::array<std::multimap<int, double>, 3> sizes_;
};

/// Refines the bodies of a mesh: each different one, and then its copies at their places.
class BodyRefinement {
  public:
    BodyRefinement(Refinement& whole, const ChordErrorCache& measured, std::vector<MeshBody> bodies)
        : whole_(whole), work_(whole.work()), measured_(measured), bodies_(std::move(bodies)) {
        std::vector<std::vector<int>> faces;
        for (const MeshBody& body : bodies_) {
            faces.push_back(faces_of(work_.mesh, body));
            work_expected_ += body.work;
        }
        const LocalSizesByEntity demands(work_.mesh, whole.options().local_sizes);
        equal_ = find_equal_bodies(work_.session, faces, [&](geometry::Entity entity, geometry::Fingerprint& key) {
            demands.add(entity, key);
        });
        originals_ = groups(false);
        copies_ = groups(true);
        for (const Group& group : copies_) {
            for (const int b : group) {
                has_copies_.insert(equal_.original[static_cast<std::size_t>(b)]);
            }
        }
        refined_.resize(bodies_.size());
    }

    /// @return none where all together would have more triangles than the budget
    ComponentWorks run() {
        ComponentWorks works(originals_.size());
        for_each(originals_, [&](const geometry::Session& session, const Progress& progress, std::size_t i) {
            works[i] = std::make_unique<ComponentWork>(component_of(work_.mesh, triangles_of(originals_[i]), &progress),
                                                       common(session, progress, originals_[i]));
            works[i]->run();
            cut_out(*works[i], originals_[i]);
        });
        if (over_budget(works) || count_triangles(works) + triangles_of_copies() > work_.budget) {
            return {};
        }
        std::vector<ComponentWorks> copies(copies_.size());
        for_each(copies_, [&](geometry::Session& session, const Progress& progress, std::size_t i) {
            copies[i] = place(session, progress, copies_[i]);
        });
        for (ComponentWorks& of_group : copies) {
            std::move(of_group.begin(), of_group.end(), std::back_inserter(works));
        }
        return over_budget(works) ? ComponentWorks() : std::move(works);
    }

  private:
    using Group = std::vector<int>;  // bodies

    std::vector<Group> groups(bool of_copies) const {
        std::vector<double> work;
        Group members;
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            if (is_copy(b) == of_copies) {
                members.push_back(static_cast<int>(b));
                work.push_back(bodies_[b].work);
            }
        }
        std::vector<Group> result = groups_of(work, kMostGroups);
        for (Group& group : result) {
            std::transform(group.begin(), group.end(), group.begin(),
                           [&](int i) { return members[static_cast<std::size_t>(i)]; });
        }
        return result;
    }

    // Samples are drawn for each body, a size field is another one at another place, and bodies with triangles from an
    // earlier run are nearly done: these are no copies.
    bool is_copy(std::size_t b) const {
        const std::vector<int>& triangles = bodies_[b].triangles;
        return equal_.original[b] >= 0 && whole_.options().method == Method::Refine &&
               whole_.options().size_field == nullptr && std::none_of(triangles.begin(), triangles.end(), [&](int t) {
                   return work_.settled.marked(work_.mesh, t);
               });
    }

    const MeshBody& body(int b) const { return bodies_[static_cast<std::size_t>(b)]; }

    std::vector<int> triangles_of(const Group& group) const {
        std::vector<int> triangles;
        for (const int b : group) {
            triangles.insert(triangles.end(), body(b).triangles.begin(), body(b).triangles.end());
        }
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    }

    // The budgets of all groups together are twice that of the whole, for any number of threads. Each has its share by
    // the expected work, and as much as every other one, since expected work is an estimate.
    ComponentWork::Common common(const geometry::Session& session, const Progress& progress, const Group& group) const {
        double work = 0.0;
        for (const int b : group) {
            work += body(b).work;
        }
        const double share = work / work_expected_ + 1.0 / static_cast<double>(originals_.size() + copies_.size());
        const auto budget = static_cast<std::size_t>(std::min(1.0, share) * static_cast<double>(work_.budget));
        return {whole_, measured_, session, progress, budget};
    }

    static std::size_t count_triangles(const ComponentWorks& works) {
        std::size_t triangles = 0;
        for (const auto& of_component : works) {
            triangles += of_component->work().triangles();
        }
        return triangles;
    }

    const RefinedBody& original_of(int copy) const {
        return refined_[static_cast<std::size_t>(equal_.original[static_cast<std::size_t>(copy)])];
    }

    std::size_t triangles_of_copies() const {
        std::size_t triangles = 0;
        for (const Group& group : copies_) {
            for (const int b : group) {
                triangles += static_cast<std::size_t>(original_of(b).mesh.triangle_count());
            }
        }
        return triangles;
    }

    bool over_budget(const ComponentWorks& works) const {
        return count_triangles(works) > work_.budget ||
               std::any_of(works.begin(), works.end(),
                           [](const auto& of_component) { return of_component->work().over_budget(); });
    }

    // Calls `refine(session, progress, index)` for groups, in parallel.
    template <typename Refine>
    void for_each(const std::vector<Group>& groups, const Refine& refine) {
        run_apart(work_.session, work_.progress, static_cast<int>(groups.size()),
                  [&](geometry::Session& session, const Progress& progress, int k) {
                      const auto i = static_cast<std::size_t>(k);
                      refine(session, progress, i);
                      for (const int b : groups[i]) {
                          done_ += body(b).triangles.size();
                      }
                      work_.progress.advance(static_cast<double>(done_) / static_cast<double>(work_.triangles()));
                  });
    }

    // Cuts out the bodies of a group that have copies.
    void cut_out(const ComponentWork& refined, const Group& group) {
        for (const int b : group) {
            if (has_copies_.count(b) > 0) {
                refined_[static_cast<std::size_t>(b)] = refined.body(faces_of(work_.mesh, body(b)));
            }
        }
    }

    // Places copies, whose triangles the budget has to allow together. Those that cannot be placed are refined by
    // themselves.
    ComponentWorks place(geometry::Session& session, const Progress& progress, const Group& group) const {
        PlacedBodies placed(equal_);
        Group others;
        for (const int b : group) {
            if (!placed.add(session, work_.grid, original_of(b), b, work_.mesh, body(b).triangles)) {
                others.push_back(b);
            }
        }
        ComponentWorks works;
        if (others.size() < group.size()) {
            works.push_back(std::make_unique<ComponentWork>(
                placed, ComponentWork::Common{whole_, measured_, session, progress, work_.budget}));
        }
        if (!others.empty()) {
            works.push_back(std::make_unique<ComponentWork>(component_of(work_.mesh, triangles_of(others), &progress),
                                                            common(session, progress, group)));
        }
        for (const auto& of_component : works) {
            of_component->run();
        }
        return works;
    }

    Refinement& whole_;
    Workspace& work_;
    const ChordErrorCache& measured_;
    std::vector<MeshBody> bodies_;
    double work_expected_ = 0.0;
    EqualBodies equal_;
    std::vector<Group> originals_;
    std::vector<Group> copies_;
    std::set<int> has_copies_;          // bodies
    std::vector<RefinedBody> refined_;  // by body: those with copies
    std::atomic<std::size_t> done_{0};  // triangles before refinement
};

void join_into(Refinement& whole, ChordErrorCache& measured, const ComponentWorks& works) {
    Workspace& work = whole.work();
    std::vector<const MeshComponent*> changed;
    for (const auto& of_component : works) {
        changed.push_back(&of_component->component());
    }
    JoinedComponents joined = join(work.mesh, changed, &work.progress);
    work.mesh = std::move(joined.mesh);
    work.maxmin.rebuild();
    measured.clear();
    work.exempt.clear();
    work.settled.clear();
    work.shrinks.resize(static_cast<std::size_t>(work.mesh.vertex_count()), 0);
    for (std::size_t i = 0; i < works.size(); ++i) {
        work.progress.check();
        works[i]->write_to(work, measured, joined.first[i], joined.vertices[i]);
    }
}

}  // namespace

bool refine_components(Refinement& whole, ChordErrorCache& measured, StageTimes& stages) {
    Workspace& work = whole.work();
    if (!may_divide(work, whole.options())) {
        return false;
    }
    const std::vector<double> expected = work_expected(work.mesh, whole.sizing());
    std::vector<MeshBody> bodies = bodies_of(work.mesh, faces_together(work.session.topology()), expected);
    if (bodies.empty() || bodies.front().work > kLargest * std::accumulate(expected.begin(), expected.end(), 0.0)) {
        return false;
    }
    work.progress.stage("refining bodies", share_before_refinement(whole.options()), 0.9);
    const ComponentWorks works = BodyRefinement(whole, measured, std::move(bodies)).run();
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

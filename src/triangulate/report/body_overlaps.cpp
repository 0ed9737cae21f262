// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/body_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/key_set.h"
#include "base/parallel.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/surface_winding.h"

namespace mq::triangulate {

namespace {

using mesh::BodyOverlap;
using Volumes = std::pair<int, int>;  // in ascending order

/// The queries of a solid: whether a point is in it, and how far from its surface.
struct Surface {
    Surface(const mesh::TriangleMesh& mesh, const std::vector<int>& numbers)
        : triangles(taken(mesh, numbers)), winding(mesh.vertices, triangles), tree(mesh.vertices, triangles) {}

    static std::vector<mesh::Triangle> taken(const mesh::TriangleMesh& mesh, const std::vector<int>& numbers) {
        std::vector<mesh::Triangle> found;
        for (const int t : numbers) {
            found.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
        }
        return found;
    }

    std::vector<mesh::Triangle> triangles;
    mesh::SurfaceWinding winding;
    mesh::NearestTree tree;
};

struct Solid {
    std::vector<int> triangles;
    Box box;
    double volume = 0.0;  ///< mm^3
    std::unique_ptr<Surface> surface;
    std::once_flag once;  ///< the thread makes the surface that asks for it first
};

class Overlaps {
  public:
    Overlaps(const Workspace& work, const std::vector<FaceContact>& contacts, const Output& out, double deviation)
        : work_(work),
          topology_(work.session.topology()),
          mesh_(out.mesh),
          source_(out.source),
          contacts_(contacts),
          near_(2.0 * (deviation + work.grid.resolution())) {}

    std::vector<BodyOverlap> find() {
        add_solids();
        add_contacts();
        std::vector<BodyOverlap> found;
        for (const auto& [volumes, contact] : worst_) {
            if (contact != BodyContact::Touching) {
                add(volumes,
                    contact == BodyContact::Apart ? BodyOverlap::Kind::Near
                    : equal(volumes)              ? BodyOverlap::Kind::Equal
                                                  : BodyOverlap::Kind::Overlapping,
                    found);
            }
        }
        const std::vector<Volumes> near = near_pairs();
        std::vector<Volumes> inside(near.size(), {-1, -1});
        parallel_for(static_cast<int>(near.size()), [&](int k) {
            work_.progress.check();
            const auto [a, b] = near[static_cast<std::size_t>(k)];
            for (const Volumes& order : {Volumes{a, b}, Volumes{b, a}}) {
                if (in_other(order.first, order.second)) {
                    inside[static_cast<std::size_t>(k)] = order;
                    break;
                }
            }
        });
        for (const Volumes& order : inside) {
            if (order.first >= 0) {
                add(order, BodyOverlap::Kind::Inside, found);
            }
        }
        return found;
    }

  private:
    void add_solids() {
        std::map<int, int> volume_of;
        for (std::size_t v = 0; v < topology_.volumes.size(); ++v) {
            if (topology_.volumes[v].solid >= 0) {
                volume_of[topology_.volumes[v].solid] = static_cast<int>(v);
            }
        }
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (const int solid = mesh_.triangle_solid[t]; solid >= 0) {
                Solid& own = solids_[volume_of.at(solid)];
                own.triangles.push_back(static_cast<int>(t));
                const auto [a, b, c] = corners(static_cast<int>(t));
                own.volume += a.dot(b.cross(c)) / 6.0;
                for (const Vec3& p : {a, b, c}) {
                    own.box.add(p);
                }
            }
        }
    }

    // Pairs of solids whose boxes meet, and that are not known to overlap.
    std::vector<Volumes> near_pairs() const {
        std::vector<Volumes> pairs;
        for (auto a = solids_.begin(); a != solids_.end(); ++a) {
            for (auto b = std::next(a); b != solids_.end(); ++b) {
                const auto known = worst_.find({a->first, b->first});
                if (a->second.box.meets(b->second.box) &&
                    (known == worst_.end() || known->second == BodyContact::Touching)) {
                    pairs.emplace_back(a->first, b->first);
                }
            }
        }
        return pairs;
    }

    void add_contacts() {
        for (const FaceContact& contact : contacts_) {
            for (const auto& [volumes, how] : contact.contacts) {
                BodyContact& worst = worst_[volumes];
                worst = std::max(worst, how);
                for (const auto& pair : contact.pairs) {
                    for (const int t : pair) {
                        crossing_[volumes].insert(static_cast<std::uint64_t>(t));
                    }
                }
            }
        }
    }

    std::array<Vec3, 3> corners(int t) const {
        const mesh::Triangle& own = mesh_.triangles[static_cast<std::size_t>(t)];
        const auto at = [&](int i) {
            return mesh_.vertices[static_cast<std::size_t>(own[static_cast<std::size_t>(i)])];
        };
        return {at(0), at(1), at(2)};
    }

    std::string name_of(int volume) const {
        const geometry::Volume& own = topology_.volumes[static_cast<std::size_t>(volume)];
        return own.solid >= 0 ? "Solid" + std::to_string(own.solid + 1)
                              : topology_.name_of({2, own.sides.front().face});
    }

    void add(const Volumes& volumes, BodyOverlap::Kind kind, std::vector<BodyOverlap>& found) const {
        found.push_back({{name_of(volumes.first), name_of(volumes.second)}, kind});
    }

    // Whether two solids that overlap have meshes of the same size, box and volume, but for rounding.
    bool equal(const Volumes& volumes) const {
        const auto a = solids_.find(volumes.first);
        const auto b = solids_.find(volumes.second);
        if (a == solids_.end() || b == solids_.end()) {
            return false;
        }
        constexpr double kSameVolume = 1e-6;
        const double volume = a->second.volume;
        const double rounding = 2.0 * work_.grid.resolution();
        return a->second.triangles.size() == b->second.triangles.size() &&
               (a->second.box.low - b->second.box.low).norm() <= rounding &&
               (a->second.box.high - b->second.box.high).norm() <= rounding &&
               std::abs(volume - b->second.volume) <= kSameVolume * std::abs(volume);
    }

    Surface& surface_of(int volume) {
        Solid& solid = solids_.at(volume);
        std::call_once(solid.once, [&] { solid.surface = std::make_unique<Surface>(mesh_, solid.triangles); });
        return *solid.surface;
    }

    // Whether a triangle of a solid crosses one of the other, or is in the place of one.
    bool meets(int t, const KeySet* crossing, int other) const {
        if (!mesh_.triangle_opposite.empty()) {
            const std::int32_t opposite = mesh_.triangle_opposite[static_cast<std::size_t>(t)];
            if (opposite >= 0 && mesh_.triangle_solid[static_cast<std::size_t>(opposite)] ==
                                     topology_.volumes[static_cast<std::size_t>(other)].solid) {
                return true;
            }
        }
        return crossing != nullptr &&
               crossing->count(static_cast<std::uint64_t>(source_[static_cast<std::size_t>(t)])) > 0;
    }

    // The sets of connected triangles of a solid without the triangles that meet the other one; each triangle that does
    // is a set of its own.
    std::vector<std::vector<int>> parts_of(const Solid& solid, const KeySet* crossing, int other) const {
        KeyMap<int> first;  // by vertex: one of its triangles, as an index in the list
        DisjointSets<int> joined(solid.triangles.size());
        for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
            if (meets(solid.triangles[i], crossing, other)) {
                continue;
            }
            for (const std::int32_t v : mesh_.triangles[static_cast<std::size_t>(solid.triangles[i])]) {
                const auto vertex = static_cast<std::uint64_t>(v);
                joined.unite(first.emplace(vertex, static_cast<int>(i)).first->second, static_cast<int>(i));
            }
        }
        std::vector<int> place(solid.triangles.size(), -1);  // by representative: where its set is
        std::vector<std::vector<int>> found;
        for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
            int& own = place[static_cast<std::size_t>(joined.find(static_cast<int>(i)))];
            if (own < 0) {
                own = static_cast<int>(found.size());
                found.emplace_back();
            }
            found[static_cast<std::size_t>(own)].push_back(solid.triangles[i]);
        }
        return found;
    }

    double area_of(int t) const {
        const auto [a, b, c] = corners(t);
        return (b - a).cross(c - a).norm();
    }

    // Whether anything of a solid lies in another one, deeper than chords explain where the two meet.
    bool in_other(int volume, int other) {
        const Solid& solid = solids_.at(volume);
        const Solid& around = solids_.at(other);
        const auto known = crossing_.find(std::minmax(volume, other));
        const KeySet* crossing = known != crossing_.end() ? &known->second : nullptr;
        const bool meeting = crossing != nullptr || share(volume, other);
        if (!meeting) {
            return within(solid.box, around.box) && is_inside(solid.triangles, other, 4.0 * work_.grid.resolution());
        }
        Box common;  // the intersection of the solids is inside of it
        common.low = solid.box.low.cwiseMax(around.box.low);
        common.high = solid.box.high.cwiseMin(around.box.high);
        if ((common.high - common.low).minCoeff() <= near_) {
            return false;
        }
        const std::vector<std::vector<int>> parts = parts_of(solid, crossing, other);
        return std::any_of(parts.begin(), parts.end(), [&](const std::vector<int>& part) {
            Box box;
            for (const int t : part) {
                for (const Vec3& p : corners(t)) {
                    box.add(p);
                }
            }
            return within(box, around.box) && is_inside(part, other, near_);
        });
    }

    bool share(int volume, int other) const {
        return !mesh_.triangle_opposite.empty() &&
               std::any_of(solids_.at(volume).triangles.begin(), solids_.at(volume).triangles.end(),
                           [&](int t) { return meets(t, nullptr, other); });
    }

    bool within(const Box& box, const Box& around) const {
        return ((box.low - around.low).array() >= -near_).all() && ((around.high - box.high).array() >= -near_).all();
    }

    // Decided at the middle of the largest one of these triangles whose middle is farther than `beyond` from the
    // surface.
    bool is_inside(std::vector<int> triangles, int other, double beyond) {
        constexpr std::size_t kTried = 16;
        const std::size_t tried = std::min(kTried, triangles.size());
        std::partial_sort(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(tried), triangles.end(),
                          [&](int s, int t) { return area_of(s) > area_of(t); });
        Surface& surface = surface_of(other);
        for (std::size_t k = 0; k < tried; ++k) {
            const auto [a, b, c] = corners(triangles[k]);
            const Vec3 middle = (a + b + c) / 3.0;
            if (surface.tree.any_within(middle, beyond, 0) < 0) {
                return surface.winding.at(middle) > 0.5;
            }
        }
        return false;
    }

    const Workspace& work_;
    const geometry::Topology& topology_;
    const mesh::TriangleMesh& mesh_;
    const std::vector<int>& source_;
    const std::vector<FaceContact>& contacts_;
    double near_;                           // mm: depth by which meshes of bodies that touch may cross
    std::map<int, Solid> solids_;           // by volume
    std::map<Volumes, BodyContact> worst_;  // pairs whose triangles cross, and how they are in contact
    std::map<Volumes, KeySet> crossing_;    // triangles of the working mesh
};

}  // namespace

std::vector<BodyOverlap> body_overlaps(const Workspace& work, const std::vector<FaceContact>& contacts,
                                       const Output& out, double deviation) {
    return Overlaps(work, contacts, out, deviation).find();
}

}  // namespace mq::triangulate

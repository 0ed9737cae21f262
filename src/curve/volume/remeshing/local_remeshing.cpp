// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/remeshing/local_remeshing.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/tetrahedralise.h"

namespace mq::curve {

using elements::face_key;
using elements::FaceKey;

namespace {

/// Most layers by which cavities grow before their whole volume is filled anew.
constexpr int kMostLayers = 4;

using Corners = std::array<int, 3>;

/// The triangles around a cavity, seen from outside of it.
struct Cavity {
    int volume = -1;
    std::vector<Corners> border;
};

bool closed(const std::vector<Corners>& triangles) {
    std::map<std::pair<int, int>, int> balance;
    for (const Corners& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k];
            const int b = t[(k + 1) % 3];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

class Remesher {
  public:
    Remesher(CurvedSurface& surface, std::size_t triangles_before, const TetrahedraInside& inside,
             double grading_factor, LocalRemeshing& done, const Progress& progress)
        : surface_(surface),
          triangles_before_(triangles_before),
          inside_(inside),
          grading_factor_(grading_factor),
          done_(done),
          progress_(progress),
          stale_(inside.corners.size(), 0) {
        for (std::size_t t = 0; t < inside.corners.size(); ++t) {
            for (const Corners& face : outward_faces(inside.corners[t])) {
                at_face_[face_key(face[0], face[1], face[2])].push_back(t);
            }
            for (const int v : inside.corners[t]) {
                at_vertex_[v].push_back(t);
            }
        }
    }

    /// Removes the tetrahedra that no longer fit the surface.
    void remove_unfit() {
        find_changes();
        for (std::size_t t = 0; t < stale_.size(); ++t) {
            stale_[t] = no_longer_fits(inside_.corners[t]) ? 1 : 0;
        }
        // Any inner vertex of an inverted tetrahedron may be the one that is misplaced.
        for (std::size_t t = 0; t < stale_.size(); ++t) {
            for (const int v : inside_.corners[t]) {
                const bool inner = surface_.shapes.vertices[static_cast<std::size_t>(v)].entity[0] == 3;
                if (inner && inverted(inside_.corners[t])) {
                    for (const std::size_t other : at_vertex_.at(v)) {
                        stale_[other] = 1;
                    }
                }
            }
        }
    }

    /// Removes tetrahedra with layers of those that have a vertex of theirs.
    void remove_around(const std::vector<std::size_t>& centres, int layers) {
        find_changes();
        std::vector<std::size_t> front = centres;
        for (int layer = 0; layer <= layers; ++layer) {
            std::vector<std::size_t> next;
            for (const std::size_t t : front) {
                stale_[t] = 1;
                for (const int v : inside_.corners[t]) {
                    for (const std::size_t other : at_vertex_.at(v)) {
                        if (!stale_[other] && layer < layers) {
                            stale_[other] = 1;
                            next.push_back(other);
                        }
                    }
                }
            }
            front = std::move(next);
        }
    }

    /// Fills the cavities anew.
    TetrahedralMesh fill_cavities() {
        std::vector<std::pair<Cavity, tetrahedralise::Tetrahedra>> filled;
        for (int layer = 0;; ++layer) {
            filled.clear();
            for (Cavity& cavity : cavities()) {
                filled.emplace_back(std::move(cavity), tetrahedralise::Tetrahedra());
            }
            std::vector<std::optional<Message>> faults(filled.size());
            parallel_for(static_cast<int>(filled.size()), [&](int k) {
                progress_.check();
                auto& [cavity, filling] = filled[static_cast<std::size_t>(k)];
                try {
                    filling = filling_of(cavity);
                } catch (const tetrahedralise::MeshingFailed& error) {
                    faults[static_cast<std::size_t>(k)] = error.message();
                }
            });
            bool grown = false;
            for (std::size_t k = 0; k < filled.size(); ++k) {
                const Cavity& cavity = filled[k].first;
                if (faults[k] && !grow(cavity, layer)) {
                    throw tetrahedralise::MeshingFailed(
                        phrases::kNotFilledAnew,
                        {{"solid", "Solid" + std::to_string(cavity.volume + 1)}, {"phrase", *faults[k]}});
                }
                grown = grown || faults[k];
            }
            if (!grown) {
                return assembled(filled);
            }
        }
    }

  private:
    const Vec3& point(int v) const { return surface_.shapes.vertices[static_cast<std::size_t>(v)].point; }

    void find_changes() {
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            const SurfaceTriangle& triangle = surface_.triangles[t];
            if (triangle.alive) {
                const Corners& v = triangle.corners;
                alive_.emplace(face_key(v[0], v[1], v[2]), static_cast<int>(t));
            }
        }
        for (std::size_t t = 0; t < triangles_before_; ++t) {
            const Corners& v = surface_.triangles[t].corners;
            const FaceKey key = face_key(v[0], v[1], v[2]);
            was_.insert(key);
            if (alive_.count(key) > 0) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                if (!surface_.has_edge(v[k], v[(k + 1) % 3])) {
                    gone_edges_.insert(pair_key(v[k], v[(k + 1) % 3]));
                }
                if (surface_.triangles_of_vertex(v[k]).empty()) {
                    gone_vertices_.insert(v[k]);
                }
            }
        }
        for (const auto& [key, t] : alive_) {
            if (was_.count(key) == 0) {
                new_triangles_.push_back(t);
            }
        }
    }

    bool no_longer_fits(const std::array<int, 4>& v) const {
        for (const Corners& face : outward_faces(v)) {
            const FaceKey key = face_key(face[0], face[1], face[2]);
            if (was_.count(key) > 0 && alive_.count(key) == 0) {
                return true;
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (gone_vertices_.count(v[i]) > 0) {
                return true;
            }
            for (std::size_t k = i + 1; k < 4; ++k) {
                if (gone_edges_.count(pair_key(v[i], v[k])) > 0) {
                    return true;
                }
            }
        }
        return inverted(v);
    }

    bool inverted(const std::array<int, 4>& v) const {
        return !((point(v[1]) - point(v[0])).cross(point(v[2]) - point(v[0])).dot(point(v[3]) - point(v[0])) > 0.0);
    }

    /// The borders of all cavities: faces of removed tetrahedra that stay, and new triangles of the surface.
    std::vector<Cavity> cavities() const {
        std::map<int, std::map<FaceKey, Corners>> border;  // by volume
        const auto add = [&](int volume, const Corners& face) {
            auto& faces = border[volume];
            const FaceKey key = face_key(face[0], face[1], face[2]);
            // A new triangle that was a face inside has the cavity on no side of it.
            if (!faces.emplace(key, face).second) {
                faces.erase(key);
            }
        };
        for (std::size_t t = 0; t < stale_.size(); ++t) {
            for (const Corners& face : outward_faces(inside_.corners[t])) {
                if (stale_[t] && stays(face, t)) {
                    add(inside_.volume[t], face);
                }
            }
        }
        for (std::size_t v = 0; v < surface_.volume_faces.size() && !new_triangles_.empty(); ++v) {
            if (!has_tetrahedra(static_cast<int>(v))) {
                continue;
            }
            for (const auto& [face, flipped] : surface_.volume_faces[v]) {
                for (const int t : new_triangles_) {
                    const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
                    if (triangle.face == face) {
                        Corners corners = triangle.corners;
                        if (flipped) {
                            std::swap(corners[1], corners[2]);
                        }
                        add(static_cast<int>(v), corners);
                    }
                }
            }
        }
        std::vector<Cavity> result;
        for (const auto& [volume, faces] : border) {
            append_parts(volume, faces, result);
        }
        return result;
    }

    bool has_tetrahedra(int volume) const {
        return std::find(inside_.volume.begin(), inside_.volume.end(), volume) != inside_.volume.end();
    }

    /// Whether a face of a removed tetrahedron bounds its cavity.
    bool stays(const Corners& face, std::size_t t) const {
        const FaceKey key = face_key(face[0], face[1], face[2]);
        if (was_.count(key) > 0) {
            return alive_.count(key) > 0;
        }
        const auto& two = at_face_.at(key);
        return std::none_of(two.begin(), two.end(), [&](std::size_t other) { return other != t && stale_[other]; });
    }

    /// Triangles of a border that are joined by edges are around one cavity.
    static void append_parts(int volume, const std::map<FaceKey, Corners>& faces, std::vector<Cavity>& result) {
        std::vector<Corners> list;
        for (const auto& [key, face] : faces) {
            list.push_back(face);
        }
        DisjointSets<std::size_t> joined(list.size());
        std::unordered_map<elements::EdgeKey, std::size_t> first;
        for (std::size_t i = 0; i < list.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [known, fresh] = first.emplace(pair_key(list[i][k], list[i][(k + 1) % 3]), i);
                joined.unite(known->second, i);
            }
        }
        std::size_t count = 0;
        const std::vector<std::size_t> number = joined.number(count);
        const std::size_t before = result.size();
        result.resize(before + count);
        for (std::size_t i = 0; i < list.size(); ++i) {
            result[before + number[i]].volume = volume;
            result[before + number[i]].border.push_back(list[i]);
        }
    }

    tetrahedralise::Tetrahedra filling_of(const Cavity& cavity) const {
        if (!closed(cavity.border)) {
            throw tetrahedralise::MeshingFailed(phrases::kSurfaceNotClosed);
        }
        std::vector<Vec3> points;
        std::unordered_map<int, int> number;
        std::vector<Corners> triangles;
        for (const Corners& face : cavity.border) {
            Corners own{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [known, fresh] = number.emplace(face[k], static_cast<int>(points.size()));
                if (fresh) {
                    points.push_back(point(face[k]));
                }
                own[k] = known->second;
            }
            triangles.push_back(own);
        }
        tetrahedralise::Tetrahedra filling =
            tetrahedralise::tetrahedralise(points, triangles, {grading_factor_, nullptr}, progress_);
        std::vector<int> vertex(points.size());
        for (const auto& [v, own] : number) {
            vertex[static_cast<std::size_t>(own)] = v;
        }
        // Points of the border get the surface's numbers; inner points have no number yet and stay below 0.
        for (auto& t : filling.tetrahedra) {
            for (int& v : t) {
                const auto index = static_cast<std::size_t>(v);
                v = index < vertex.size() ? vertex[index] : -1 - static_cast<int>(index - vertex.size());
            }
        }
        return filling;
    }

    /// Removes the tetrahedra around a cavity, too.
    /// @return whether these are any.
    bool grow(const Cavity& cavity, int layer) {
        bool any = false;
        const auto remove = [&](std::size_t t) {
            if (!stale_[t] && inside_.volume[t] == cavity.volume) {
                stale_[t] = 1;
                any = true;
            }
        };
        if (layer >= kMostLayers) {
            for (std::size_t t = 0; t < stale_.size(); ++t) {
                remove(t);
            }
            return any;
        }
        for (const Corners& face : cavity.border) {
            for (const int v : face) {
                const auto met = at_vertex_.find(v);
                if (met != at_vertex_.end()) {
                    std::for_each(met->second.begin(), met->second.end(), remove);
                }
            }
        }
        return any;
    }

    /// Removes the shapes of mesh edges and faces that only removed tetrahedra have.
    void forget_shapes_inside(const std::array<int, 4>& v, const TetrahedralMesh& mesh) {
        const auto removed = [&](std::size_t t) { return stale_[t] != 0; };
        for (const Corners& face : outward_faces(v)) {
            const auto& two = at_face_.at(face_key(face[0], face[1], face[2]));
            if (!mesh.fixed_face(face[0], face[1], face[2]) && std::all_of(two.begin(), two.end(), removed)) {
                surface_.shapes.forget_face(face);
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = i + 1; k < 4; ++k) {
                const auto& around = at_vertex_.at(v[i]);
                const bool gone = std::all_of(around.begin(), around.end(), [&](std::size_t t) {
                    const auto& corners = inside_.corners[t];
                    return removed(t) || std::find(corners.begin(), corners.end(), v[k]) == corners.end();
                });
                if (gone && !mesh.fixed_edge(v[i], v[k])) {
                    surface_.shapes.forget_edge(v[i], v[k]);
                }
            }
        }
    }

    TetrahedralMesh assembled(const std::vector<std::pair<Cavity, tetrahedralise::Tetrahedra>>& filled) {
        TetrahedralMesh mesh(surface_);
        for (std::size_t t = 0; t < stale_.size(); ++t) {
            if (stale_[t]) {
                ++done_.removed;
                forget_shapes_inside(inside_.corners[t], mesh);
            } else {
                mesh.add(inside_.corners[t], inside_.volume[t]);
            }
        }
        for (const auto& [cavity, filling] : filled) {
            std::vector<int> inner;
            for (const Vec3& p : filling.inner_points) {
                inner.push_back(mesh.add_vertex(p, cavity.volume));
            }
            for (std::array<int, 4> t : filling.tetrahedra) {
                for (int& v : t) {
                    v = v < 0 ? inner[static_cast<std::size_t>(-1 - v)] : v;
                }
                mesh.add(t, cavity.volume);
                ++done_.added;
            }
            ++done_.cavities;
        }
        return mesh;
    }

    CurvedSurface& surface_;
    std::size_t triangles_before_;
    const TetrahedraInside& inside_;
    double grading_factor_;
    LocalRemeshing& done_;
    const Progress& progress_;
    std::vector<char> stale_;
    std::map<FaceKey, std::vector<std::size_t>> at_face_;
    std::unordered_map<int, std::vector<std::size_t>> at_vertex_;
    std::map<FaceKey, int> alive_;  // triangles of the surface
    std::set<FaceKey> was_;         // triangles before the repair
    std::vector<int> new_triangles_;
    std::unordered_set<elements::EdgeKey> gone_edges_;
    std::unordered_set<int> gone_vertices_;
};

}  // namespace

TetrahedralMesh remesh_locally(CurvedSurface& surface, std::size_t triangles_before, const TetrahedraInside& inside,
                               LocalRemeshing& done, const Progress& progress) {
    Remesher remesher(surface, triangles_before, inside, 1.0, done, progress);
    remesher.remove_unfit();
    return remesher.fill_cavities();
}

namespace {

/// Removes the tetrahedra that are not valid, with `layers` of others around them, and fills their cavities anew.
/// Shapes of mesh edges and faces in the cavities are forgotten.
TetrahedralMesh remesh_invalid(const TetrahedralMesh& volume, CurvedSurface& surface, int layers, double grading_factor,
                               LocalRemeshing& done, const Progress& progress) {
    TetrahedraInside inside;
    std::vector<std::size_t> invalid;
    const FoldedTriangles folded(surface);
    for (const int t : volume.live_tetrahedra()) {
        const Tetrahedron& tetrahedron = volume.tetrahedra[static_cast<std::size_t>(t)];
        if (!(tetrahedron.quality > 0.0) && !folded.has_face_of(tetrahedron.corners)) {
            invalid.push_back(inside.corners.size());
        }
        inside.corners.push_back(tetrahedron.corners);
        inside.volume.push_back(tetrahedron.volume);
    }
    Remesher remesher(surface, surface.triangles.size(), inside, grading_factor, done, progress);
    remesher.remove_around(invalid, layers);
    return remesher.fill_cavities();
}

/// Invalid tetrahedra that are not on folded triangles of the surface, which fold any tetrahedron on them.
std::size_t repairable(const TetrahedralMesh& volume) {
    const FoldedTriangles folded(volume.surface);
    const auto& all = volume.tetrahedra;
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const Tetrahedron& t) {
        return t.alive && !(t.quality > 0.0) && !folded.has_face_of(t.corners);
    }));
}

}  // namespace

void remesh_and_repair(std::optional<TetrahedralMesh>& volume, CurvedSurface& surface, RepairScope scope,
                       LocalRemeshing& done, const Progress& progress) {
    constexpr std::array<double, 3> kGradingFactors{1.0, 0.5, 0.2};
    for (std::size_t i = 0; i < kGradingFactors.size(); ++i) {
        const std::size_t before = repairable(*volume);
        if (before == 0) {
            return;
        }
        CurvedSurface kept = surface;
        const std::vector<Tetrahedron> tetrahedra = volume->tetrahedra;
        LocalRemeshing tried;
        try {
            volume.emplace(
                remesh_invalid(*volume, surface, static_cast<int>(i) + 1, kGradingFactors[i], tried, progress));
            repair_volume(*volume, progress, scope);
            if (repairable(*volume) < before) {
                done.cavities += tried.cavities;
                continue;
            }
        } catch (const tetrahedralise::MeshingFailed&) {  // the former tetrahedra are as good
        }
        surface = std::move(kept);
        volume.emplace(surface, tetrahedra);
    }
}

}  // namespace mq::curve

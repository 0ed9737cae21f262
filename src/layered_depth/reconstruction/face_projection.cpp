// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/face_projection.h"

#include <algorithm>
#include <cmath>

#include "base/tuning.h"
#include "boolean/points_on_faces.h"
#include "mesh/quality/surface_verification.h"

namespace mq::layered_depth {

using boolean::MovedVertex;

namespace {

using FaceConstraint = boolean::SurfaceConstraint;

/// A vertex counts as on its faces up to this distance, as a fraction of the grid's side: the resolution of single
/// precision.
constexpr double kOnFaces = 2e-7;
/// Largest move of a vertex, in units of the distance between rays.
constexpr double kFarthest = 0.5;
/// Largest move of a border vertex, in deviations of the meshes from the faces, which were measured at samples only.
constexpr double kDeviations = 2.0;
/// Contacts that are examined in a round.
constexpr std::size_t kListed = 100'000;
/// More than this number of faces have no point in common.
constexpr std::size_t kMostFaces = 3;
/// Two sides that are farther apart than this, in units of the distance between rays, are those of a wall or gap;
/// surfaces in contact are nearer.
constexpr double kThin = 0.1;
/// Sine of the angle below which two faces count as meeting smoothly, as the place of their edge is uncertain.
constexpr double kSmooth = 0.1;

class FaceProjector {
  public:
    FaceProjector(RetainedSurface& surface, const OperandSet& pair, const SampleGrid& grid, const Vec3& origin,
                  const std::vector<CadShape>& shapes, geometry::Engine& engine, const Progress* progress)
        : progress_(progress),
          surface_(surface),
          pair_(pair),
          spacing_(grid.spacing()),
          farthest_(kFarthest * grid.spacing()),
          on_faces_(kOnFaces * grid.spacing() * grid.cells()),
          intersections_(engine, shapes, origin, kSmooth, progress) {
        for (const CadShape& shape : shapes) {
            if (shape.model) {
                from_mesh_ = std::max(from_mesh_, kDeviations * shape.chord_height);
            }
        }
    }

    void find(const Octree& tree, const std::vector<std::int32_t>& vertices);
    void approach() {
        intersections_.approach(moved_, on_faces_, [this] { drop_smooth(); });
    }
    void retry_with_nearest();
    FaceProjection apply(const std::vector<mesh::Triangle>& reconstructed);

  private:
    void add(std::int32_t vertex, const std::vector<std::int32_t>& triangles);
    void drop_smooth();
    bool arrived(const MovedVertex& moved) const {
        return !moved.lost && moved.distance() <= on_faces_ && (moved.now - moved.before).norm() <= moved.farthest;
    }
    bool turns_over(const mesh::Triangle& t) const;
    void undo_contacts(const std::vector<mesh::Triangle>& reconstructed);

    const Progress* progress_;
    RetainedSurface& surface_;
    const OperandSet& pair_;
    double spacing_, farthest_, on_faces_;
    double from_mesh_ = 0.0;           ///< mm: largest distance of the meshes from the faces
    std::vector<std::uint8_t> stays_;  // by point: whether an unchanged triangle of an operand has it
    boolean::FaceIntersections intersections_;
    std::vector<MovedVertex> moved_;
    std::vector<std::int32_t> moved_of_;  // by point: its index in moved_; -1: it stays
};

void FaceProjector::add(std::int32_t vertex, const std::vector<std::int32_t>& triangles) {
    if (stays_[vertex] != 0 || moved_of_[vertex] >= 0 || triangles.empty()) {
        return;
    }
    // Border vertices lie on triangles of the meshes, not on tangent planes of the faces.
    const double farthest = surface_.on_border[vertex] != 0 ? std::max(farthest_, from_mesh_) : farthest_;
    MovedVertex moved{vertex, surface_.points[vertex], surface_.points[vertex], farthest, {}};
    for (const std::int32_t triangle : triangles) {
        const FaceConstraint face{pair_.operand_of(triangle), pair_.face[triangle]};
        const bool known = std::any_of(moved.surfaces.begin(), moved.surfaces.end(), [&](const FaceConstraint& other) {
            return other.operand == face.operand && other.face == face.face;
        });
        if (face.face < 0 || (!known && moved.surfaces.size() == kMostFaces)) {
            return;
        }
        if (!known) {
            moved.surfaces.push_back(face);
        }
    }
    moved_of_[vertex] = static_cast<std::int32_t>(moved_.size());
    moved_.push_back(std::move(moved));
}

/// Collects the vertices with the faces of the samples in their cells. Border vertices that stitching left get the
/// faces of the triangles that have them.
void FaceProjector::find(const Octree& tree, const std::vector<std::int32_t>& vertices) {
    stays_.assign(surface_.points.size(), 0);
    std::vector<std::vector<std::int32_t>> around(surface_.points.size());
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
        for (const std::int32_t p : surface_.triangles[t]) {
            if (surface_.source[t] >= 0) {
                stays_[p] = 1;
            } else {
                around[p].push_back(surface_.lies_on[t]);
            }
        }
    }
    moved_of_.assign(surface_.points.size(), -1);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (vertices[k] >= 0) {
            const auto& found = tree.sheets[k].face_triangles;
            add(vertices[k], {found.begin(), std::find(found.begin(), found.end(), -1)});
        }
    }
    for (std::size_t p = 0; p < around.size(); ++p) {
        add(static_cast<std::int32_t>(p), around[p]);
    }
}

/// Removes one of two faces that meet smoothly: the one that does not contain the point, or the one that is farther
/// away.
void FaceProjector::drop_smooth() {
    for (MovedVertex& moved : moved_) {
        for (std::size_t i = 0; i < moved.surfaces.size() && !moved.lost; ++i) {
            for (std::size_t k = i + 1; k < moved.surfaces.size();) {
                const FaceConstraint &a = moved.surfaces[i], &b = moved.surfaces[k];
                if (a.normal.cross(b.normal).norm() >= kSmooth) {
                    ++k;
                    continue;
                }
                const double apart = std::abs(a.normal.dot(a.foot - b.foot));
                if (apart > kThin * spacing_ && (a.operand != b.operand || a.normal.dot(b.normal) < 0.0)) {
                    moved.lost = true;  // one vertex stands for both sides, and can lie on one only
                    moved.surfaces.clear();
                    break;
                }
                const bool first = intersections_.contains(a), second = intersections_.contains(b);
                const bool keep_first = first != second ? first : a.distance(moved.now) <= b.distance(moved.now);
                moved.surfaces[i] = keep_first ? a : b;
                moved.surfaces.erase(moved.surfaces.begin() + static_cast<std::ptrdiff_t>(k));
            }
        }
    }
}

void FaceProjector::retry_with_nearest() {
    std::vector<MovedVertex*> active;
    for (MovedVertex& moved : moved_) {
        if (!arrived(moved) && moved.surfaces.size() > 1) {
            moved.now = moved.before;
            moved.lost = false;
            for (FaceConstraint& face : moved.surfaces) {
                face.asked = false;
            }
            active.push_back(&moved);
        }
    }
    intersections_.project(active);
    for (MovedVertex* moved : active) {
        if (moved->lost) {
            continue;
        }
        const auto nearest = std::min_element(moved->surfaces.begin(), moved->surfaces.end(),
                                              [&](const FaceConstraint& a, const FaceConstraint& b) {
                                                  return a.distance(moved->now) < b.distance(moved->now);
                                              });
        moved->surfaces = {FaceConstraint(*nearest)};
        moved->now = moved->surfaces.front().foot;
    }
}

bool FaceProjector::turns_over(const mesh::Triangle& t) const {
    std::array<Vec3, 3> before, now;
    bool any = false;
    for (int i = 0; i < 3; ++i) {
        const std::int32_t k = moved_of_[t[i]];
        now[i] = surface_.points[t[i]];
        before[i] = k < 0 ? now[i] : moved_[k].before;
        any = any || now[i] != before[i];
    }
    return any &&
           (before[1] - before[0]).cross(before[2] - before[0]).dot((now[1] - now[0]).cross(now[2] - now[0])) <= 0.0;
}

/// Undoes the moves of vertices whose triangles touch or cross others after the moves.
void FaceProjector::undo_contacts(const std::vector<mesh::Triangle>& reconstructed) {
    std::vector<mesh::Triangle> all = surface_.triangles;
    all.insert(all.end(), reconstructed.begin(), reconstructed.end());
    std::vector<std::int32_t> changed;
    for (std::size_t t = 0; t < all.size(); ++t) {
        if (std::any_of(all[t].begin(), all[t].end(), [&](std::int32_t p) { return moved_of_[p] >= 0; })) {
            changed.push_back(static_cast<std::int32_t>(t));
        }
    }
    for (int round = 0; round < kMostRounds; ++round) {
        const mesh::Verification check = mesh::verify(surface_.points, all, &changed, kListed, progress_);
        std::size_t undone = 0;
        for (const mesh::Fault& fault : check.faults) {
            if (fault.kind != mesh::FaultKind::Crossing && fault.kind != mesh::FaultKind::Touching) {
                continue;
            }
            for (const std::int32_t t : fault.triangles) {
                for (const std::int32_t p : all[static_cast<std::size_t>(t)]) {
                    if (moved_of_[p] >= 0 && surface_.points[p] != moved_[moved_of_[p]].before) {
                        surface_.points[p] = moved_[moved_of_[p]].before;
                        moved_[moved_of_[p]].lost = true;
                        ++undone;
                    }
                }
            }
        }
        if (undone == 0) {
            break;
        }
    }
}

FaceProjection FaceProjector::apply(const std::vector<mesh::Triangle>& reconstructed) {
    FaceProjection result;
    for (MovedVertex& moved : moved_) {
        if (arrived(moved)) {
            surface_.points[moved.vertex] = to_single(moved.now);
        }
    }
    // Undoes the longest of the moves of a triangle's vertices, as the triangle turns over.
    const auto undo = [&](const mesh::Triangle& t) {
        if (!turns_over(t)) {
            return false;
        }
        const auto move = [&](std::int32_t p) {
            return moved_of_[p] < 0 ? 0.0 : (surface_.points[p] - moved_[moved_of_[p]].before).norm();
        };
        const std::int32_t farthest =
            *std::max_element(t.begin(), t.end(), [&](std::int32_t p, std::int32_t q) { return move(p) < move(q); });
        MovedVertex& moved = moved_[moved_of_[farthest]];
        surface_.points[farthest] = moved.before;
        moved.lost = true;
        return true;
    };
    for (bool again = true; again;) {
        again = false;
        for (const mesh::Triangle& t : surface_.triangles) {
            again = undo(t) || again;
        }
        for (const mesh::Triangle& t : reconstructed) {
            again = undo(t) || again;
        }
    }
    undo_contacts(reconstructed);
    for (const MovedVertex& moved : moved_) {
        ++(arrived(moved) ? result.moved : result.left);
        result.largest_move = std::max(result.largest_move, (surface_.points[moved.vertex] - moved.before).norm());
    }
    return result;
}

}  // namespace

FaceProjection project_onto_faces(RetainedSurface& surface, const std::vector<mesh::Triangle>& reconstructed,
                                  const Octree& tree, const std::vector<std::int32_t>& vertices, const OperandSet& pair,
                                  const SampleGrid& grid, const Vec3& origin, const std::vector<CadShape>& shapes,
                                  geometry::Engine& engine, const Progress* progress) {
    FaceProjector projector(surface, pair, grid, origin, shapes, engine, progress);
    projector.find(tree, vertices);
    projector.approach();
    projector.retry_with_nearest();
    return projector.apply(reconstructed);
}

}  // namespace mq::layered_depth

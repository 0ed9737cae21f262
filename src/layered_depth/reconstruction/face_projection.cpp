// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/face_projection.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/rounds.h"
#include "geometry/session.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {

namespace {

using geometry::Query;

/// A vertex counts as on its faces up to this distance, as a fraction of the grid's side: the resolution of single
/// precision.
constexpr double kOnFaces = 2e-7;
/// Largest move of a vertex, in units of the distance between rays.
constexpr double kFarthest = 0.5;
/// Largest move of a border vertex, in deviations of the meshes from the faces, which were measured at samples only.
constexpr double kDeviations = 2.0;
/// Contacts that are examined in a round.
constexpr std::size_t kListed = 100'000;
/// Projections that one thread does at a time, and chunks of these in one job of the engine, so that other jobs are not
/// delayed for long.
constexpr int kQueriesPerChunk = 64;
constexpr int kChunksPerWork = 32;
/// More than this number of faces have no point in common.
constexpr std::size_t kMostFaces = 3;
/// Two sides that are farther apart than this, in units of the distance between rays, are those of a wall or gap;
/// surfaces in contact are nearer.
constexpr double kThin = 0.1;
/// Sine of the angle below which two faces count as meeting smoothly, as the place of their edge is uncertain.
constexpr double kSmooth = 0.1;

struct FaceConstraint {
    std::int32_t operand, face;
    Vec3 foot = Vec3::Zero(), normal = Vec3::Zero();
    double u = 0.0, v = 0.0;
    bool asked = false;

    double distance(const Vec3& p) const { return (foot - p).norm(); }
};

struct MovedVertex {
    std::int32_t vertex;
    Vec3 before, now;
    double farthest;  // mm
    std::vector<FaceConstraint> faces;
    bool lost = false;
    bool thin = false;  ///< one vertex stands for both sides of a wall or a gap, and can lie on one only

    double distance() const {
        double largest = 0.0;
        for (const FaceConstraint& face : faces) {
            largest = std::max(largest, face.distance(now));
        }
        return largest;
    }
};

/// The least displacement onto the intersection of the tangent planes of all faces.
Vec3 newton_step(const MovedVertex& moved) {
    const auto count = static_cast<Eigen::Index>(moved.faces.size());
    Eigen::Matrix<double, Eigen::Dynamic, 3> normals(count, 3);
    Eigen::VectorXd away(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const FaceConstraint& face = moved.faces[static_cast<std::size_t>(i)];
        normals.row(i) = face.normal.transpose();
        away[i] = face.normal.dot(face.foot - moved.now);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, Eigen::Dynamic, 3>> solver;
    solver.setThreshold(kSmooth);
    return solver.compute(normals).solve(away);
}

class FaceProjector {
  public:
    FaceProjector(RetainedSurface& surface, const OperandSet& pair, const SampleGrid& grid, const Vec3& origin,
                  const std::vector<CadShape>& shapes, geometry::Engine& engine, const Progress* progress)
        : progress_(progress),
          surface_(surface),
          pair_(pair),
          origin_(origin),
          spacing_(grid.spacing()),
          farthest_(kFarthest * grid.spacing()),
          on_faces_(kOnFaces * grid.spacing() * grid.cells()),
          sessions_(shapes.size()) {
        for (std::size_t k = 0; k < shapes.size(); ++k) {
            if (shapes[k].model) {
                sessions_[k].emplace(engine, shapes[k].model, progress);
                from_mesh_ = std::max(from_mesh_, kDeviations * shapes[k].chord_height);
            }
        }
    }

    void find(const Octree& tree, const std::vector<std::int32_t>& vertices);
    void approach();
    void retry_with_nearest();
    FaceProjection apply(const std::vector<mesh::Triangle>& reconstructed);

  private:
    void add(std::int32_t vertex, const std::vector<std::int32_t>& triangles);
    void ask(const std::vector<MovedVertex*>& active);
    void take(const geometry::Answer& answer, FaceConstraint& face) const;
    void drop_smooth();
    bool arrived(const MovedVertex& moved) const {
        return !moved.lost && moved.distance() <= on_faces_ && (moved.now - moved.before).norm() <= moved.farthest;
    }
    bool turns_over(const mesh::Triangle& t) const;
    void undo_contacts(const std::vector<mesh::Triangle>& reconstructed);

    const Progress* progress_;
    RetainedSurface& surface_;
    const OperandSet& pair_;
    Vec3 origin_;
    double spacing_, farthest_, on_faces_;
    double from_mesh_ = 0.0;           ///< mm: largest distance of the meshes from the faces
    std::vector<std::uint8_t> stays_;  // by point: whether an unchanged triangle of an operand has it
    std::vector<std::optional<geometry::Session>> sessions_;
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
        const bool known = std::any_of(moved.faces.begin(), moved.faces.end(), [&](const FaceConstraint& other) {
            return other.operand == face.operand && other.face == face.face;
        });
        if (face.face < 0 || (!known && moved.faces.size() == kMostFaces)) {
            return;
        }
        if (!known) {
            moved.faces.push_back(face);
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

/// Projects each vertex onto each of its faces.
void FaceProjector::ask(const std::vector<MovedVertex*>& active) {
    for (std::int32_t operand = 0; operand < static_cast<std::int32_t>(sessions_.size()); ++operand) {
        std::vector<std::pair<MovedVertex*, FaceConstraint*>> asked;
        for (MovedVertex* moved : active) {
            for (FaceConstraint& face : moved->faces) {
                if (face.operand == operand) {
                    asked.emplace_back(moved, &face);
                }
            }
        }
        const auto count = static_cast<int>(asked.size());
        for (int from = 0; from < count; from += kQueriesPerChunk * kChunksPerWork) {
            const int chunks = (count - from + kQueriesPerChunk - 1) / kQueriesPerChunk;
            sessions_[static_cast<std::size_t>(operand)]->run_parallel(
                std::min(kChunksPerWork, chunks), [&](geometry::Answerer& answerer, int k) {
                    check_cancelled(progress_);
                    const int first = from + k * kQueriesPerChunk;
                    for (int i = first; i < std::min(first + kQueriesPerChunk, count); ++i) {
                        FaceConstraint& face = *asked[static_cast<std::size_t>(i)].second;
                        const Vec3 p = asked[static_cast<std::size_t>(i)].first->now + origin_;
                        take(answerer.answer(face.asked ? Query::face_nearest(face.face, p, face.u, face.v)
                                                        : Query::face_nearest_global(face.face, p)),
                             face);
                    }
                });
        }
        for (auto& [moved, face] : asked) {
            moved->lost = moved->lost || !face->asked;
        }
    }
}

/// Stores the nearest point of a face; a failed projection leaves the face out.
void FaceProjector::take(const geometry::Answer& answer, FaceConstraint& face) const {
    face.asked = answer.status == geometry::Status::Ok;
    if (face.asked) {
        face.foot = answer.point - origin_;
        face.normal = answer.normal;
        face.u = answer.u;
        face.v = answer.v;
    }
}

/// Removes one of two faces that meet smoothly: the one that does not contain the point, or the one that is farther
/// away.
void FaceProjector::drop_smooth() {
    for (MovedVertex& moved : moved_) {
        for (std::size_t i = 0; i < moved.faces.size() && !moved.lost; ++i) {
            for (std::size_t k = i + 1; k < moved.faces.size();) {
                const FaceConstraint &a = moved.faces[i], &b = moved.faces[k];
                if (a.normal.cross(b.normal).norm() >= kSmooth) {
                    ++k;
                    continue;
                }
                const double apart = std::abs(a.normal.dot(a.foot - b.foot));
                if (apart > kThin * spacing_ && (a.operand != b.operand || a.normal.dot(b.normal) < 0.0)) {
                    moved.lost = moved.thin = true;
                    break;
                }
                const auto holds = [&](const FaceConstraint& c) {
                    return sessions_[static_cast<std::size_t>(c.operand)]
                               ->ask(Query::face_contains(c.face, c.u, c.v))
                               .side >= 0;
                };
                const bool first = holds(a), second = holds(b);
                const bool keep_first = first != second ? first : a.distance(moved.now) <= b.distance(moved.now);
                moved.faces[i] = keep_first ? a : b;
                moved.faces.erase(moved.faces.begin() + static_cast<std::ptrdiff_t>(k));
            }
        }
    }
}

/// Newton's method for all vertices in parallel.
void FaceProjector::approach() {
    for (int step = 0; step <= kNewtonSteps; ++step) {
        std::vector<MovedVertex*> active;
        for (MovedVertex& moved : moved_) {
            if (!moved.lost && (!moved.faces.front().asked || moved.distance() > on_faces_)) {
                active.push_back(&moved);
            }
        }
        ask(active);
        if (step == 0) {
            drop_smooth();
        }
        for (MovedVertex* moved : active) {
            if (!moved->lost && step < kNewtonSteps && moved->distance() > on_faces_) {
                moved->now += newton_step(*moved);
                moved->lost = !((moved->now - moved->before).norm() <= 2.0 * moved->farthest);
            }
        }
    }
}

void FaceProjector::retry_with_nearest() {
    std::vector<MovedVertex*> active;
    for (MovedVertex& moved : moved_) {
        if (!arrived(moved) && !moved.thin && moved.faces.size() > 1) {
            moved.now = moved.before;
            moved.lost = false;
            for (FaceConstraint& face : moved.faces) {
                face.asked = false;
            }
            active.push_back(&moved);
        }
    }
    ask(active);
    for (MovedVertex* moved : active) {
        if (moved->lost) {
            continue;
        }
        const auto nearest = std::min_element(moved->faces.begin(), moved->faces.end(),
                                              [&](const FaceConstraint& a, const FaceConstraint& b) {
                                                  return a.distance(moved->now) < b.distance(moved->now);
                                              });
        moved->faces = {FaceConstraint(*nearest)};
        moved->now = moved->faces.front().foot;
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
    const auto take_back = [&](const mesh::Triangle& t) {
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
            again = take_back(t) || again;
        }
        for (const mesh::Triangle& t : reconstructed) {
            again = take_back(t) || again;
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

}  // namespace mq::boolean

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/project_to_cad.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/parallel.h"
#include "base/tuning.h"
#include "boolean/points_on_faces.h"
#include "boolean/tuning.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/quality/surface_verification.h"

namespace mq::boolean {

namespace {

using Candidate = MovedVertex;
using Constraint = SurfaceConstraint;
using mesh::Triangle;
using mesh::TriangleMesh;

/// A vertex is on its surfaces when its distance is at most this fraction of the size: about the resolution of single
/// precision.
constexpr double kOnSurface = 2e-7;
Vec3 normal_of(const std::vector<Vec3>& vertices, const Triangle& t) {
    return (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
}

class Fitting {
  public:
    Fitting(TriangleMesh& result, const std::vector<CadOperand>& operands, Progress& progress)
        : result_(result), operands_(operands), progress_(progress) {
        Box box;
        for (const Vec3& p : result.vertices) {
            box.add(p);
        }
        on_surface_ = kOnSurface * box.largest_side();
    }

    void find_candidates(const std::vector<std::array<std::int32_t, 2>>& source, double near) {
        std::vector<char> made(result_.vertices.size(), 0);
        for (const bool own : {false, true}) {
            for (std::size_t t = 0; t < source.size(); ++t) {
                if ((source[t][0] >= 0) == own) {
                    for (const std::int32_t v : result_.triangles[t]) {
                        made[static_cast<std::size_t>(v)] = own ? 0 : 1;
                    }
                }
            }
        }
        std::vector<std::int32_t> vertices;
        for (std::size_t v = 0; v < made.size(); ++v) {
            if (made[v] != 0) {
                vertices.push_back(static_cast<std::int32_t>(v));
            }
        }
        constrain(vertices, near);
    }

    void approach(geometry::Engine& engine) {
        FaceIntersections(engine, operands_, result_.origin, BooleanTuning::kLeastSurfaceAngle, &progress_)
            .approach(candidates_, on_surface_, [] {});
    }

    CadProjection apply(double limit) {
        CadProjection fit;
        for (Candidate& c : candidates_) {
            const bool arrived = !c.lost && c.distance() <= std::max(on_surface_, 0.05 * c.first_distance);
            const bool there = arrived && c.first_distance <= on_surface_;
            if (there) {
                c.now = c.before;
            } else if (!arrived || (c.now - c.before).norm() > limit) {
                ++fit.left;
                c.now = c.before;
            } else if (is_single(c.before)) {
                c.now = to_single(c.now);
            }
            result_.vertices[static_cast<std::size_t>(c.vertex)] = c.now;
        }
        fit.reverted = undo_faults();
        for (const Candidate& c : candidates_) {
            const double move = (result_.vertices[static_cast<std::size_t>(c.vertex)] - c.before).norm();
            fit.moved += move > 0.0;
            fit.largest_move = std::max(fit.largest_move, move);
        }
        return fit;
    }

  private:
    /// Makes a candidate of each vertex that lies on a face of a shape and is no operand's own.
    void constrain(const std::vector<std::int32_t>& vertices, double near) {
        // One tree: with one for each operand every vertex would be sought in each of many.
        std::vector<Vec3> all_vertices;
        std::vector<Triangle> all_triangles;
        for (std::size_t o = 0; o < operands_.size(); ++o) {
            const TriangleMesh& mesh = *operands_[o].mesh;
            const auto first = static_cast<std::int32_t>(all_vertices.size());
            first_.push_back(static_cast<std::int32_t>(all_triangles.size()));
            all_vertices.insert(all_vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
            for (const Triangle& t : mesh.triangles) {
                all_triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            }
        }
        const mesh::AabbTree tree(all_vertices, all_triangles);
        std::vector<Candidate> found(vertices.size());
        std::vector<char> own(vertices.size(), 0);
        parallel_for(static_cast<int>(vertices.size()), [&](int k) {
            const auto i = static_cast<std::size_t>(k);
            found[i].vertex = vertices[i];
            found[i].farthest = std::numeric_limits<double>::infinity();
            found[i].before = found[i].now = result_.vertices[static_cast<std::size_t>(vertices[i])];
            own[i] = !add_constraints(found[i], tree, near);
        });
        progress_.check();
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto& list = found[i].surfaces;
            if (own[i] == 0 && std::any_of(list.begin(), list.end(), [](const Constraint& c) { return c.face >= 0; })) {
                candidates_.push_back(std::move(found[i]));
            }
        }
    }

    /// False when the vertex is an operand's own.
    /// @param tree  over the triangles of all operands
    bool add_constraints(Candidate& candidate, const mesh::AabbTree& tree, double near) const {
        const Vec3 p = candidate.before;
        Box box;
        box.add(p - Vec3::Constant(near));
        box.add(p + Vec3::Constant(near));
        std::vector<std::int32_t> around;
        tree.for_each_in_box(box, [&](std::int32_t t) { around.push_back(t); });
        std::sort(around.begin(), around.end());
        std::size_t known = 0;  // constraints of operands before this one
        for (const std::int32_t all : around) {
            const auto o = std::prev(std::upper_bound(first_.begin(), first_.end(), all)) - first_.begin();
            const CadOperand& operand = operands_[static_cast<std::size_t>(o)];
            const TriangleMesh& mesh = *operand.mesh;
            const auto t = static_cast<std::size_t>(all - first_[static_cast<std::size_t>(o)]);
            const Triangle& corners = mesh.triangles[t];
            const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
            if (p == a || p == b || p == c) {
                return false;
            }
            Constraint constraint;
            constraint.operand = static_cast<std::int32_t>(o);
            constraint.face = operand.model ? (*operand.faces)[t] : -1;
            constraint.foot = a;
            if (constraint.face < 0) {
                constraint.normal = (b - a).cross(c - a).normalized();
            }
            const auto same = [&](const Constraint& other) {
                return other.face == constraint.face &&
                       (other.face >= 0 ||
                        other.normal.cross(constraint.normal).norm() < BooleanTuning::kLeastSurfaceAngle);
            };
            if (!candidate.surfaces.empty() && candidate.surfaces.back().operand != constraint.operand) {
                known = candidate.surfaces.size();
            }
            // Most triangles around a vertex are of a face that is known already.
            if (std::none_of(candidate.surfaces.begin() + static_cast<std::ptrdiff_t>(known), candidate.surfaces.end(),
                             same) &&
                (mesh::nearest_on_triangle(p, a, b, c) - p).norm() <= near) {
                candidate.surfaces.push_back(constraint);
            }
        }
        return true;
    }

    /// Reverts the moves of vertices at triangles with faults, until there are none; returns how many.
    std::size_t undo_faults() {
        std::map<std::int32_t, const Candidate*> moved;
        for (const Candidate& c : candidates_) {
            if (c.now != c.before) {
                moved.emplace(c.vertex, &c);
            }
        }
        const std::size_t all = moved.size();
        for (int round = 0; !moved.empty(); ++round) {
            const std::vector<std::int32_t> faulty = faulty_triangles(moved);
            if (faulty.empty()) {
                break;
            }
            const std::size_t before = moved.size();
            for (const std::int32_t t : faulty) {
                for (const std::int32_t v : result_.triangles[static_cast<std::size_t>(t)]) {
                    undo(moved, v);
                }
            }
            if (moved.size() == before || round == kMostRounds) {
                while (!moved.empty()) {
                    undo(moved, moved.begin()->first);
                }
            }
        }
        return all - moved.size();
    }
    void undo(std::map<std::int32_t, const Candidate*>& moved, std::int32_t vertex) {
        const auto found = moved.find(vertex);
        if (found != moved.end()) {
            result_.vertices[static_cast<std::size_t>(vertex)] = found->second->before;
            moved.erase(found);
        }
    }

    /// Triangles that turned over, or are at fault, because of vertices that moved.
    std::vector<std::int32_t> faulty_triangles(const std::map<std::int32_t, const Candidate*>& moved) const {
        std::vector<std::int32_t> changed, faulty;
        for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
            std::array<Vec3, 3> before;
            bool any = false;
            for (int i = 0; i < 3; ++i) {
                const std::int32_t v = result_.triangles[t][i];
                const auto found = moved.find(v);
                any = any || found != moved.end();
                before[i] =
                    found != moved.end() ? found->second->before : result_.vertices[static_cast<std::size_t>(v)];
            }
            if (any) {
                changed.push_back(static_cast<std::int32_t>(t));
                const Vec3 normal = (before[1] - before[0]).cross(before[2] - before[0]);
                if (normal.dot(normal_of(result_.vertices, result_.triangles[t])) <= 0.0) {
                    faulty.push_back(static_cast<std::int32_t>(t));
                }
            }
        }
        if (faulty.empty()) {
            // Faults listed at most; more would only be reverted in the next round.
            constexpr std::size_t kListed = 100'000;
            const mesh::Verification check =
                mesh::verify(result_.vertices, result_.triangles, &changed, kListed, &progress_);
            for (const mesh::Fault& fault : check.faults) {
                for (const std::int32_t t : fault.triangles) {
                    if (t >= 0) {
                        faulty.push_back(t);
                    }
                }
            }
        }
        return faulty;
    }

    TriangleMesh& result_;
    const std::vector<CadOperand>& operands_;
    Progress& progress_;
    double on_surface_ = 0.0;
    std::vector<std::int32_t> first_;  ///< the first triangle of each operand, in one list of all
    std::vector<Candidate> candidates_;
};

}  // namespace

CadProjection project_to_cad(TriangleMesh& result, const std::vector<std::array<std::int32_t, 2>>& source,
                             const std::vector<CadOperand>& operands, geometry::Engine& engine, double near,
                             double limit, Progress& progress) {
    Fitting fitting(result, operands, progress);
    fitting.find_candidates(source, near);
    fitting.approach(engine);
    return fitting.apply(limit);
}

}  // namespace mq::boolean

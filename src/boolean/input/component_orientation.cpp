// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/predicates.h"
#include "base/tuning.h"
#include "boolean/input/operand_mesh.h"
#include "boolean/input/tuning.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::boolean {
namespace {

/// Directions with irregular components, so that rays rarely meet edges of regular meshes.
constexpr std::array<std::array<double, 3>, 4> kIrregular{
    {{0.618, 0.271, 0.738}, {-0.391, 0.833, 0.392}, {0.459, -0.577, -0.676}, {-0.733, -0.319, 0.601}}};

/// A component that encloses a point, and its winding number: the crossings of a ray outward minus those inward.
struct Encloser {
    std::int32_t component;
    int winding;
};

/// Which components enclose a point, exactly.
class Enclosure {
  public:
    Enclosure(const OperandMesh& draft, const mesh::Components& components)
        : draft_(draft),
          components_(components),
          tree_(draft.vertices, draft.triangles),
          crossings_(components.count, 0) {}

    /// The enclosers of the first vertex of a component from which a ray meets no edge; none when there is no such
    /// vertex among those tried.
    std::optional<std::vector<Encloser>> of(std::int32_t component, const std::vector<std::int32_t>& triangles) {
        for (std::size_t i = 0; i < std::min<std::size_t>(kMostRounds, triangles.size()); ++i) {
            const Vec3& p = draft_.vertices[draft_.triangles[triangles[i * triangles.size() / kMostRounds]][0]];
            for (int attempt = 0; attempt < 4; ++attempt) {
                if (follow(p, component, attempt)) {
                    return enclosers();
                }
            }
        }
        return std::nullopt;
    }

  private:
    /// A point outside of all components: for each attempt in another direction, which no axis, grid or diagonal has.
    Vec3 far_point(int attempt) const {
        const Box box = tree_.box();
        const std::array<double, 3>& d = kIrregular[attempt];
        return box.center() + 2.0 * (box.high - box.low).norm() * Vec3(d[0], d[1], d[2]);
    }

    bool follow(const Vec3& p, std::int32_t component, int attempt) {
        for (const std::int32_t c : touched_) {
            crossings_[c] = 0;
        }
        touched_.clear();
        const Vec3 q = far_point(attempt);
        bool clear = true;
        tree_.for_each_on_ray(p, q - p, 1.0, [&](std::int32_t t) {
            const std::int32_t c = components_.component_of[t];
            clear = c == component || cross(p, q, t, c);
            return clear;
        });
        return clear;
    }

    /// Counts the crossing of p-q with a triangle; false where it meets the triangle's border or starts on the
    /// triangle.
    bool cross(const Vec3& p, const Vec3& q, std::int32_t triangle, std::int32_t component) {
        const mesh::Triangle& t = draft_.triangles[triangle];
        const Vec3& a = draft_.vertices[t[0]];
        const Vec3& b = draft_.vertices[t[1]];
        const Vec3& c = draft_.vertices[t[2]];
        const int at_p = orient3d(a, b, c, p);
        const int at_q = orient3d(a, b, c, q);
        if (at_p * at_q > 0) {
            return true;
        }
        const int ab = orient3d(p, q, a, b);
        const int bc = orient3d(p, q, b, c);
        const int ca = orient3d(p, q, c, a);
        const int low = std::min({ab, bc, ca});
        const int high = std::max({ab, bc, ca});
        if (low < 0 && high > 0) {
            return true;
        }
        if (at_p == 0 || at_q == 0 || ab == 0 || bc == 0 || ca == 0) {
            return false;
        }
        touched_.push_back(component);
        crossings_[component] += at_q;
        return true;
    }

    std::vector<Encloser> enclosers() {
        std::vector<Encloser> found;
        for (const std::int32_t c : touched_) {
            if (crossings_[c] != 0) {
                found.push_back({c, crossings_[c]});
                crossings_[c] = 0;
            }
        }
        return found;
    }

    const OperandMesh& draft_;
    const mesh::Components& components_;
    mesh::AabbTree tree_;
    std::vector<int> crossings_;
    std::vector<std::int32_t> touched_;
};

/// Six times the signed volume of each component.
std::vector<double> volumes(const OperandMesh& draft, const mesh::Components& components) {
    std::vector<double> volume(components.count, 0.0);
    if (draft.triangles.empty()) {
        return volume;
    }
    const Vec3 center = draft.vertices[draft.triangles[0][0]];
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const mesh::Triangle& s = draft.triangles[t];
        volume[components.component_of[t]] +=
            (draft.vertices[s[0]] - center).dot((draft.vertices[s[1]] - center).cross(draft.vertices[s[2]] - center));
    }
    return volume;
}

/// Decides for each component, from the largest to the smallest, whether it is reversed, by the components that enclose
/// it.
std::vector<char> components_to_turn(const OperandMesh& draft, const mesh::Components& components,
                                     const std::vector<double>& volume) {
    std::vector<std::vector<std::int32_t>> triangles(components.count);
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        triangles[components.component_of[t]].push_back(static_cast<std::int32_t>(t));
    }
    std::vector<std::int32_t> order(components.count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::int32_t a, std::int32_t b) { return std::abs(volume[a]) > std::abs(volume[b]); });
    Enclosure enclosure(draft, components);
    std::vector<char> turned(components.count, 0);
    for (const std::int32_t c : order) {
        int winding = 0;
        std::int32_t parent = -1;
        for (const Encloser& e : enclosure.of(c, triangles[c]).value_or(std::vector<Encloser>{})) {
            if (std::abs(volume[e.component]) < std::abs(volume[c])) {
                continue;
            }
            winding += turned[e.component] != 0 ? -e.winding : e.winding;
            if (parent < 0 || std::abs(volume[e.component]) < std::abs(volume[parent])) {
                parent = e.component;
            }
        }
        const bool with_parent = parent >= 0 && turned[parent] != 0;
        const bool negative = (volume[c] < 0.0) != with_parent;
        turned[c] = static_cast<char>(with_parent != (negative && winding <= 0));
    }
    return turned;
}

/// Votes on which side of an open sheet lies inside, by rays that count the triangles of the operand.
class SheetVotes {
  public:
    explicit SheetVotes(const OperandMesh& draft) : draft_(draft), tree_(draft.vertices, draft.triangles) {}

    /// Above 0 where rays from a triangle find the outside in front of it and the inside behind it, below 0 the other
    /// way round.
    int of(std::int32_t triangle) const {
        const mesh::Triangle& t = draft_.triangles[triangle];
        const Vec3 &a = draft_.vertices[t[0]], &b = draft_.vertices[t[1]], &c = draft_.vertices[t[2]];
        const Vec3 normal = (b - a).cross(c - a);
        int votes = 0;
        for (const std::array<double, 3>& d : kIrregular) {
            const Vec3 way(d[0], d[1], d[2]);
            const Vec3 front = way.dot(normal) < 0.0 ? Vec3(-way) : way;
            votes +=
                (odd(triangle, (a + b + c) / 3.0, -front) ? 1 : 0) - (odd(triangle, (a + b + c) / 3.0, front) ? 1 : 0);
        }
        return votes;
    }

  private:
    /// Whether a ray from a triangle meets an odd number of others. Roundings change single votes only.
    bool odd(std::int32_t triangle, const Vec3& from, const Vec3& way) const {
        bool result = false;
        tree_.for_each_on_ray(from, way, [&](std::int32_t other) {
            const mesh::Triangle& t = draft_.triangles[other];
            const Vec3 a = draft_.vertices[t[0]] - from, b = draft_.vertices[t[1]] - from,
                       c = draft_.vertices[t[2]] - from;
            const double ab = way.dot(a.cross(b)), bc = way.dot(b.cross(c)), ca = way.dot(c.cross(a));
            const bool through = (ab > 0.0) == (bc > 0.0) && (bc > 0.0) == (ca > 0.0);
            const double volume = a.dot(b.cross(c));
            const bool ahead = (volume > 0.0) == (ab + bc + ca > 0.0);
            result = result != (other != triangle && through && ahead);
        });
        return result;
    }

    const OperandMesh& draft_;
    mesh::AabbTree tree_;
};

}  // namespace

void orient_open_sheets(OperandMesh& draft, const Progress* progress) {
    const mesh::Components components = mesh::components(draft.mates);
    std::vector<char> open(components.count, 0);
    std::vector<std::size_t> size(components.count, 0);
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const std::int32_t c = components.component_of[t];
        ++size[c];
        for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
            open[c] |= static_cast<char>(draft.mates[h] < 0);
        }
    }
    const SheetVotes votes(draft);
    std::vector<double> sum(components.count, 0.0);
    std::vector<std::size_t> seen(components.count, 0);
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const std::int32_t c = components.component_of[t];
        const std::size_t every = std::max<std::size_t>(1, size[c] / InputTuning::kVotes);
        if (open[c] != 0 && seen[c]++ % every == 0) {
            check_cancelled(progress);
            const auto triangle = static_cast<std::int32_t>(t);
            sum[c] += draft.area(triangle) * votes.of(triangle);
        }
    }
    std::vector<char> marked(draft.triangles.size());
    for (std::size_t t = 0; t < marked.size(); ++t) {
        marked[t] = static_cast<char>(sum[components.component_of[t]] < 0.0);
    }
    draft.turn(marked);
}

std::size_t orient_to_bound_volume(OperandMesh& draft) {
    const mesh::Components components = mesh::components(draft.mates);
    const std::vector<double> volume = volumes(draft, components);
    if (std::none_of(volume.begin(), volume.end(), [](double v) { return v < 0.0; })) {
        return static_cast<std::size_t>(components.count);
    }
    const std::vector<char> turned =
        components.count == 1 ? std::vector<char>{1} : components_to_turn(draft, components, volume);
    std::vector<char> marked(draft.triangles.size());
    for (std::size_t t = 0; t < marked.size(); ++t) {
        marked[t] = turned[components.component_of[t]];
    }
    draft.turn(marked);
    return static_cast<std::size_t>(components.count);
}

}  // namespace mq::boolean

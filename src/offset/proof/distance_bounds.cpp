// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/proof/distance_bounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::offset {

namespace {

/// Largest number of successive divisions of a triangle into four.
constexpr int kMostDivisions = 10;
/// Triangles that one parallel task takes.
constexpr std::size_t kBlock = 64;

Vec3 centre(const Corners& t) {
    return (t[0] + t[1] + t[2]) / 3.0;
}

double radius(const Corners& t, const Vec3& middle) {
    return std::sqrt(
        std::max({(t[0] - middle).squaredNorm(), (t[1] - middle).squaredNorm(), (t[2] - middle).squaredNorm()}));
}

std::array<Corners, 4> divided(const Corners& t) {
    const Vec3 a = 0.5 * (t[1] + t[2]);
    const Vec3 b = 0.5 * (t[2] + t[0]);
    const Vec3 c = 0.5 * (t[0] + t[1]);
    return {Corners{t[0], c, b}, Corners{c, t[1], a}, Corners{b, a, t[2]}, Corners{a, b, c}};
}

Corners corners(const SearchedSurface& surface, std::int32_t t) {
    const mesh::Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
    return {surface.points[static_cast<std::size_t>(c[0])], surface.points[static_cast<std::size_t>(c[1])],
            surface.points[static_cast<std::size_t>(c[2])]};
}

double distance(const Vec3& p, const Corners& t) {
    return (mesh::nearest_on_triangle(p, t[0], t[1], t[2]) - p).norm();
}

/// The distance of a surface without triangles, mm.
constexpr double kNoDistance = std::numeric_limits<double>::infinity();

/// An upper bound for the distance of a triangle's points from another one: that of its corners.
double farthest(const Corners& t, const Corners& other) {
    return std::max({distance(t[0], other), distance(t[1], other), distance(t[2], other)});
}

/// The same for a surface, by its triangle nearest to `middle`.
double farthest(const Corners& t, const Vec3& middle, const SearchedSurface& surface) {
    const std::int32_t nearest = surface.tree.nearest(middle).triangle;
    return nearest < 0 ? kNoDistance : farthest(t, corners(surface, nearest));
}

/// Whether a point lies on the inner side of a closed surface. At edges and vertices several triangles are equally
/// near: the one from whose plane the point is farthest decides. No point is behind a sheet that has both sides.
bool is_behind(const Vec3& p, const SearchedSurface& surface) {
    constexpr double kSame = 1e-9;  // relative difference of distances that count as equal
    const double reach = surface.tree.nearest(p).distance * (1.0 + kSame);
    Box box;
    box.add(p + Vec3::Constant(reach));
    box.add(p - Vec3::Constant(reach));
    double front = 0.0;
    double back = 0.0;
    surface.tree.for_each_in_box(box, [&](std::int32_t other) {
        const Corners t = corners(surface, other);
        const Vec3 away = p - mesh::nearest_on_triangle(p, t[0], t[1], t[2]);
        if (away.norm() <= reach) {
            const double height = (t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(away);
            front = std::max(front, height);
            back = std::max(back, -height);
        }
    });
    return back > front;
}

/// The distance of a triangle from a surface if it is less than `bound`; else `bound`.
double nearest_within(const Corners& t, const Vec3& middle, const SearchedSurface& surface, double bound) {
    const double reach = radius(t, middle);
    Box box;
    for (const Vec3& p : t) {
        box.add(p);
    }
    box.low.array() -= bound;
    box.high.array() += bound;
    double result = bound;
    surface.tree.for_each_in_box(box, [&](std::int32_t other) {
        const Corners o = corners(surface, other);
        if (distance(middle, o) - reach < result) {
            result = std::min(result, mesh::triangle_distance(t, o).distance);
        }
    });
    return result;
}

/// Runs task(triangle, bound) over all triangles in parallel; each call may raise the bound of its block.
template <typename Task>
ProvenBound over_all(const std::vector<Corners>& triangles, const Progress& progress, const Task& task) {
    std::vector<ProvenBound> blocks((triangles.size() + kBlock - 1) / kBlock);
    parallel_for(static_cast<int>(blocks.size()), [&](int k) {
        progress.check();
        const std::size_t first = static_cast<std::size_t>(k) * kBlock;
        for (std::size_t t = first; t < std::min(first + kBlock, triangles.size()); ++t) {
            task(triangles[t], blocks[static_cast<std::size_t>(k)]);
        }
    });
    ProvenBound result;
    for (const ProvenBound& block : blocks) {
        result = block.bound > result.bound ? block : result;
    }
    return result;
}

/// Calls must_divide(piece, divisions) for a triangle and for the quarters of each piece for which it returns true.
template <typename MustDivide>
void divide(const Corners& whole, MustDivide&& must_divide) {
    std::vector<std::pair<Corners, int>> stack{{whole, 0}};
    while (!stack.empty()) {
        const auto [piece, divisions] = stack.back();
        stack.pop_back();
        if (must_divide(piece, divisions)) {
            for (const Corners& quarter : divided(piece)) {
                stack.emplace_back(quarter, divisions + 1);
            }
        }
    }
}

/// Raises a bound to the bound for one triangle. @param witnesses  gets the triangles of the surface near which pieces
/// are that do not raise it; null: not asked for
void raise_bound(const Corners& whole, const SearchedSurface& surface, double wanted, double fineness,
                 ProvenBound& found, std::vector<std::int32_t>* witnesses = nullptr) {
    const Vec3 middle = centre(whole);
    if (wanted > 0.0) {  // no piece is nearer to the surface than the whole triangle is
        const double near = nearest_within(whole, middle, surface, wanted);
        if (wanted - near > found.bound) {
            found = {wanted - near, middle};
        }
    }
    std::int32_t nearest = -1;
    divide(whole, [&](const Corners& piece, int divisions) {
        // The triangle that was nearest to the piece before is often near enough to this one, without a search.
        const Vec3 here = centre(piece);
        double far = nearest < 0 ? kNoDistance : farthest(piece, corners(surface, nearest));
        if (far - wanted > found.bound) {
            nearest = surface.tree.nearest(here).triangle;
            far = nearest < 0 ? kNoDistance : farthest(piece, corners(surface, nearest));
        }
        if (far - wanted <= found.bound) {
            if (witnesses != nullptr) {
                witnesses->push_back(nearest);
            }
            return false;
        }
        // Distances from one triangle are at least those from the surface: only corners as far from it as `enough` can
        // be as far from all of it.
        const double enough = far - fineness;
        const bool attained =
            nearest < 0 || wanted >= enough || std::any_of(piece.begin(), piece.end(), [&](const Vec3& p) {
                return distance(p, corners(surface, nearest)) >= enough &&
                       surface.tree.any_within(p, enough, nearest) < 0;
            });
        if (attained || divisions == kMostDivisions) {
            found = {far - wanted, here};
            return false;
        }
        return true;
    });
}

}  // namespace

bool all_nearer(const Corners& triangle, const SearchedSurface& surface, double distance) {
    constexpr int kDivisions = 4;
    bool holds = true;
    divide(triangle, [&](const Corners& piece, int divisions) {
        if (!holds || farthest(piece, centre(piece), surface) < distance) {
            return false;
        }
        holds = divisions < kDivisions && surface.tree.any_within(centre(piece), distance, 0) >= 0;
        return holds;
    });
    return holds;
}

ProvenBound deviation_from_distance(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                    double wanted, double fineness, const Progress& progress) {
    return over_all(triangles, progress, [&](const Corners& whole, ProvenBound& found) {
        raise_bound(whole, surface, wanted, fineness, found);
    });
}

std::vector<std::int32_t> triangles_beyond(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                           double wanted, double most, double fineness, const Progress& progress,
                                           std::vector<std::vector<std::int32_t>>* witnesses) {
    std::vector<char> is_beyond(triangles.size());
    if (witnesses != nullptr) {
        witnesses->assign(triangles.size(), {});
    }
    for_chunks(static_cast<int>(triangles.size()), [&](int k) {
        progress.check();
        ProvenBound bound{most, Vec3::Zero()};
        const auto t = static_cast<std::size_t>(k);
        raise_bound(triangles[t], surface, wanted, fineness, bound, witnesses != nullptr ? &(*witnesses)[t] : nullptr);
        is_beyond[t] = bound.bound > most ? 1 : 0;
    });
    std::vector<std::int32_t> result;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (is_beyond[t] != 0) {
            result.push_back(static_cast<std::int32_t>(t));
        }
    }
    return result;
}

namespace {

/// The bound of distance_of_outer_points without divisions, if the result clearly lacks a region: if the centre of a
/// triangle may lie on the exact offset and is farther than `gap` from the result. Else 0.
ProvenBound coarse_bound_of_missing(const std::vector<Corners>& triangles, const SearchedSurface& surface, double least,
                                    double gap, const SearchedSurface& result, const Progress& progress) {
    std::atomic<bool> missing{false};
    const ProvenBound coarse = over_all(triangles, progress, [&](const Corners& t, ProvenBound& found) {
        const Vec3 middle = centre(t);
        if (farthest(t, middle, surface) < least) {
            return;
        }
        const double far = farthest(t, middle, result);
        found = far > found.bound ? ProvenBound{far, middle} : found;
        const Vec3 ahead = gap * (t[1] - t[0]).cross(t[2] - t[0]).normalized();
        if (!missing && surface.tree.nearest(middle).distance >= least && result.tree.nearest(middle).distance > gap &&
            surface.tree.nearest(middle + ahead).distance >= least + gap && !is_behind(middle, surface)) {
            missing = true;
        }
    });
    return missing ? coarse : ProvenBound{};
}

}  // namespace

ProvenBound distance_of_outer_points(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                     double least, double gap, const SearchedSurface& result, double enough,
                                     const Progress& progress) {
    if (const ProvenBound coarse = coarse_bound_of_missing(triangles, surface, least, gap, result, progress);
        coarse.bound > 0.0) {
        return coarse;
    }
    return over_all(triangles, progress, [&](const Corners& whole, ProvenBound& found) {
        const Vec3 cross = (whole[1] - whole[0]).cross(whole[2] - whole[0]);
        const Vec3 ahead = cross.squaredNorm() > 0.0 ? Vec3(gap * cross.normalized()) : Vec3(Vec3::Zero());
        divide(whole, [&](const Corners& piece, int divisions) {
            const Vec3 here = centre(piece);
            const Corners beyond{piece[0] + ahead, piece[1] + ahead, piece[2] + ahead};
            if (farthest(piece, here, surface) < least ||
                farthest(beyond, here + ahead, surface) < least + ahead.norm()) {
                return false;
            }
            const double far = farthest(piece, here, result);
            // A piece smaller than its distance from the surface lies on one side of it.
            const double size = radius(piece, here);
            if (far <= found.bound || (size < surface.tree.nearest(here).distance && is_behind(here, surface))) {
                return false;
            }
            const bool is_small = far <= enough || divisions == kMostDivisions || size < 0.25 * enough;
            found = is_small ? ProvenBound{far, here} : found;
            return !is_small;
        });
    });
}

}  // namespace mq::offset

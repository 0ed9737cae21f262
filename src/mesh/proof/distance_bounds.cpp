// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/proof/distance_bounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "mesh/intersection/triangle_distance.h"
#include "mesh/proof/triangle_pieces.h"

namespace mq::mesh {

namespace {

/// Largest number of successive divisions of a triangle into four.
constexpr int kMostDivisions = 10;
/// Triangles that one parallel task takes.
constexpr std::size_t kTogether = 64;

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
    const Triangle& c = surface.triangles[static_cast<std::size_t>(t)];
    return {surface.points[static_cast<std::size_t>(c[0])], surface.points[static_cast<std::size_t>(c[1])],
            surface.points[static_cast<std::size_t>(c[2])]};
}

double distance(const Vec3& p, const Corners& t) {
    return (nearest_on_triangle(p, t[0], t[1], t[2]) - p).norm();
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
        const Vec3 away = p - nearest_on_triangle(p, t[0], t[1], t[2]);
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
            result = std::min(result, triangle_distance(t, o).distance);
        }
    });
    return result;
}

/// Runs work(block, first, end) in parallel for blocks of the same triangles at any number of threads.
template <typename Work>
void for_blocks(std::size_t triangles, const Progress& progress, const Work& work) {
    parallel_for(static_cast<int>((triangles + kTogether - 1) / kTogether), [&](int k) {
        progress.check();
        const std::size_t first = static_cast<std::size_t>(k) * kTogether;
        work(static_cast<std::size_t>(k), first, std::min(first + kTogether, triangles));
    });
}

/// The largest bound that work(first, end, bound) of a block of triangles raises. @param least  from which all begin
template <typename Work>
ProvenBound over_all(const std::vector<Corners>& triangles, const Progress& progress, const ProvenBound& least,
                     const Work& work) {
    std::vector<ProvenBound> blocks((triangles.size() + kTogether - 1) / kTogether, least);
    for_blocks(triangles.size(), progress,
               [&](std::size_t block, std::size_t first, std::size_t end) { work(first, end, blocks[block]); });
    ProvenBound result = least;
    for (const ProvenBound& block : blocks) {
        result = block.bound > result.bound ? block : result;
    }
    return result;
}

/// Which points count: those that are not inside of a closed surface, or all. Around a point inside there is a ball as
/// large as its distance from the surface that is all inside: many points near to the last one need no look.
class Counted {
  public:
    using Inside = std::function<bool(const Vec3&)>;

    /// @param is_inside  null: all count
    explicit Counted(const Inside* is_inside) : is_inside_(is_inside) {}

    bool all() const { return is_inside_ == nullptr; }
    /// Whether all points within a reach (mm) of another one are known to be inside. A reach that is less by some mm
    /// lets points be outside that are at most as far from the surface as that.
    bool leaves_out(const Vec3& p, double reach) const { return (p - centre_).norm() + reach < radius_; }
    bool has(const Vec3& p) const { return all() || !(*is_inside_)(p); }
    /// Whether a point counts. Where the surface is nearest amid a triangle, the side of that tells.
    /// @param nearest  the triangle of the surface that is nearest to it
    bool has(const Vec3& p, const Corners& nearest) {
        if (all()) {
            return true;
        }
        const std::array<Plane, 3> planes = upright(nearest);
        const bool is_amid =
            std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) { return plane.height(p) < 0.0; });
        const double height = (nearest[1] - nearest[0]).cross(nearest[2] - nearest[0]).dot(p - nearest[0]);
        if (is_amid ? height >= 0.0 : has(p)) {
            return true;
        }
        centre_ = p;
        radius_ = distance(p, nearest);
        return false;
    }

  private:
    const Inside* is_inside_;
    Vec3 centre_ = Vec3::Zero();
    double radius_ = -std::numeric_limits<double>::infinity();
};

/// How much farther than a distance corners and centres of triangles are from a surface at most, or else `least`: a
/// bound from below.
/// @param is_inside  of points that do not count; null: all count
ProvenBound farthest_sample(const std::vector<Corners>& triangles, const SearchedSurface& surface, double wanted,
                            const ProvenBound& least, const Counted::Inside* is_inside, const Progress& progress) {
    return over_all(triangles, progress, least, [&](std::size_t first, std::size_t end, ProvenBound& found) {
        Counted counted(is_inside);
        std::int32_t nearest = surface.tree.nearest(triangles[first][0]).triangle;
        for (std::size_t t = first; t < end && nearest >= 0; ++t) {
            for (const Vec3& p : {triangles[t][0], triangles[t][1], triangles[t][2], centre(triangles[t])}) {
                if (counted.leaves_out(p, 0.0)) {
                    continue;
                }
                const std::int32_t near = surface.tree.any_within(p, wanted + found.bound, nearest);
                nearest = near < 0 ? surface.tree.nearest_from(p, nearest).triangle : near;
                const Corners its = corners(surface, nearest);
                if (near < 0 && counted.has(p, its)) {
                    found = {distance(p, its) - wanted, p};
                }
            }
        }
    });
}

/// The same where work(triangle, bound) is of one triangle.
template <typename Work>
ProvenBound over_each(const std::vector<Corners>& triangles, const Progress& progress, const Work& work) {
    return over_all(triangles, progress, {}, [&](std::size_t first, std::size_t end, ProvenBound& found) {
        for (std::size_t t = first; t < end; ++t) {
            work(triangles[t], found);
        }
    });
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

/// Raises a bound to the bound for the points of one triangle.
///
/// What lies over a triangle of the surface is as far from that as its corners are, so that it is cut out: pieces
/// become as many as the triangles that they lie over, and not the smaller the closer the bound is. What is neither
/// near enough nor proven to be as far as that is halved.
class BoundOfTriangle {
  public:
    /// @param most  of the bound: above it the search ends
    /// @param is_inside  whether a point is inside of the surface: only others count; null: all count
    BoundOfTriangle(const SearchedSurface& surface, double wanted, double fineness, double most,
                    const Counted::Inside* is_inside = nullptr)
        : surface_(surface), wanted_(wanted), fineness_(fineness), most_(most), counted_(is_inside) {}

    /// What follows is faster for a triangle near the one before.
    /// @param found  is raised
    /// @param witnesses  gets the triangles of the surface near which pieces are that do not raise it; null: not asked
    /// for
    ProvenBound raised(const Corners& whole, const ProvenBound& found, std::vector<std::int32_t>* witnesses = nullptr) {
        found_ = found;
        witnesses_ = witnesses;
        if (wanted_ > 0.0) {  // no piece is nearer to the surface than the whole triangle is
            const Vec3 middle = centre(whole);
            const double near = nearest_within(whole, middle, surface_, wanted_);
            if (wanted_ - near > found_.bound) {
                found_ = {wanted_ - near, middle};
            }
        }
        stack_.assign(1, Piece());
        for (const Vec3& p : whole) {
            stack_.back().add(p);
        }
        while (!stack_.empty() && found_.bound <= most_) {
            const Piece piece = stack_.back();
            stack_.pop_back();
            settle(piece);
        }
        return found_;
    }

  private:
    bool is_near(const Piece& piece, const Corners& t) {
        far_ = piece.farthest_from(t);
        return far_ - wanted_ <= found_.bound;
    }
    void settle(const Piece& piece) {
        // The triangle that was nearest to the piece before is often near enough to this one, without a search.
        if (nearest_ >= 0 && is_near(piece, its_)) {
            accept();
            return;
        }
        const Vec3 here = piece.centre();
        // Outside of the surface points are at most as far from it as from the last point inside, less its depth.
        const double reach = counted_.all() ? 0.0 : piece.farthest_from(here) - found_.bound;
        if (counted_.leaves_out(here, reach)) {
            accept();
            return;
        }
        nearest_ = (nearest_ < 0 ? surface_.tree.nearest(here) : surface_.tree.nearest_from(here, nearest_)).triangle;
        if (nearest_ < 0) {
            found_ = {kNoDistance, here};
            return;
        }
        its_ = corners(surface_, nearest_);
        if (is_near(piece, its_) || is_all_inside(here, reach)) {
            accept();
            return;
        }
        Piece over = piece;
        const std::array<Plane, 3> planes = upright(its_);
        if (!piece.has_many() &&
            std::all_of(planes.begin(), planes.end(), [&](const Plane& p) { return p.height(here) < 0.0; })) {
            for (const Plane& plane : planes) {
                const std::array<Piece, 2> parts = cut(over, plane);
                if (parts[0].count > 0 && parts[1].count > 0) {
                    over = parts[0];
                    stack_.push_back(parts[1]);
                }
            }
            if (is_near(over, its_)) {
                accept();
                return;
            }
        }
        const Vec3* attained = attains(over);
        if (attained != nullptr || over.halvings == 2 * kMostDivisions) {
            found_ = {far_ - wanted_, attained != nullptr ? *attained : over.centre()};
            return;
        }
        for (const Piece& half : halves(over)) {
            if (half.count > 0) {
                stack_.push_back(half);
            }
        }
    }
    /// Whether all of a piece is inside: what is smaller than its distance from the surface lies on one side of it.
    bool is_all_inside(const Vec3& here, double reach) {
        return reach < distance(here, its_) && !counted_.has(here, its_);
    }
    void accept() {
        if (witnesses_ != nullptr) {
            witnesses_->push_back(nearest_);
        }
    }
    /// A corner that is as far from the surface as the piece is at most, but for the fineness; null: none is. Distances
    /// from one triangle are at least those from the surface: only corners as far from it as that can be as far from
    /// all of it.
    const Vec3* attains(const Piece& piece) {
        const double enough = std::min(far_ - fineness_, wanted_ + most_);
        const Vec3* end = piece.corners.data() + piece.count;
        const Vec3* found = std::find_if(piece.corners.data(), end, [&](const Vec3& p) {
            return wanted_ >= enough || (distance(p, its_) >= enough &&
                                         surface_.tree.any_within(p, enough, nearest_) < 0 && counted_.has(p));
        });
        return found == end ? nullptr : found;
    }

    const SearchedSurface& surface_;
    double wanted_;
    double fineness_;
    double most_;
    Counted counted_;
    ProvenBound found_;
    std::vector<std::int32_t>* witnesses_ = nullptr;
    std::vector<Piece> stack_;
    std::int32_t nearest_ = -1;  ///< to the last piece
    Corners its_;                ///< corners of that triangle
    double far_ = 0.0;           ///< the bound of the last piece's distance from it
};

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
    const ProvenBound least = farthest_sample(triangles, surface, wanted, {}, nullptr, progress);
    return over_all(triangles, progress, least, [&](std::size_t first, std::size_t end, ProvenBound& found) {
        BoundOfTriangle bound(surface, wanted, fineness, kNoDistance);
        for (std::size_t t = first; t < end; ++t) {
            found = bound.raised(triangles[t], found);
        }
    });
}

ProvenBound distance_of_points_outside(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                       const std::function<bool(const Vec3&)>& is_inside, double fineness,
                                       Progress& progress, double from) {
    std::atomic<std::size_t> done{0};
    const ProvenBound least = farthest_sample(triangles, surface, 0.0, {fineness, Vec3::Zero()}, &is_inside, progress);
    return over_all(triangles, progress, least, [&](std::size_t first, std::size_t end, ProvenBound& found) {
        BoundOfTriangle bound(surface, 0.0, fineness, kNoDistance, &is_inside);
        for (std::size_t t = first; t < end; ++t) {
            found = bound.raised(triangles[t], found);
        }
        const std::size_t so_far = done += end - first;
        progress.advance(from + (1.0 - from) * static_cast<double>(so_far) / static_cast<double>(triangles.size()));
    });
}

std::vector<std::int32_t> triangles_beyond(const std::vector<Corners>& triangles, const SearchedSurface& surface,
                                           double wanted, double most, double fineness, const Progress& progress,
                                           std::vector<std::vector<std::int32_t>>* witnesses,
                                           std::vector<Vec3>* places) {
    std::vector<ProvenBound> bounds(triangles.size());
    if (witnesses != nullptr) {
        witnesses->assign(triangles.size(), {});
    }
    for_blocks(triangles.size(), progress, [&](std::size_t, std::size_t first, std::size_t end) {
        BoundOfTriangle bound(surface, wanted, fineness, most);
        for (std::size_t t = first; t < end; ++t) {
            std::vector<std::int32_t>* its = witnesses != nullptr ? &(*witnesses)[t] : nullptr;
            bounds[t] = bound.raised(triangles[t], {most, Vec3::Zero()}, its);
        }
    });
    std::vector<std::int32_t> result;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (bounds[t].bound > most) {
            result.push_back(static_cast<std::int32_t>(t));
            if (places != nullptr) {
                places->push_back(bounds[t].where);
            }
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
    const ProvenBound coarse = over_each(triangles, progress, [&](const Corners& t, ProvenBound& found) {
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
    return over_each(triangles, progress, [&](const Corners& whole, ProvenBound& found) {
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

}  // namespace mq::mesh

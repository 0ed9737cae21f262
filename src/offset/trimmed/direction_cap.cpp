// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/direction_cap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "base/tuning.h"
#include "mesh/corner_table.h"

namespace mq::offset {

namespace {

/// Angles of at most this size (radians) define no direction.
constexpr double kNoAngle = 1e-6;

/// The signed area of a triangle on the unit sphere (Van Oosterom and Strackee 1983).
double signed_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

double fan_area(const std::vector<Vec3>& loop, const Vec3& apex) {
    double sum = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        sum += signed_area(apex, loop[i], loop[(i + 1) % loop.size()]);
    }
    return sum;
}

/// Refines a cap: divides sides inside of it that are too long, in both of their triangles.
class CapRefinement {
  public:
    CapRefinement(DirectionCap& cap, std::size_t border, double step, const Progress* progress)
        : cap_(cap),
          border_(static_cast<std::int32_t>(border)),
          least_cosine_(step < M_PI ? std::cos(step) : -2.0),
          pace_(progress) {}

    void run() {
        bool again = true;
        for (int round = 0; again && round < kMostRounds; ++round) {
            again = false;
            middle_.clear();
            std::vector<mesh::Triangle> done;
            for (const mesh::Triangle& t : cap_.triangles) {
                if (const int side = longest(t); side >= 0) {
                    middle(t[static_cast<std::size_t>(side)], t[static_cast<std::size_t>((side + 1) % 3)]);
                }
            }
            for (const mesh::Triangle& t : cap_.triangles) {
                pace_.step();
                again = divide(t, done) || again;
            }
            cap_.triangles = std::move(done);
            if (unfolded()) {
                flip();
            }
        }
    }

  private:
    const Vec3& at(std::int32_t v) const { return cap_.directions[static_cast<std::size_t>(v)]; }
    bool on_border(std::int32_t a, std::int32_t b) const {
        const std::int32_t low = std::min(a, b);
        const std::int32_t high = std::max(a, b);
        return high < border_ && (high - low == 1 || (low == 0 && high == border_ - 1));
    }

    /// The longest side of a triangle that is too long and not on the border; -1 if there is none.
    int longest(const mesh::Triangle& t) const {
        int result = -1;
        double least = least_cosine_;
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = t[static_cast<std::size_t>(k)];
            const std::int32_t b = t[static_cast<std::size_t>((k + 1) % 3)];
            if (!on_border(a, b) && at(a).dot(at(b)) < least) {
                least = at(a).dot(at(b));
                result = k;
            }
        }
        return result;
    }

    void middle(std::int32_t a, std::int32_t b) {
        const auto [found, fresh] =
            middle_.emplace(std::minmax(a, b), static_cast<std::int32_t>(cap_.directions.size()));
        if (fresh) {
            cap_.directions.push_back(on_arc(at(a), at(b), 0.5));
        }
    }

    /// Divides a triangle at the middles of its sides, one side after the other.
    bool divide(const mesh::Triangle& t, std::vector<mesh::Triangle>& done) const {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = t[static_cast<std::size_t>(k)];
            const std::int32_t b = t[static_cast<std::size_t>((k + 1) % 3)];
            const std::int32_t c = t[static_cast<std::size_t>((k + 2) % 3)];
            const auto found = middle_.find(std::minmax(a, b));
            if (found != middle_.end()) {
                divide({a, found->second, c}, done);
                divide({found->second, b, c}, done);
                return true;
            }
        }
        done.push_back(t);
        return false;
    }

    /// Whether all triangles show the same side outward, as those of a convex vertex do.
    bool unfolded() const {
        return std::all_of(cap_.triangles.begin(), cap_.triangles.end(),
                           [&](const mesh::Triangle& t) { return at(t[0]).dot(at(t[1]).cross(at(t[2]))) > kFlat; });
    }

    /// Flips sides to shorter ones if that leaves emptier circles, as Lawson (1977) does in a plane: a direction inside
    /// a circle lies above the plane of the circle.
    void flip() {
        for (bool again = true; again;) {
            again = false;
            const std::vector<std::int32_t> twins = mesh::edge_twins(cap_.triangles, cap_.directions.size());
            std::vector<char> changed(cap_.triangles.size(), 0);
            for (std::size_t c = 0; c < twins.size(); ++c) {
                pace_.step();
                if (twins[c] < 0 || static_cast<std::size_t>(twins[c]) < c) {
                    continue;
                }
                const auto d = static_cast<std::size_t>(twins[c]);
                mesh::Triangle& one = cap_.triangles[c / 3];
                mesh::Triangle& two = cap_.triangles[d / 3];
                const std::int32_t a = one[c % 3];
                const std::int32_t b = one[(c + 1) % 3];
                const std::int32_t left = one[(c + 2) % 3];
                const std::int32_t right = two[(d + 2) % 3];
                // A flip to a longer side is refused: refinement would divide that side and flip it back.
                const bool shorter = at(left).dot(at(right)) > at(a).dot(at(b));
                const bool whole = changed[c / 3] == 0 && changed[d / 3] == 0;
                if (shorter && whole && height(a, b, left, right) > kFlat && height(left, right, b, a) < -kFlat &&
                    height(right, left, a, b) < -kFlat) {
                    one = {left, right, b};
                    two = {right, left, a};
                    changed[c / 3] = changed[d / 3] = 1;
                    again = true;
                }
            }
        }
    }

    /// The height of d above the plane of a, b and c, times twice the area of their triangle, on the unit sphere.
    double height(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const {
        return (at(b) - at(a)).cross(at(c) - at(a)).dot(at(d) - at(a));
    }

    /// Heights up to this size are rounding errors.
    static constexpr double kFlat = 1e-12;

    DirectionCap& cap_;
    const std::int32_t border_;
    const double least_cosine_;
    CancelPace pace_;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middle_;
};

}  // namespace

Vec3 on_arc(const Vec3& from, const Vec3& to, double fraction) {
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    if (angle < kNoAngle) {
        return from;
    }
    if (M_PI - angle < kNoAngle) {
        const Vec3 across = from.unitOrthogonal();
        return on_arc(fraction < 0.5 ? from : across, fraction < 0.5 ? across : to, std::fmod(2.0 * fraction, 1.0));
    }
    return ((std::sin((1.0 - fraction) * angle) * from + std::sin(fraction * angle) * to) / std::sin(angle))
        .normalized();
}

DirectionCap cap_over(const std::vector<Vec3>& loop, const Vec3& mean, double curvature, double step,
                      const Progress* progress) {
    Vec3 area = Vec3::Zero();  // the vector area of the loop, which points to its middle
    for (std::size_t i = 0; i < loop.size(); ++i) {
        area += loop[i].cross(loop[(i + 1) % loop.size()]);
    }
    std::vector<Vec3> candidates;
    for (const Vec3& amid : {area, mean}) {
        if (amid.norm() > kNoAngle) {
            candidates.emplace_back(amid.normalized());
            candidates.emplace_back(-amid.normalized());
        }
    }
    candidates.insert(candidates.end(), loop.begin(), loop.end());
    // The area of a loop is known up to 4 pi, the area of the sphere; smaller differences come from the loop's own
    // deviation from the normals. Among the apexes that fit, the best one has all of the loop in front of it.
    const auto quality = [&](const Vec3& apex) {
        check_cancelled(progress);
        double least = 1.0;
        for (const Vec3& direction : loop) {
            least = std::min(least, apex.dot(direction));
        }
        return std::make_pair(std::abs(fan_area(loop, apex) - curvature) < 2.0 * M_PI, least);
    };
    const Vec3* apex = &candidates.front();
    for (const Vec3& candidate : candidates) {
        apex = quality(*apex) < quality(candidate) ? &candidate : apex;
    }
    DirectionCap cap;
    cap.directions = loop;
    const auto border = static_cast<std::int32_t>(loop.size());
    std::int32_t centre = border;
    for (std::int32_t i = 0; i < border && centre == border; ++i) {
        if ((loop[static_cast<std::size_t>(i)] - *apex).norm() < 1e-6) {
            centre = i;
        }
    }
    if (centre == border) {
        cap.directions.push_back(*apex);
    }
    for (std::int32_t i = 0; i < border; ++i) {
        const std::int32_t next = (i + 1) % border;
        if (i != centre && next != centre) {
            cap.triangles.push_back({centre, i, next});
        }
    }
    CapRefinement(cap, loop.size(), step, progress).run();
    return cap;
}

}  // namespace mq::offset

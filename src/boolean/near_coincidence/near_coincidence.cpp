// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/near_coincidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/predicates.h"

namespace mq::boolean {

namespace {

Vec3 unit_normal(const Soup& soup, std::int32_t t) {
    const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
    const Vec3& a = soup.vertices[static_cast<std::size_t>(c[0])];
    return (soup.vertices[static_cast<std::size_t>(c[1])] - a)
        .cross(soup.vertices[static_cast<std::size_t>(c[2])] - a)
        .normalized();
}

/// +1: the later operand's surface goes into the material of the earlier one, -1: out of it, 0: it stays.
int way_of(const Expression& expression, std::int32_t earlier, std::int32_t later) {
    switch (expression.pairing(earlier, later)) {
        case Pairing::Union:
        case Pairing::SecondLessFirst:
            return 1;
        case Pairing::Intersection:
        case Pairing::FirstLessSecond:
            return -1;
        case Pairing::None:
            break;
    }
    return 0;
}

/// A displacement d is to fulfil direction.dot(d) >= least.
struct HalfSpace {
    Vec3 direction = Vec3::Zero();
    double least = 0.0;
};

/// The shortest displacement in all half-spaces, of those with unit directions, by Hildreth's method (A quadratic
/// programming procedure, 1957): the multipliers are improved one by one. Not in all of them where they have no point
/// in common within the limit of rounds.
Vec3 shortest(const std::vector<HalfSpace>& spaces) {
    constexpr int kMostRounds = 200;  // a round costs one product of each half-space
    std::vector<double> multiplier(spaces.size(), 0.0);
    Vec3 d = Vec3::Zero();
    for (int round = 0; round < kMostRounds; ++round) {
        double largest = 0.0;
        for (std::size_t i = 0; i < spaces.size(); ++i) {
            const double missing = spaces[i].least - spaces[i].direction.dot(d);
            const double step = std::max(missing, -multiplier[i]);
            multiplier[i] += step;
            d += step * spaces[i].direction;
            largest = std::max(largest, std::abs(step) / std::max(spaces[i].least, 1e-300));
        }
        if (largest < 1e-3) {
            break;
        }
    }
    return d;
}

/// The planes that the vertices of the operands leave.
class PlanesToLeave {
  public:
    PlanesToLeave(const Soup& soup, const Expression& expression, const OverlapOptions& options)
        : soup_(soup), expression_(expression), options_(options), displacement_(soup.vertices.size(), Vec3::Zero()) {}

    /// Demands of the vertices of the later triangle that they are beyond the plane of the earlier one, which may have
    /// moved itself.
    void leave(std::int32_t earlier, std::int32_t later, double low, double high) {
        const int way = way_of(expression_, operand_of(soup_, earlier), operand_of(soup_, later));
        if (way == 0) {
            return;
        }
        const Vec3 direction = -way * unit_normal(soup_, earlier);
        double least = options_.clearance + (way > 0 ? high : -low);
        for (const std::int32_t v : soup_.triangles[static_cast<std::size_t>(earlier)]) {
            const double moved = direction.dot(displacement_[static_cast<std::size_t>(v)]);
            least = std::max(least, options_.clearance + (way > 0 ? high : -low) + moved);
        }
        if (least > 0.0) {
            for (const std::int32_t v : soup_.triangles[static_cast<std::size_t>(later)]) {
                planes_[v].push_back({direction, least});
            }
        }
    }

    /// Fixes the displacements of all vertices with planes.
    void settle() {
        for (const auto& [v, spaces] : planes_) {
            const Vec3 way = shortest(spaces);
            displacement_[static_cast<std::size_t>(v)] = way.norm() <= 2.0 * options_.tolerance ? way : Vec3::Zero();
        }
        planes_.clear();
    }
    const Vec3& displacement(std::size_t v) const { return displacement_[v]; }

  private:
    const Soup& soup_;
    const Expression& expression_;
    const OverlapOptions& options_;
    std::vector<Vec3> displacement_;
    std::unordered_map<std::int32_t, std::vector<HalfSpace>> planes_;
};

/// The triangles of one operand that have contacts, or a vertex of a triangle that has, with the gap that counts as
/// contact there.
std::vector<std::pair<std::int32_t, double>> around(const Soup& soup, const std::vector<std::int32_t>& near,
                                                    const ContactFace* first, const ContactFace* last,
                                                    double clearance) {
    const std::int32_t operand = operand_of(soup, first->later);
    std::unordered_map<std::int32_t, double> most;
    std::unordered_set<std::int32_t> vertices;
    for (const ContactFace* face = first; face != last; ++face) {
        double& known = most.emplace(face->later, 0.0).first->second;
        known = std::max(known, face->most);
        if (differs(*face)) {
            const Triangle& c = soup.triangles[static_cast<std::size_t>(face->later)];
            vertices.insert(c.begin(), c.end());
        }
    }
    std::vector<std::pair<std::int32_t, double>> result;
    for (const std::int32_t t : near) {
        const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
        if (operand_of(soup, t) == operand &&
            std::any_of(c.begin(), c.end(), [&](std::int32_t v) { return vertices.count(v) > 0; })) {
            const auto known = most.find(t);
            result.emplace_back(t, known != most.end() ? known->second : clearance);
        }
    }
    return result;
}

}  // namespace

bool differs(const ContactFace& face) {
    return face.low != 0.0 || face.high != 0.0;
}

NearCoincidence overlap_contacts(Soup& soup, const FacingSearch& search, const Expression& expression,
                                 const std::vector<ContactFace>& contacts, const OverlapOptions& options,
                                 const Progress& progress) {
    PlanesToLeave planes(soup, expression, options);
    CancelPace pace(progress);
    const ContactFace* end = contacts.data() + contacts.size();
    for (const ContactFace* first = contacts.data(); first != end;) {
        const ContactFace* last = std::find_if(first, end, [&](const ContactFace& face) {
            return operand_of(soup, face.later) != operand_of(soup, first->later);
        });
        for (const auto& [later, most] : around(soup, search.near(), first, last, options.clearance)) {
            pace.step();
            const std::int32_t t = later;
            const double gap = most;
            // What faces the triangle only where it has moved to counts, too.
            search.for_each_facing(t, gap, gap, [&](std::int32_t earlier, const Overlap& overlap) {
                if (-overlap.low <= gap && overlap.high <= gap) {
                    planes.leave(earlier, t, overlap.low, overlap.high);
                }
            });
        }
        planes.settle();
        first = last;
    }
    NearCoincidence result;
    soup.moved.resize(soup.vertices.size(), 0);
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
        const Vec3 target = to_single(soup.vertices[v] + planes.displacement(v));
        if (planes.displacement(v) != Vec3::Zero()) {
            result.largest = std::max(result.largest, (target - soup.vertices[v]).norm());
            soup.vertices[v] = target;
            soup.moved[v] = 1;
            ++result.moved;
        }
    }
    return result;
}

void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before) {
    const auto moved = [&](int v) -> char& { return soup.moved[static_cast<std::size_t>(v)]; };
    const auto at = [&](int v) -> Vec3& { return soup.vertices[static_cast<std::size_t>(v)]; };
    for (bool again = !soup.moved.empty(); again;) {
        again = false;
        for (const Triangle& c : soup.triangles) {
            if (std::any_of(c.begin(), c.end(), moved) && collinear(at(c[0]), at(c[1]), at(c[2]))) {
                for (const int v : c) {
                    at(v) = before[static_cast<std::size_t>(v)];
                    moved(v) = 0;
                }
                again = true;
            }
        }
    }
}

}  // namespace mq::boolean

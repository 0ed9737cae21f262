// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/near_coincidence.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/predicates.h"
#include "base/tuning.h"
#include "boolean/near_coincidence/tuning.h"

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
int offset_sign(const Expression& expression, std::int32_t earlier, std::int32_t later) {
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

/// The constraint direction.dot(d) >= least on a displacement d.
struct HalfSpace {
    Vec3 direction = Vec3::Zero();
    double least = 0.0;
    int rank = 0;  ///< if not all constraints can be met, those with lower ranks are
};

/// The shortest displacement in some half-spaces. Of least length under linear constraints, it is the least solution of
/// up to three of them as equations (a problem of the kind of linear programmes in few dimensions: Sharir and Welzl
/// 1992).
class ShortestDisplacement {
  public:
    /// Adds the most violated half-space to the active ones until none is violated: each addition lengthens the
    /// solution.
    /// @return nothing if no displacement is in all of them
    static std::optional<Vec3> in(const std::vector<HalfSpace>& spaces) {
        ShortestDisplacement solver(spaces);
        // Because of rounding the same sets could come again without end.
        for (int step = 0; step < kMostSteps; ++step) {
            const std::size_t worst = solver.farthest_from_kept();
            if (worst == spaces.size()) {
                return solver.best_;
            }
            if (!solver.add(worst)) {
                return std::nullopt;
            }
        }
        return std::nullopt;
    }

  private:
    explicit ShortestDisplacement(const std::vector<HalfSpace>& spaces) : spaces_(spaces) {
        for (const HalfSpace& space : spaces) {
            slack_ = std::max(slack_, kDistanceRounding * std::abs(space.least));
        }
    }

    double missing(std::size_t i, const Vec3& d) const { return spaces_[i].least - spaces_[i].direction.dot(d); }
    /// The number of half-spaces: all are kept.
    std::size_t farthest_from_kept() const {
        std::size_t worst = spaces_.size();
        double most = slack_;
        for (std::size_t i = 0; i < spaces_.size(); ++i) {
            if (missing(i, best_) > most) {
                worst = i;
                most = missing(i, best_);
            }
        }
        return worst;
    }

    /// Makes one more half-space active and finds the best solution.
    bool add(std::size_t added) {
        held_.push_back(added);
        std::optional<Vec3> best;
        std::vector<std::size_t> best_set;
        for (unsigned set = 1; set < 1u << held_.size(); ++set) {
            std::vector<std::size_t> chosen;
            for (std::size_t k = 0; k < held_.size(); ++k) {
                if ((set >> k & 1u) != 0) {
                    chosen.push_back(held_[k]);
                }
            }
            if (chosen.size() > 3) {
                continue;
            }
            const std::optional<Vec3> d = least_solution(chosen);
            if (d && (!best || d->norm() < best->norm()) &&
                std::all_of(held_.begin(), held_.end(), [&](std::size_t i) { return missing(i, *d) <= slack_; })) {
                best = d;
                best_set = chosen;
            }
        }
        if (best) {
            best_ = *best;
            held_ = best_set;
        }
        return best.has_value();
    }

    /// The shortest displacement in the planes that bound some half-spaces; nothing where these are nearly dependent.
    std::optional<Vec3> least_solution(const std::vector<std::size_t>& chosen) const {
        const auto n = static_cast<Eigen::Index>(chosen.size());
        Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> directions(n, 3);
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> least(n);
        for (Eigen::Index k = 0; k < n; ++k) {
            directions.row(k) = spaces_[chosen[static_cast<std::size_t>(k)]].direction.transpose();
            least[k] = spaces_[chosen[static_cast<std::size_t>(k)]].least;
        }
        const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> products =
            directions * directions.transpose();
        if (products.determinant() < kLeastDeterminant) {
            return std::nullopt;
        }
        return Vec3(directions.transpose() * products.inverse() * least);
    }

    static constexpr double kDistanceRounding = 1e-6;   ///< a fraction of the largest distance asked for
    static constexpr double kLeastDeterminant = 1e-10;  ///< planes at less than 1e-5 from each other are dependent

    const std::vector<HalfSpace>& spaces_;
    double slack_ = 0.0;
    Vec3 best_ = Vec3::Zero();
    std::vector<std::size_t> held_;
};

/// The planes beyond which the vertices of the operands have to move.
class PlanesToLeave {
  public:
    PlanesToLeave(const Soup& soup, const Expression& expression, const OverlapOptions& options)
        : soup_(soup), expression_(expression), options_(options), displacement_(soup.vertices.size(), Vec3::Zero()) {}

    /// Demands that the vertices of the later triangle lie beyond the plane of the earlier one, which may have been
    /// moved itself.
    void leave(std::int32_t earlier, std::int32_t later, const Overlap& overlap, bool beside) {
        const int way = offset_sign(expression_, operand_of(soup_, earlier), operand_of(soup_, later));
        if (way == 0) {
            return;
        }
        const Vec3 direction = -way * unit_normal(soup_, earlier);
        // If the vertices stay, a gap remains between bodies to be joined whose faces look at each other, and a film
        // between bodies to be separated whose faces look the same way. In the other cases only a face inside of the
        // other body remains.
        const bool tells = overlap.same_side == (way < 0);
        const int rank = (beside ? 2 : 0) + (tells ? 0 : 1);
        const double gap = options_.clearance + (way > 0 ? overlap.high : -overlap.low);
        double least = gap;
        for (const std::int32_t v : soup_.triangles[static_cast<std::size_t>(earlier)]) {
            const double moved = direction.dot(displacement_[static_cast<std::size_t>(v)]);
            least = std::max(least, gap + moved);
        }
        if (least > 0.0) {
            for (const std::int32_t v : soup_.triangles[static_cast<std::size_t>(later)]) {
                planes_[v].push_back({direction, least, rank});
            }
        }
    }

    /// Fixes the displacements of all vertices with planes.
    void assign_displacements() {
        for (const auto& [v, spaces] : planes_) {
            std::optional<Vec3> way = ShortestDisplacement::in(spaces);
            if (!way || way->norm() > options_.tolerance) {
                way = by_rank(spaces);
            }
            if (way) {
                displacement_[static_cast<std::size_t>(v)] = *way;
            }
        }
        planes_.clear();
    }
    const Vec3& displacement(std::size_t v) const { return displacement_[v]; }
    bool has_moved(std::int32_t t) const {
        const Triangle& c = soup_.triangles[static_cast<std::size_t>(t)];
        return std::any_of(c.begin(), c.end(),
                           [&](std::int32_t v) { return displacement_[static_cast<std::size_t>(v)] != Vec3::Zero(); });
    }

  private:
    /// The shortest displacement that keeps the half-spaces, which are added one by one in the order of their ranks as
    /// long as there is one.
    std::optional<Vec3> by_rank(std::vector<HalfSpace> spaces) const {
        std::stable_sort(spaces.begin(), spaces.end(),
                         [](const HalfSpace& a, const HalfSpace& b) { return a.rank < b.rank; });
        std::vector<HalfSpace> kept;
        std::optional<Vec3> result;
        for (const HalfSpace& space : spaces) {
            kept.push_back(space);
            const std::optional<Vec3> way = ShortestDisplacement::in(kept);
            // Displacements that join or separate bodies may be twice the tolerance long, at corners of three faces.
            if (way && way->norm() <= (space.rank == 0 ? 2.0 : 1.0) * options_.tolerance) {
                result = way;
            } else {
                kept.pop_back();
            }
        }
        return result;
    }
    const Soup& soup_;
    const Expression& expression_;
    const OverlapOptions& options_;
    std::vector<Vec3> displacement_;
    std::unordered_map<std::int32_t, std::vector<HalfSpace>> planes_;
};

/// The triangles of one operand that have contacts, or share a vertex with a triangle that has contacts, each with the
/// gap up to which contacts count.
std::vector<std::pair<std::int32_t, double>> around(const Soup& soup, const std::vector<std::int32_t>& near,
                                                    const ContactFace* first, const ContactFace* last,
                                                    const PlanesToLeave& planes, double clearance) {
    const std::int32_t operand = operand_of(soup, first->later);
    std::unordered_map<std::int32_t, double> most;
    std::unordered_set<std::int32_t> vertices;
    for (const ContactFace* face = first; face != last; ++face) {
        double& known = most.emplace(face->later, 0.0).first->second;
        known = std::max(known, face->most);
        if (differs(*face) || planes.has_moved(face->earlier)) {
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

/// Whether the pair is among those from `first` on, which are in ascending order of the later triangle.
bool is_listed(const ContactFace* first, const ContactFace* last, std::int32_t earlier, std::int32_t later) {
    const auto before = [](const ContactFace& face, const std::pair<std::int32_t, std::int32_t>& pair) {
        return std::pair(face.later, face.earlier) < pair;
    };
    const std::pair<std::int32_t, std::int32_t> pair(later, earlier);
    const ContactFace* found = std::lower_bound(first, last, pair, before);
    return found != last && found->later == later && found->earlier == earlier;
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
        std::set<std::pair<std::int32_t, bool>> common_faces;
        for (const ContactFace* face = first; face != last; ++face) {
            common_faces.insert({face->earlier, face->same_side});
        }
        for (const auto& [later, most] : around(soup, search.near(), first, last, planes, options.clearance)) {
            pace.step();
            const std::int32_t t = later;
            const double gap = most;
            // A triangle that faces this one only at its moved place counts if it belongs to a common face, or is
            // coplanar with this triangle.
            search.for_each_facing(t, gap, gap / NearCoincidenceTuning::kLargestGap,
                                   [&](std::int32_t earlier, const Overlap& overlap) {
                                       const bool common = common_faces.count({earlier, overlap.same_side}) > 0;
                                       const double limit = common ? gap : options.clearance;
                                       if (-overlap.low <= limit && overlap.high <= limit) {
                                           planes.leave(earlier, t, overlap, !is_listed(first, last, earlier, t));
                                       }
                                   });
        }
        planes.assign_displacements();
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

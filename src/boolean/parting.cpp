// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/parting.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/angle.h"

namespace mq::boolean {

namespace {

/// The surroundings of a copy.
struct Mover {
    Vec3 against_normals = Vec3::Zero();
    Vec3 along_edges = Vec3::Zero();
    double shortest = 1e300;
};

std::vector<Mover> look_around(const Draft& draft, const std::vector<std::int32_t>& copies) {
    std::unordered_map<std::int32_t, std::size_t> index;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        index.emplace(copies[i], i);
    }
    std::vector<Mover> movers(copies.size());
    for (const Triangle& c : draft.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto found = index.find(c[k]);
            if (found == index.end()) {
                continue;
            }
            Mover& mover = movers[found->second];
            const Vec3& p = draft.vertices[static_cast<std::size_t>(c[k])];
            const Vec3 u = draft.vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - p;
            const Vec3 v = draft.vertices[static_cast<std::size_t>(c[(k + 2) % 3])] - p;
            mover.against_normals -= angle_between(u, v) * u.cross(v).normalized();
            mover.along_edges += u.normalized() + v.normalized();
            mover.shortest = std::min({mover.shortest, u.norm(), v.norm()});
        }
    }
    return movers;
}

}  // namespace

PartingPlan plan_parting(const Extraction& extraction, double distance, double least, double most) {
    constexpr double kFactors[] = {1.0, 8.0, 0.125, 64.0, 512.0};
    constexpr double kPartOfEdge = 0.1;
    PartingPlan plan;
    std::vector<Vec3> place;
    for (const std::vector<std::int32_t>& copies : extraction.copies) {
        for (std::size_t i = 1; i < copies.size(); ++i) {
            plan.copies.push_back(copies[i]);
            place.push_back(extraction.draft.vertices[static_cast<std::size_t>(copies.front())]);
        }
    }
    if (plan.copies.empty()) {
        return plan;
    }
    const std::vector<Mover> movers = look_around(extraction.draft, plan.copies);
    for (const auto way : {&Mover::against_normals, &Mover::along_edges}) {
        for (const double factor : kFactors) {
            const double step = std::clamp(factor * distance, least, most);
            plan.variants.emplace_back();
            for (std::size_t i = 0; i < movers.size(); ++i) {
                const double length = std::min(step, kPartOfEdge * movers[i].shortest);
                plan.variants.back().push_back(place[i] + length * (movers[i].*way).normalized());
            }
        }
    }
    return plan;
}

void move_copies(Draft& draft, const PartingPlan& plan, std::size_t variant) {
    const double before = draft.largest_move;
    for (std::size_t i = 0; i < plan.copies.size(); ++i) {
        const auto v = static_cast<std::size_t>(plan.copies[i]);
        const Vec3& target = plan.variants[variant][i];
        draft.largest_move = std::max(draft.largest_move, before + (target - draft.vertices[v]).norm());
        draft.vertices[v] = target;
        draft.made[v] = kParted;
    }
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        for (const std::int32_t v : draft.triangles[t]) {
            if (draft.made[static_cast<std::size_t>(v)] == kParted) {
                draft.source[t] = Source{};
            }
        }
    }
}

}  // namespace mq::boolean

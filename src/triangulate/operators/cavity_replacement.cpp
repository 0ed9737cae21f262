// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/cavity_replacement.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/angle.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

bool within_bounds(const Workspace& work, const Sizing& sizing, const Cavity& disc, const Corner& apex, int apex_site) {
    return std::all_of(disc.rim.begin(), disc.rim.end(), [&](int side) {
        const Corner corner = corner_of(work.mesh, work.mesh.site_of(side));
        const double length = (corner.point - apex.point).norm();
        return work.mesh.site_of(side) == apex_site ||
               (length >= work.shortest_allowed() &&
                (!sizing.bounds.any() || length <= sizing.bounds.of(work.mesh, side)) &&
                (!(sizing.turn > 0.0) || angle_between(corner.normal, apex.normal) <= sizing.turn));
    });
}

std::optional<Exemption> withdraw_exemptions(Workspace& work, const std::vector<int>& triangles) {
    std::optional<Exemption> reason;
    for (const int t : triangles) {
        const Exemption* exemption = work.exemption_of(t);
        if (exemption != nullptr && (!reason || exemption->cause == Cause::NarrowCluster)) {
            reason = *exemption;
        }
        work.exempt.erase(t);
    }
    return reason;
}

void restore_exemptions(Workspace& work, const std::vector<int>& triangles, double bound,
                        std::optional<Exemption> reason) {
    for (const int t : triangles) {
        if (reason && smallest_angle(work.mesh, t).angle < bound) {
            reason->stamp = work.mesh.stamp(t);
            work.exempt[t] = *reason;
        }
    }
}

std::vector<int> replace_by_fan(Workspace& work, const Cavity& disc, int apex_site, double bound) {
    const std::optional<Exemption> reason = withdraw_exemptions(work, disc.triangles);
    std::vector<int> added = work.maxmin.replace(disc.triangles, fan(work.mesh, disc, apex_site));
    restore_exemptions(work, added, bound, reason);
    return added;
}

std::vector<std::pair<int, int>> close_gaps(Workspace& work) {
    for (auto it = work.exempt.begin(); it != work.exempt.end();) {
        it = work.exemption_of(it->first) == nullptr ? work.exempt.erase(it) : std::next(it);
    }
    std::vector<std::pair<int, int>> moved = work.mesh.compact();
    for (const auto& [from, to] : moved) {
        const auto found = work.exempt.find(from);
        if (found != work.exempt.end()) {
            Exemption exemption = found->second;
            exemption.stamp = work.mesh.stamp(to);
            work.exempt.erase(found);
            work.exempt[to] = exemption;
        }
    }
    return moved;
}

void close_gaps(Workspace& work, std::vector<int>& touched) {
    touched.erase(std::remove_if(touched.begin(), touched.end(), [&](int t) { return work.mesh.gone(t); }),
                  touched.end());
    const auto moved = close_gaps(work);
    const int count = work.mesh.triangle_count();
    touched.erase(std::remove_if(touched.begin(), touched.end(), [&](int t) { return t >= count; }), touched.end());
    for (const auto& [from, to] : moved) {
        touched.push_back(to);
    }
}

}  // namespace mq::triangulate

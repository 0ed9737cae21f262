// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/rounded_surface.h"

#include <algorithm>
#include <iterator>

#include "base/predicates.h"
#include "mesh/weld_vertices.h"

namespace mq::boolean {

RoundedSurface::RoundedSurface(const ResultMesh& draft) : vertices_(draft.vertices), made_(draft.vertices.size(), 0) {
    const std::vector<std::int32_t> first = mesh::equal_vertices(vertices_);
    for (std::size_t v = 0; v < made_.size(); ++v) {
        made_[v] = draft.made[v] == kConstructed ? 1 : 0;
    }
    for (std::size_t v = 0; v < made_.size(); ++v) {
        const auto f = static_cast<std::size_t>(first[v]);
        if (f != v && (made_[v] != 0 || made_[f] != 0)) {
            made_[f] = 1;
            edited_ = true;
        }
    }
    touched_ = made_;
    triangles_.reserve(draft.triangles.size());
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        Triangle corners = draft.triangles[t];
        bool fresh = false;
        for (std::int32_t& v : corners) {
            v = first[static_cast<std::size_t>(v)];
            fresh = fresh || made(v);
        }
        const bool degenerate = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (degenerate) {
            for (const std::int32_t v : corners) {
                touched_[static_cast<std::size_t>(v)] = 1;
            }
        } else {
            add(corners, static_cast<std::int32_t>(t), draft.displacement[t], true, fresh);
        }
    }
}

void RoundedSurface::add(const Triangle& corners, std::int32_t origin, double displacement, bool whole, bool fresh) {
    if (fresh) {
        changed_.push_back(static_cast<std::int32_t>(triangles_.size()));
    }
    triangles_.push_back(corners);
    origin_.push_back(origin);
    displacement_.push_back(displacement);
    alive_.push_back(1);
    whole_.push_back(whole ? 1 : 0);
    flat_.push_back(fresh && collinear(at(corners[0]), at(corners[1]), at(corners[2])) ? 1 : 0);
}

double RoundedSurface::largest_displacement() const {
    return displacement_.empty() ? 0.0 : *std::max_element(displacement_.begin(), displacement_.end());
}

std::vector<std::int32_t> RoundedSurface::flat() const {
    std::vector<std::int32_t> result;
    std::copy_if(changed_.begin(), changed_.end(), std::back_inserter(result),
                 [&](std::int32_t t) { return alive(t) && flat(t); });
    return result;
}

void RoundedSurface::replace(std::int32_t t, const std::vector<Triangle>& pieces, double move) {
    alive_[static_cast<std::size_t>(t)] = 0;
    edited_ = true;
    const std::int32_t from = origin(t);
    const double displaced = displacement(t) + move;
    for (const std::int32_t v : triangle(t)) {
        touched_[static_cast<std::size_t>(v)] = 1;
    }
    for (const Triangle& piece : pieces) {
        if (piece[0] != piece[1] && piece[1] != piece[2] && piece[2] != piece[0]) {
            add(piece, from, displaced, false, true);
        }
        for (const std::int32_t v : piece) {
            touched_[static_cast<std::size_t>(v)] = 1;
        }
    }
}

std::int32_t RoundedSurface::add_vertex(const Vec3& p) {
    vertices_.push_back(p);
    made_.push_back(1);
    touched_.push_back(1);
    frame_->add(p);
    return static_cast<std::int32_t>(vertices_.size()) - 1;
}

void RoundedSurface::index_added() {
    if (!base_.has_value()) {
        frame_.emplace(vertices_, triangles_);
        base_.emplace(frame_->vertices(), triangles_, frame_->slack());
        known_ = triangles_.size();
        return;
    }
    std::vector<std::int32_t> fresh;
    for (std::size_t t = known_; t < triangles_.size(); ++t) {
        if (alive_[t] != 0) {
            fresh.push_back(static_cast<std::int32_t>(t));
        }
    }
    added_.emplace(frame_->vertices(), triangles_, fresh, frame_->slack());
}

}  // namespace mq::boolean

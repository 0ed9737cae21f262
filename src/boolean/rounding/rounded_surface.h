// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "boolean/extraction/result_mesh.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/needle_frame.h"

namespace mq::boolean {

/// A surface whose vertices have been rounded: closed as a chain, every edge runs as often one way as the other, but
/// not yet embedded. Triangles can be replaced by others with the same border; all are found by place.
class RoundedSurface {
  public:
    /// @param draft  vertices in one place become one vertex here
    explicit RoundedSurface(const ResultMesh& draft);
    RoundedSurface(const RoundedSurface&) = delete;
    RoundedSurface& operator=(const RoundedSurface&) = delete;

    const std::vector<Vec3>& vertices() const { return vertices_; }
    const Vec3& at(std::int32_t v) const { return vertices_[static_cast<std::size_t>(v)]; }
    /// Triangles, those that were replaced among them.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const Triangle& triangle(std::int32_t t) const { return triangles_[static_cast<std::size_t>(t)]; }
    bool alive(std::int32_t t) const { return alive_[static_cast<std::size_t>(t)] != 0; }
    /// The triangle of the draft that this one is, or of which it is a piece.
    std::int32_t origin(std::int32_t t) const { return origin_[static_cast<std::size_t>(t)]; }
    /// How far at most the points of a triangle are from their exact places, mm.
    double displacement(std::int32_t t) const { return displacement_[static_cast<std::size_t>(t)]; }
    /// The largest displacement of any triangle, those that were replaced among them, mm.
    double largest_displacement() const;
    /// Whether a triangle is as it was in the draft.
    bool whole(std::int32_t t) const { return whole_[static_cast<std::size_t>(t)] != 0; }
    /// Whether a vertex was constructed or moved since the last rounding, or lies where such a one does.
    bool made(std::int32_t v) const { return made_[static_cast<std::size_t>(v)] != 0; }
    /// Whether a vertex is such a one, or is one of a replaced triangle or its pieces.
    bool touched(std::int32_t v) const { return touched_[static_cast<std::size_t>(v)] != 0; }
    /// Triangles with a vertex that was made, and pieces; those that were replaced among them.
    const std::vector<std::int32_t>& changed() const { return changed_; }
    /// The triangles whose corners lie on one line. They stay until they are replaced, or what they join would not.
    std::vector<std::int32_t> flat() const;
    bool flat(std::int32_t t) const { return flat_[static_cast<std::size_t>(t)] != 0; }
    /// Whether the surface differs from the draft: vertices merged, triangles replaced.
    bool edited() const { return edited_; }

    /// Replaces a triangle by pieces, each point of which is at most `move` (mm) from its place in the triangle; pieces
    /// that name a vertex twice are left out.
    void replace(std::int32_t t, const std::vector<Triangle>& pieces, double move);
    /// Adds a vertex; index_added() must have been called before. Returns its index.
    std::int32_t add_vertex(const Vec3& p);
    /// Makes the triangles that were added since the last call known to searches by place.
    void index_added();

    /// visit(t) for each triangle that has points at most `reach` (mm) from a place, and some others.
    template <typename Visit>
    void for_each_near(const Vec3& place, double reach, Visit&& visit) const {
        const Vec3 margin = Vec3::Constant(reach);
        const Vec3 p = frame_->turned(place);
        for_each_in_box({p - margin, p + margin}, visit);
    }
    /// visit(s) for each triangle that meets triangle t, and some others; t is among them.
    template <typename Visit>
    void for_each_beside(std::int32_t t, Visit&& visit) const {
        Box box;
        for (const std::int32_t v : triangle(t)) {
            box.add(frame_->vertices()[static_cast<std::size_t>(v)]);
        }
        for_each_in_box(box, visit);
    }

  private:
    void add(const Triangle& corners, std::int32_t origin, double displacement, bool whole, bool fresh);
    template <typename Visit>
    void for_each_in_box(Box box, Visit&& visit) const {
        box.low -= Vec3::Constant(frame_->slack());
        box.high += Vec3::Constant(frame_->slack());
        const auto living = [&](std::int32_t t) {
            if (alive(t)) {
                visit(t);
            }
        };
        for (const std::optional<mesh::AabbTree>* tree : {&base_, &added_}) {
            if (tree->has_value()) {
                (*tree)->for_each_in_box(box, living);
            }
        }
    }

    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::int32_t> origin_;
    std::vector<double> displacement_;
    std::vector<char> alive_;
    std::vector<char> whole_;
    std::vector<char> flat_;
    std::vector<char> made_;
    std::vector<char> touched_;
    std::vector<std::int32_t> changed_;
    bool edited_ = false;
    std::size_t known_ = 0;  ///< triangles that the trees know
    std::optional<mesh::NeedleFrame> frame_;
    std::optional<mesh::AabbTree> base_;
    std::optional<mesh::AabbTree> added_;
};

}  // namespace mq::boolean

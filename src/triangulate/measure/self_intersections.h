// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Finds triangles that meet elsewhere than in their common vertices and edges. Triangles of one volume, of one face,
/// or of loose faces that edges join to a sheet, must not. Entities that nothing joins, such as different solids or
/// single faces, may touch, and their chords may cross (see BodyContacts).
class SelfIntersections {
  public:
    using Faces = std::pair<int, int>;  ///< in ascending order; equal if a face meets itself

    explicit SelfIntersections(Workspace& work);

    /// Returns the pairs within one volume or sheet. Exact (see mesh::self_intersections); searched once as long as the
    /// mesh does not change.
    /// @throws Cancelled
    const std::vector<std::array<int, 2>>& pairs();
    /// Returns the pairs of loose faces that cross deeper than triangles that deviate from their faces by at most
    /// `deviation` (mm) can. @throws Cancelled
    std::vector<std::array<int, 2>> deep_loose_pairs(double deviation);
    /// Returns the other crossing pairs of different volumes. @throws Cancelled
    std::vector<std::array<int, 2>> pairs_of_bodies();
    /// Whether pairs were left out, as there are too many.
    bool incomplete() const { return incomplete_; }
    /// Counts the pairs by the faces they lie on.
    std::map<Faces, std::size_t> by_faces(const std::vector<std::array<int, 2>>& pairs) const;
    Faces faces_of(const std::array<int, 2>& pair) const;
    /// Returns the smaller of the depths by which each triangle penetrates the plane of the other, mm.
    double depth(const std::array<int, 2>& pair) const;

  private:
    bool one_volume(const Faces& faces) const;
    bool loose(const Faces& faces) const;
    double reach(int a, int b) const;
    void find_where_changed();
    void find();

    Workspace& work_;
    std::vector<std::vector<int>> volumes_of_face_;
    std::vector<int> sheet_of_face_;          // faces with common edges, whether or not a volume holds them
    std::vector<std::array<int, 2>> pairs_;   // pairs within one volume
    std::vector<std::array<int, 2>> others_;  // crossing pairs of entities that nothing joins
    bool incomplete_ = false;
    std::array<std::int64_t, 2> state_{-1, -1};  // edges made and triangles of the mesh at the last search
};

}  // namespace mq::triangulate

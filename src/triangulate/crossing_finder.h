// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Finds where triangles of one volume meet elsewhere than in their common vertices and edges. Different volumes, and
/// faces that no shell joins, may lie on each other as they like.
class CrossingFinder {
  public:
    using Faces = std::pair<int, int>;  ///< in ascending order; equal where a face meets itself

    explicit CrossingFinder(Workspace& work);

    /// Exact (see mesh::self_intersections); found once for a mesh that does not change. @throws Cancelled
    const std::vector<std::array<int, 2>>& pairs();
    /// How many of them there are between which faces.
    std::map<Faces, std::size_t> by_faces(const std::vector<std::array<int, 2>>& pairs) const;
    Faces faces_of(const std::array<int, 2>& pair) const;

  private:
    bool one_volume(const Faces& faces) const;
    void find();

    Workspace& work_;
    std::vector<std::vector<int>> volumes_of_face_;
    std::vector<std::array<int, 2>> pairs_;
    std::array<int, 2> state_{-1, -1};  // of the mesh that they are of: numbers of edges and triangles
};

}  // namespace mq::triangulate

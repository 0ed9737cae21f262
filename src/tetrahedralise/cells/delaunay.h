// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "tetrahedralise/cells/tetrahedralisation.h"

namespace mq::tetrahedralise {

/// Finds the cell that holds a point, from a cell nearby.
class Locator {
  public:
    explicit Locator(const Tetrahedralisation& mesh) : mesh_(mesh) {}
    /// @return a cell that holds the point, which may lie on its boundary; -1 where the walk leaves the mesh or does
    /// not end.
    int find(const Vec3& p, int start);

  private:
    const Tetrahedralisation& mesh_;
    std::uint32_t turn_ = 1;
};

/// Inserts points into a Delaunay tetrahedralisation, or into one whose boundary is given: the cells in whose
/// circumspheres a point lies give way to those that connect it with the boundary of their union (Bowyer 1981, Watson
/// 1981).
class CavityInsertion {
  public:
    explicit CavityInsertion(Tetrahedralisation& mesh) : mesh_(mesh) {}

    /// Looks for the cavity of a point that lies in `cell`. Where the mesh is not Delaunay, cells are left out until
    /// the point sees all faces of the cavity.
    /// @return whether there is one
    bool open(const Vec3& p, int cell);
    const std::vector<int>& cavity() const { return cavity_; }
    /// The cells that were examined: the cavity stays the same until one of these changes.
    const std::vector<int>& seen() const { return looked_at_; }
    /// The vertices of the cavity, without repetition.
    const std::vector<int>& corners() const { return corners_; }
    /// The new cells, with -1 in place of the new point as their last corner.
    const std::vector<std::array<int, 4>>& faces() const { return faces_; }
    /// Connects the point, the last one of the mesh, with the cavity.
    void close(int v);
    const std::vector<int>& created() const { return created_; }

  private:
    void grow(const Vec3& p, int cell);
    bool shrink(const Vec3& p, int cell);
    bool collect_corners();

    Tetrahedralisation& mesh_;
    std::vector<int> cavity_;
    std::vector<int> looked_at_;
    std::vector<int> corners_;
    std::vector<std::array<int, 4>> faces_;
    std::vector<int> created_;
    std::vector<char> inside_;
    std::vector<char> seen_;
};

/// The Delaunay tetrahedralisation of the points of a surface, in a tetrahedron far around them, whose corners follow
/// the points of the surface. Exact and deterministic, also for points on one sphere, which have several Delaunay
/// tetrahedralisations.
/// @throws MeshingFailed where two points coincide; Cancelled.
Tetrahedralisation delaunay_tetrahedralisation(const std::vector<Vec3>& points, const Progress& progress);

}  // namespace mq::tetrahedralise

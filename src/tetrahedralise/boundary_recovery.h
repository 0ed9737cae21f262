// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "tetrahedralise/cells/flips.h"
#include "tetrahedralise/cells/tetrahedralisation.h"
#include "tetrahedralise/surface_constraints.h"

namespace mq::tetrahedralise {

/// How edges and triangles of a surface came into a tetrahedralisation.
struct RecoveryCount {
    std::size_t missing_edges = 0;      ///< before recovery
    std::size_t missing_triangles = 0;  ///< after all edges were recovered
    std::size_t divisions = 0;          ///< points put on the surface, since no flip helped
};

/// Makes the edges and then the triangles of a surface edges and faces of a tetrahedralisation of its points: by flips
/// along them (George, Hecht and Saltel 1991) and, if no flip helps, by points on the surface, which are recorded in
/// the constraints.
class BoundaryRecovery {
  public:
    /// @param least_fraction of an edge between its ends and a point on it: points where obstacles cross the edge are
    /// fewest, but may crowd at a vertex; a point nearer to an end is put in the middle instead
    BoundaryRecovery(Tetrahedralisation& mesh, SurfaceConstraints& surface, double least_fraction,
                     const Progress& progress)
        : mesh_(mesh), surface_(surface), flipper_(mesh), least_fraction_(least_fraction), progress_(progress) {}

    /// @throws MeshingFailed where the surface intersects itself or no end is reached; Cancelled.
    RecoveryCount run();

  private:
    /// The first obstacle on the way from a vertex: an edge (v[2] is -1) or a face of a cell.
    struct Obstacle {
        std::array<int, 3> v{-1, -1, -1};
        int cell = -1;
    };
    using Edges = std::vector<std::array<int, 2>>;
    using Triangles = std::vector<SurfaceConstraints::Triangle>;

    Edges missing_edges();
    Triangles missing_triangles();
    void recover_edges(Edges missing);
    void recover_triangles(Triangles missing);
    bool recover_edge(int a, int b, int depth);
    bool advance(int a, int b, int depth);
    bool recover_triangle(const SurfaceConstraints::Triangle& t, int depth);
    bool remove_piercing(const SurfaceConstraints::Triangle& t, int depth);
    bool remove_edge(int p, int q, int depth, int chord_a, int chord_b);
    bool obstacle_on(int a, int b, Obstacle& found);
    bool piercing_edge(const SurfaceConstraints::Triangle& t, std::array<int, 2>& edge);
    void divide_edge(int a, int b);
    void divide_triangle(const SurfaceConstraints::Triangle& t);
    int insert(const Vec3& p, const std::vector<int>& cells);
    void count_division();

    Tetrahedralisation& mesh_;
    SurfaceConstraints& surface_;
    Flipper flipper_;
    double least_fraction_;
    const Progress& progress_;
    RecoveryCount count_;
    std::vector<int> star_;
    EdgeRing ring_;
    int calls_ = 0;
};

}  // namespace mq::tetrahedralise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "curve/volume/tetrahedral_mesh.h"

namespace mq::curve {

/// The tetrahedra around bad ones with all their control points in one list: the variables of an optimisation. Free are
/// the inner control points of edges and faces that lie inside the patch and not on the surface; vertices only where
/// they are named as loose.
class UntanglingPatch {
  public:
    /// @param loose inner vertices, all of whose elements are in the patch, that may move as well.
    /// @param degree degree of the shapes in the optimisation: the order of the mesh, or 2 to treat every edge as the
    /// quadratic through its middle, which is quick and near to the optimum of higher orders.
    /// @throws Cancelled
    UntanglingPatch(TetrahedralMesh& volume, const std::vector<int>& tetrahedra, const std::unordered_set<int>& loose,
                    int degree, const Progress& progress);

    const elements::Lattice& lattice() const { return lattice_; }
    std::size_t elements() const { return members_.size(); }
    const std::vector<int>& members() const { return members_; }
    std::size_t free_count() const { return free_.size(); }
    /// Positions of the free control points, one after the other.
    Eigen::VectorXd state() const;
    void set_state(const Eigen::VectorXd& state);
    /// The control points of element i in the present state.
    void gather(std::size_t i, std::vector<Vec3>& control) const;
    /// Adds the derivative by the control points of element i to that by the state.
    void scatter(std::size_t i, const std::vector<Vec3>& by_control, Eigen::VectorXd& gradient) const;
    /// Whether control point `p` of element i can move, by itself or because it is blended from the others.
    bool is_free(std::size_t i, int p) const;
    /// The J that element i shall have.
    double reference(std::size_t i) const { return reference_[i]; }

    /// Gives the free edges the average quadratic bulge of the edges around them, in several sweeps: the bulges of the
    /// fixed edges spread inwards.
    void propagate_curvature(int sweeps);
    /// Writes the state into the volume's shapes and measures the members.
    /// @return the number of vertices moved.
    int store(const Progress& progress);

  private:
    struct FreeEdge {
        int a;
        int b;
        std::vector<int> points;
    };
    struct FreeFace {
        std::array<int, 3> corners;
        std::vector<int> points;
    };
    std::vector<Vec3> edge_points(int a, int b) const;
    std::vector<Vec3> raised(const FreeEdge& edge) const;
    int add_point(const Vec3& p, bool free);
    void add_element(int t);
    void add_face(const std::array<int, 4>& v, const std::array<std::size_t, 3>& face, std::vector<int>& index);
    void reblend_faces();
    void forget_inner_faces();
    int move_vertices();
    bool inside_edge(int a, int b) const;
    bool inside_face(int a, int b, int c) const;

    TetrahedralMesh& volume_;
    const elements::Lattice& lattice_;
    std::vector<int> members_;
    std::unordered_set<int> loose_;
    std::unordered_set<int> is_member_;
    std::vector<std::vector<int>> points_of_;  // by element and lattice point; -1: blended, inside the region
    std::vector<double> reference_;
    std::vector<Vec3> points_;
    std::vector<int> slot_;  // by point: the index among the free ones, or -1
    std::vector<int> free_;
    std::vector<FreeEdge> edges_;
    std::vector<FreeFace> faces_;
    std::unordered_map<elements::EdgeKey, std::vector<int>>
        points_of_edge_;  // points from the lower vertex to the higher
    std::unordered_map<elements::FaceKey, std::vector<int>, KeyHash> points_of_face_;
    std::unordered_map<int, int> points_of_vertex_;
};

}  // namespace mq::curve

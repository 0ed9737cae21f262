// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/elementary/surface.h"

namespace mq::geometry {

/// The nearest point of a B-spline surface, or of a B-spline curve, without a guess. The spans are Bézier patches in
/// boxes around their poles, and hence around the patches; a patch is halved if its box is near to the query and its
/// content is not simple enough. The nearest box is examined first, and no box that is farther than the best point
/// found. If the derivatives of a patch are bounded such that the squared distance is convex over it, Newton's method
/// finds its only minimum. If not, far from the surface compared with its radius of curvature and at poles, patches are
/// halved until they are small.
class PatchTree {
  public:
    using Counts = std::function<bool(double u, double v)>;

    /// Holds the piece of the surface within the range, which may lie in any turn of a periodic surface.
    PatchTree(const Handle(Geom_BSplineSurface) & surface, const ParameterBox& range);
    PatchTree(const Handle(Geom_BSplineCurve) & curve, double from, double to);

    /// The smaller of `square` and of the squared distance of the nearest point at which `counts` holds. `counts` is
    /// called for the nearest point of each patch only: the caller measures the border of the region where it holds.
    double nearest(const Vec3& point, double square, const Counts& counts);

  private:
    // x, y, z times the weight, and the weight.
    using Homogeneous = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
    using Net = std::vector<Homogeneous>;  // the second parameter runs fastest
    /// The piece between two knots, and its intersection with the range.
    struct Span {
        std::array<double, 2> knots;
        std::array<double, 2> range;
        std::size_t pole;  // the first
    };
    using KnotSpans = std::array<std::vector<Span>, 2>;
    using Block = std::array<std::size_t, 4>;  // the first and the end of the spans in u, in v
    /// Where the first turn of a periodic parameter begins; a parameter without a period has one turn.
    struct Turn {
        double low;
        double period;
    };
    struct Node {
        Net net;  // empty where there are children
        std::array<double, 2> low{};
        std::array<double, 2> high{};
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // axes of the box, in columns
        Vec3 least = Vec3::Zero();                           // corner of the box, along the axes
        Vec3 most = Vec3::Zero();
        Vec3 middle = Vec3::Zero();  // centre of the box, in space
        double radius = 0.0;         // radius of the ball around the box
        double reach = 0.0;          // up to this distance from every point of the patch the squared distance is convex
        std::size_t longer = 0;      // the parameter to cut
        std::size_t child = 0;       // the first of two children, which are neighbours in the list; 0: none

        double square_distance(const Vec3& p) const;
    };
    struct Jet;
    struct Projection {
        double s[2];  // from 0 to 1 over the patch
        double square;
    };

    static std::vector<Span> spans_in(const TColStd_Array1OfReal& knots, const TColStd_Array1OfInteger& multiplicities,
                                      std::size_t degree, const Turn& first, double from, double to);
    void build(const KnotSpans& spans, const Net& poles, std::size_t columns);
    void group(std::size_t node, const KnotSpans& spans, const Block& block, const Net& poles, std::size_t columns);
    void fill(Node& node, const std::array<const Span*, 2>& spans, const Net& poles, std::size_t columns) const;
    std::array<Net, 2> cut(const Net& net, std::size_t along, double fraction) const;
    void set_box(Node& node) const;
    Net derived(Net net, const std::array<std::size_t, 2>& times) const;
    void set_reach(Node& node) const;
    void divide(std::size_t node);
    Jet at(const Net& net, const double (&s)[2]) const;
    static Vec2 step_from(const Jet& j, const Vec3& r, const Projection& projection, Vec2& gradient);
    Projection newton(const Net& net, const Vec3& p) const;
    bool settled(const Node& node, const Vec3& p, double square_of_box) const;

    std::array<std::size_t, 2> degree_;
    std::vector<Node> nodes_;  // the first is the root
    double least_radius_ = 0.0;
    std::vector<std::pair<double, std::size_t>> open_;  // a heap, kept between questions
};

}  // namespace mq::geometry

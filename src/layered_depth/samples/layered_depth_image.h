// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::layered_depth {

/// The uniform grid whose lines are the rays (Wang 2010, section II): 2^n cells along each side, so that the edges of
/// an octree's cells lie on rays. One unit of grid coordinates is the distance r between two rays.
class SampleGrid {
  public:
    /// `box` bounds the result; at least `resolution` rays lie along its cube, rounded up to 2^n + 1.
    SampleGrid(const Box& box, int resolution);

    /// mm: the distance between two rays of such a grid around a box with this longest side. The free cells around the
    /// box are included, which take some of the rays.
    static double spacing_of(double side, int resolution);
    /// The least resolution whose rays are no farther apart than `spacing`.
    static double resolution_for(double side, double spacing);

    int cells() const { return cells_; }
    int rays() const { return cells_ + 1; }
    /// The binary logarithm of cells().
    int levels() const { return levels_; }
    /// The distance r between two rays, mm.
    double spacing() const { return spacing_; }
    Vec3 to_grid(const Vec3& p) const { return (p - origin_) / spacing_; }
    Vec3 to_space(const Vec3& g) const { return origin_ + spacing_ * g; }

  private:
    Vec3 origin_;
    double spacing_ = 1.0;
    int levels_ = 0;
    int cells_ = 0;
};

/// The triangles of all operands in one list, those of the first operand first.
///
/// If the surface of an operand is open, each edge of its border is listed as a triangle (a, b, b) without area that no
/// ray meets: it stands for the missing surface. These triangles follow the operand's own.
struct OperandSet {
    /// @param borders  for each operand the edges (a, b, b) of its border (see mesh::SurfaceWinding::border); empty if
    /// all operands are closed
    explicit OperandSet(const std::vector<const mesh::TriangleMesh*>& operands,
                        const std::vector<std::vector<mesh::Triangle>>& borders = {});
    OperandSet(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) : OperandSet({&a, &b}) {}

    std::vector<Vec3> points;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::int32_t> first_triangle;  ///< first triangle of each operand, and the number of all
    std::vector<std::int32_t> first_gap;       ///< first border edge of each operand, as an index of a triangle
    std::vector<std::int32_t> first_point;     ///< first point of each operand, and the number of all
    /// The CAD face of each triangle, an index into the faces of its operand; -1 if the operand is a mesh. Empty if all
    /// operands are meshes.
    std::vector<std::int32_t> face;

    int size() const { return static_cast<int>(first_gap.size()); }
    int operand_of(std::int32_t triangle) const;
    /// Whether a triangle is an edge of a border.
    bool is_gap(std::int32_t triangle) const { return triangles[triangle][1] == triangles[triangle][2]; }
    /// The outward unit normal of a triangle; zero if it has no area.
    Vec3 unit_normal(std::int32_t triangle) const;
};

/// A unit normal as samples store it.
using SampleNormal = Eigen::Matrix<float, 3, 1, Eigen::DontAlign>;

/// The depths of a solid's surface along the rays of one direction. The samples of a ray are in ascending order.
///
/// The rays of axis a have the index v * rays + u, where u and v are their grid coordinates on axes a + 1 and a + 2
/// (modulo 3).
struct LayeredDepthImage {
    std::vector<std::uint32_t> begin;  ///< first sample of each ray in the arrays below, and the number of all
    std::vector<double> depth;         ///< grid coordinate along the ray
    std::vector<std::int32_t> code;    ///< the triangle if the ray enters the solid, ~triangle if it leaves
    /// Outward unit normal of the CAD surface at each sample (see sample_faces); empty: the normals of the triangles.
    std::vector<SampleNormal> normal;

    std::int32_t triangle(std::uint32_t i) const { return code[i] < 0 ? ~code[i] : code[i]; }
};

/// Joins the images of consecutive rays to one image, in parallel; `bands` is emptied.
LayeredDepthImage joined(std::vector<LayeredDepthImage>& bands);

/// The x-, y- and z-LDI of one solid.
using LayeredDepthSet = std::array<LayeredDepthImage, 3>;

}  // namespace mq::layered_depth

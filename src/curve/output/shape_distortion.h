// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "base/progress.h"
#include "curve/output/curved_mesh.h"

/// Distortion of curved elements: the deviation of their shape from that of the regular simplex.
///
/// At a point it is eta = |S|^2 / (d |det S|^(2/d)), S being the Jacobian matrix of the map from the regular simplex of
/// dimension d = 2, 3 to the element, |S| its Frobenius norm (Roca, Gargallo-Peiro, Sarrate 2012, "Defining quality
/// measures for high-order planar triangles and curved mesh generation"; on surfaces with the area for the determinant;
/// 1 / eta is the shape metric of Knupp 2001, "Algebraic mesh quality metrics"). It does not change with the size of
/// the element, is 1 where angles are those of the regular simplex, and grows without bound towards a fold. Where they
/// take a mean over the element, here it is the largest value: one bad place is enough to spoil a solution. For a
/// straight triangle it is the sum of the squared edges / (4 sqrt(3) area), mesh::TriangleShape::distortion.
///
/// It differs from the distortion I of Dey, O'Bara, Shephard (Quality::distortion), the ratio of volumes in one
/// element: a straight sliver has I = 1 and a large eta.
namespace mq::curve {

/// Relative accuracy of the results, which are upper bounds of the largest value: the Bernstein coefficients of the
/// determinant and of the norm bound both on pieces of the element, which are halved until the bound is within this
/// fraction of a value that is attained, or there are 1000 pieces (Johnen, Geuzaine, Toulorge, Remacle 2018, on
/// bounding shape measures).
constexpr double kDistortionAccuracy = 0.01;

/// Largest eta of a Bezier triangle in space. Infinite where it has no area; a fold does not show, see
/// normal_component.
double max_distortion_of_triangle(const elements::Lattice& lattice, const std::vector<Vec3>& control);

/// Largest eta of a Bezier tetrahedron. Infinite where the Jacobian is not proven to be positive everywhere.
double max_distortion_of_tetrahedron(const elements::Lattice& lattice, const std::vector<Vec3>& control);

/// Largest eta of each triangle of the mesh; infinite where it folds over its face.
/// @throws InvalidInput for a mesh without a triangle_quality for each triangle.
/// @throws Cancelled.
std::vector<double> triangle_distortions(const CurvedMesh& mesh, Progress* progress = nullptr);

/// Largest eta of each tetrahedron of the mesh.
/// @throws Cancelled when `progress` says so.
std::vector<double> tetrahedron_distortions(const CurvedMesh& mesh, Progress* progress = nullptr);

}  // namespace mq::curve

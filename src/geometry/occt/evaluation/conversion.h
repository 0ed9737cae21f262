// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Bnd_Box.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "base/vec.h"

namespace mq::geometry {

inline Vec3 to_vec(const gp_XYZ& p) {
    return Vec3(p.X(), p.Y(), p.Z());
}
inline Vec3 to_vec(const gp_Pnt& p) {
    return to_vec(p.XYZ());
}
inline Vec3 to_vec(const gp_Vec& v) {
    return to_vec(v.XYZ());
}
inline Vec3 to_vec(const gp_Dir& d) {
    return to_vec(d.XYZ());
}
inline gp_Pnt to_pnt(const Vec3& p) {
    return gp_Pnt(p.x(), p.y(), p.z());
}

inline Box to_box(const Bnd_Box& bounds) {
    Box box;
    if (!bounds.IsVoid()) {
        box.add(to_vec(bounds.CornerMin()));
        box.add(to_vec(bounds.CornerMax()));
    }
    return box;
}

/// A bound of the height of a function's peak over the highest of its samples, from three samples in a row. Four times
/// the value for a parabola.
inline double rise_over_sample(double before, double middle, double after) {
    return std::max(0.0, 0.5 * (2.0 * middle - before - after));
}

/// Whether a transformation turns what it moves inside out. gp_Trsf::IsNegative asks for the sign of the factor only,
/// which the IGES reader leaves positive where the matrix mirrors.
inline bool mirrors(const gp_Trsf& transformation) {
    return transformation.VectorialPart().Determinant() < 0.0;
}

/// Rounding of the factor of a rigid transformation: OpenCASCADE computes it from the matrix.
constexpr double kScaleRounding = 1e-12;

/// Whether a transformation is rigid but for rounding.
inline bool is_rigid(const gp_Trsf& transformation) {
    return std::abs(transformation.ScaleFactor() - 1.0) < kScaleRounding && !mirrors(transformation);
}

}  // namespace mq::geometry

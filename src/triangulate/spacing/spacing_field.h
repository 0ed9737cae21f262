// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

#include "base/tuning.h"
#include "base/vec.h"
#include "geometry/box_tree.h"

namespace mq::triangulate {

/// The bounds of the spacing of samples, mm.
struct SpacingBounds {
    double chord = 0.0;  ///< largest distance between the surface and a chord as long as the spacing; 0: no bound
    double least = 0.0;
    double most = 0.0;
};

/// Returns r(K) of Ruiz et al., section 2.3, as a formula: the chord of a circle with the given curvature (1/mm) that
/// is `bounds.chord` away from it, 2 sqrt(2 e / k - e^2), limited such that the circle turns by at most 40 degrees
/// over it. For a surface, k is the larger principal curvature: by the Gaussian curvature a cylinder would be flat.
double spacing_for(double curvature, const SpacingBounds& bounds);

/// The largest spacing that grows by at most kGrowth per mm of distance from given points, so that neighbouring
/// triangles differ in size by a bounded factor, on one face and across edges.
class SpacingField {
  public:
    /// Growth of the spacing in mm per mm of distance.
    MESHQUALITY_TUNED(double, kGrowth, 0.3);

    /// Adds a point in the shape's coordinates and its spacing, mm.
    void add(const Vec3& point, double spacing) { sources_.items.push_back({point, spacing}); }
    /// To be called after the last `add` and before the first `at`, and again after further additions. O(n log n).
    void build();
    /// Returns the least of `most` and, over all given points, their spacing plus kGrowth times the distance to them,
    /// mm.
    double at(const Vec3& point, double most) const;

  private:
    struct Source {
        Vec3 point;
        double spacing;
    };
    struct Bounds {
        Box box;
        double least = 1e300;
        void add(const Source& source) {
            box.add(source.point);
            least = std::min(least, source.spacing);
        }
        static const Vec3& position(const Source& source) { return source.point; }
    };

    geometry::BoxTree<Source, Bounds> sources_;
};

}  // namespace mq::triangulate

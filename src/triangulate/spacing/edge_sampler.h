// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/edges/edge_discretisation.h"
#include "triangulate/spacing/spacing_field.h"

namespace mq::triangulate {

/// Iso-metric samples of the CAD edges (Ruiz et al., step 0 of both algorithms): equal in arc length where the spacing
/// is constant, not in the curve's parameter. The faces that share an edge share its samples.
class EdgeSampler {
  public:
    /// Measures the curvature of every edge and of the faces beside it, from the chains' vertices with increasing
    /// density until neighbouring samples are at most two spacings apart, and adds the spacings to the field. `bounds`
    /// and `field` must outlive the sampler.
    EdgeSampler(geometry::Session& session, const EdgeDiscretisation& chains, const SpacingBounds& bounds,
                SpacingField& field);

    /// Samples every edge by the built field.
    void resample(EdgeDiscretisation& chains);

  private:
    struct EdgeSample {
        double t = 0.0;
        Vec3 point = Vec3::Zero();
        Vec3 tangent = Vec3::Zero();
        double spacing = 0.0;
    };
    using EdgeSamples = std::vector<EdgeSample>;
    /// The interval after sample `index` of an edge.
    struct Interval {
        int edge;
        std::size_t index;
    };

    EdgeSamples evaluate(int edge, const std::vector<double>& parameters);
    void measure_spacing(int edge, EdgeSamples& samples);
    std::vector<Interval> too_long(double share) const;
    bool halve(const std::vector<Interval>& intervals, bool by_field);
    void limit_by_length(int edge);
    std::vector<double> iso_metric(const EdgeSamples& samples, int least_pieces) const;

    geometry::Session& session_;
    const SpacingBounds& bounds_;
    SpacingField& field_;
    std::vector<EdgeSamples> samples_;  // by edge; empty for a collapsed one
};

}  // namespace mq::triangulate

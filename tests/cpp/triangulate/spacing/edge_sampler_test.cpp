// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/edge_sampler.h"

#include "triangulate/checks.h"
#include "triangulate/warped_face.h"

namespace mq::triangulate {
namespace {

/// Straight borders whose parameters are hundreds of times as fast at one end as at the other.
TEST(EdgeSampler, SamplesAreEqualInLengthNotInParameters) {
    const auto model = bezier_face([](int, int) { return 0.0; }, 20.0, 0.1);
    Pipeline pipeline(model);
    const SpacingBounds bounds{0.0, 0.01, 0.5};
    SpacingField field;
    EdgeSampler sampler(pipeline.session, pipeline.initial.chains, bounds, field);
    field.build();
    sampler.resample(pipeline.initial.chains);
    for (std::size_t e = 0; e < model->topology().edges.size(); ++e) {
        const EdgePolyline& chain = pipeline.initial.chains.chain(static_cast<int>(e));
        ASSERT_EQ(chain.t.size(), 21u);
        double least_step = 1e300;
        double most_step = 0.0;
        for (std::size_t i = 0; i + 1 < chain.t.size(); ++i) {
            const auto& vertices = pipeline.initial.chains.vertices();
            const double length = (vertices[chain.vertices[i + 1]].point - vertices[chain.vertices[i]].point).norm();
            EXPECT_NEAR(length, 0.5, 0.01);
            least_step = std::min(least_step, chain.t[i + 1] - chain.t[i]);
            most_step = std::max(most_step, chain.t[i + 1] - chain.t[i]);
        }
        EXPECT_GT(most_step, 20.0 * least_step);
    }
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/pseudo_delaunay.h"

#include <algorithm>
#include <random>

#include "geometry/analytic/analytic_model.h"
#include "triangulate/checks.h"
#include "triangulate/initial/face_boundary.h"
#include "triangulate/spacing/edge_sampler.h"
#include "triangulate/warped_face.h"

/// The connectivity of one face, from samples that the test chooses.
namespace mq::triangulate {
namespace {

/// One face with its sampled border, and samples at random (u, v) with a least distance.
class SampledFace {
  public:
    SampledFace(const std::shared_ptr<geometry::Model>& model, double spacing)
        : pipeline_(model),
          bounds_{0.0, 0.01, spacing},
          edges_(pipeline_.session, pipeline_.initial.chains, bounds_, field_),
          coarse_(pipeline_.initial.faces[0]) {
        field_.build();
        edges_.resample(pipeline_.initial.chains);
        std::string failure;
        border_ = face_boundary(pipeline_.session, pipeline_.initial.chains, pipeline_.grid, 0, failure);
        EXPECT_EQ(failure, "");
    }

    SamplingContext context() const { return {session(), pipeline_.grid, bounds_, field_, pipeline_.progress, 100000}; }
    std::vector<FaceSampler::Candidate> samples(int tries) const {
        const SamplingContext c = context();
        FaceSampler sampler(c, 0, border_, 0.7);
        const geometry::Face& face = session().topology().faces[0];
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> fraction(0.0, 1.0);
        for (int i = 0; i < tries; ++i) {
            const Vec2 uv(face.low[0] + fraction(random) * (face.high[0] - face.low[0]),
                          face.low[1] + fraction(random) * (face.high[1] - face.low[1]));
            const auto found = sampler.candidates({uv});
            if (found[0] && found[0]->fits && !sampler.crowded(found[0]->site.point, found[0]->spacing)) {
                sampler.accept(*found[0]);
            }
        }
        return sampler.samples();
    }
    FaceMesh triangulated(const std::vector<FaceSampler::Candidate>& samples) const {
        return triangulate_pseudo_delaunay(context(), 0, border_, samples, coarse_);
    }
    Vec3 point(const FaceMesh::VertexUse& site) const {
        return site.vertex >= 0 ? pipeline_.initial.chains.vertices()[static_cast<std::size_t>(site.vertex)].point
                                : site.point;
    }
    const FaceBoundary& border() const { return border_; }

  private:
    geometry::Session& session() const { return pipeline_.session; }

    mutable Pipeline pipeline_;
    SpacingBounds bounds_;
    SpacingField field_;
    EdgeSampler edges_;
    FaceMesh coarse_;
    FaceBoundary border_;
};

/// Every piece of the border once, every other edge twice, all samples used, a disc.
void expect_disc(const FaceMesh& mesh, std::size_t pieces, std::size_t samples) {
    ASSERT_EQ(mesh.failure, "");
    EXPECT_EQ(mesh.borders.size(), pieces);
    EXPECT_EQ(mesh.triangles.size(), pieces + 2 * samples - 2) << "Euler's formula of a disc";
    std::set<int> used;
    std::size_t at_border = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            used.insert(mesh.triangles[t][k]);
            const FaceMesh::Link& link = mesh.links[t][k];
            at_border += link.border >= 0 ? 1 : 0;
            if (link.border < 0) {
                const auto twin = static_cast<std::size_t>(link.half_edge);
                EXPECT_EQ(mesh.links[twin / 3][twin % 3].half_edge, static_cast<int>(3 * t + k));
            }
        }
    }
    EXPECT_EQ(at_border, pieces);
    EXPECT_EQ(used.size(), pieces + samples);
}

TEST(PseudoDelaunay, JoinsAllSamplesOfAWarpedFace) {
    for (const double spacing : {2.0, 1.0, 0.6}) {
        const SampledFace face(warped_face(1.0, 1.0), spacing);
        const auto samples = face.samples(4000);
        ASSERT_GT(samples.size(), 20u);
        expect_disc(face.triangulated(samples), face.border().pieces.size(), samples.size());
    }
}

TEST(PseudoDelaunay, OnAPlaneTheCircumcirclesAreEmpty) {
    const SampledFace face(bezier_face([](int, int) { return 0.0; }, 1.0, 1.0), 1.0);
    const auto samples = face.samples(3000);
    const FaceMesh mesh = face.triangulated(samples);
    expect_disc(mesh, face.border().pieces.size(), samples.size());
    for (const auto& t : mesh.triangles) {
        const Vec3 a = face.point(mesh.sites[static_cast<std::size_t>(t[0])]);
        const Vec3 b = face.point(mesh.sites[static_cast<std::size_t>(t[1])]) - a;
        const Vec3 c = face.point(mesh.sites[static_cast<std::size_t>(t[2])]) - a;
        const Vec3 normal = b.cross(c);
        const Vec3 centre =
            a + (c.squaredNorm() * normal.cross(b) + b.squaredNorm() * c.cross(normal)) / (2.0 * normal.squaredNorm());
        const double radius = (centre - a).norm();
        for (const FaceMesh::VertexUse& site : mesh.sites) {
            EXPECT_GE((face.point(site) - centre).norm(), radius * (1.0 - 1e-6));
        }
    }
}

TEST(PseudoDelaunay, TheParametersMakeNoDifference) {
    // The same surface with parameters up to 400 times as fast at one corner as at another.
    const SampledFace even(warped_face(1.0, 1.0), 1.0);
    const SampledFace uneven(warped_face(4.0, 5.0), 1.0);
    for (const SampledFace* face : {&even, &uneven}) {
        const auto samples = face->samples(6000);
        expect_disc(face->triangulated(samples), face->border().pieces.size(), samples.size());
    }
}

TEST(PseudoDelaunay, WithoutSamplesTheBorderAloneIsJoined) {
    const SampledFace face(bezier_face([](int, int) { return 0.0; }, 1.0, 1.0), 4.0);
    expect_disc(face.triangulated({}), face.border().pieces.size(), 0);
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/artefact_vertices.h"

#include <gtest/gtest.h>

#include <numeric>

#include "geometry/analytic/analytic_model.h"

namespace mq::given {
namespace {

/// The numbers of artefacts and of all CAD vertices.
std::pair<int, std::size_t> artefacts_of(const std::shared_ptr<geometry::Model>& model) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    const std::vector<char> found = artefact_vertices(session);
    return {std::accumulate(found.begin(), found.end(), 0), found.size()};
}

TEST(ArtefactVertices, AreThoseOfRimsAndSeams) {
    EXPECT_EQ(artefacts_of(geometry::make_cylinder(5.0, 10.0)), std::make_pair(2, std::size_t{2}));
    EXPECT_EQ(artefacts_of(geometry::make_torus(10.0, 3.0)), std::make_pair(1, std::size_t{1}));
}

TEST(ArtefactVertices, AreNoCornersPolesOrApexes) {
    EXPECT_EQ(artefacts_of(geometry::make_box(1.0, 2.0, 3.0)).first, 0);
    EXPECT_EQ(artefacts_of(geometry::make_sphere(5.0)).first, 0);
    EXPECT_EQ(artefacts_of(geometry::make_cone(5.0, 10.0)), std::make_pair(1, std::size_t{2}));
}

}  // namespace
}  // namespace mq::given

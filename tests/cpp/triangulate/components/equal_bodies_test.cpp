// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/equal_bodies.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <algorithm>
#include <memory>

#include "geometry/assemblies.h"
#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"

namespace mq::triangulate {
namespace {

using geometry::at_place;
using geometry::compound_of;
using Bodies = std::vector<std::vector<int>>;

TopoDS_Shape cone() {
    return BRepPrimAPI_MakeCone(2.0, 1.0, 5.0).Shape();
}

Bodies faces_of_volumes(const geometry::Topology& topology) {
    Bodies bodies;
    for (const geometry::Volume& volume : topology.volumes) {
        bodies.emplace_back();
        for (const geometry::Volume::Side& side : volume.sides) {
            bodies.back().push_back(side.face);
        }
        std::sort(bodies.back().begin(), bodies.back().end());
    }
    return bodies;
}

struct Found {
    std::shared_ptr<geometry::Model> model;
    EqualBodies equal;
};

Found found_in(
    const TopoDS_Shape& shape, const std::function<void(geometry::Entity, geometry::Fingerprint&)>& add_more =
                                   [](geometry::Entity, geometry::Fingerprint&) {}) {
    const auto model = geometry::make_shape_model(shape);
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    geometry::Session session(engine, model);
    return {model, find_equal_bodies(session, faces_of_volumes(model->topology()), add_more)};
}

void expect_moved(const Found& found, int copy) {
    const geometry::Topology& topology = found.model->topology();
    const auto c = static_cast<std::size_t>(copy);
    const auto original = static_cast<std::size_t>(found.equal.original[c]);
    const std::vector<int>& nodes = found.equal.entities[original].of[0];
    ASSERT_FALSE(nodes.empty());
    ASSERT_EQ(nodes.size(), found.equal.entities[c].of[0].size());
    for (const int n : nodes) {
        const int other = found.equal.in_copy({0, n}, copy);
        EXPECT_NE(n, other);
        EXPECT_LT((found.equal.motion[c].of_point(topology.nodes[static_cast<std::size_t>(n)].point) -
                   topology.nodes[static_cast<std::size_t>(other)].point)
                      .norm(),
                  1e-12);
    }
    for (const int u : found.equal.entities[original].uses) {
        const geometry::EdgeUse& here = topology.uses[static_cast<std::size_t>(u)];
        const geometry::EdgeUse& there = topology.uses[static_cast<std::size_t>(found.equal.use_in_copy(u, copy))];
        EXPECT_EQ(there.edge, found.equal.in_copy({1, here.edge}, copy));
        EXPECT_EQ(there.face, found.equal.in_copy({2, here.face}, copy));
        EXPECT_EQ(there.forward, here.forward);
    }
}

TEST(EqualBodies, AreTheSameAtAnotherPlace) {
    const Found found = found_in(compound_of({cone(), at_place(cone(), 10.0, 0.0)}));
    EXPECT_EQ(found.equal.original, (std::vector<int>{-1, 0}));
    const TopoDS_Shape one = cone();
    const Found same = found_in(compound_of({one, at_place(one, 10.0, 0.7), at_place(one, 20.0, 2.0)}));
    EXPECT_EQ(same.equal.original, (std::vector<int>{-1, 0, 0}));
    expect_moved(same, 1);
    expect_moved(same, 2);
}

TEST(EqualBodies, AreCopiesWithTheSameNumbers) {
    const TopoDS_Shape one = geometry::stored("filleted_box");
    const TopoDS_Shape copied = BRepBuilderAPI_Copy(one).Shape();
    const Found found = found_in(compound_of({at_place(one, 0.0, 1.0), at_place(copied, 50.0, 0.5)}));
    EXPECT_EQ(found.equal.original, (std::vector<int>{-1, 0}));
    expect_moved(found, 1);
}

TEST(EqualBodies, MayBeInAShapeThatIsPlacedItself) {
    const TopoDS_Shape one = cone();
    const Found found = found_in(at_place(compound_of({one, at_place(one, 10.0, 0.7)}), 3.0, 1.1));
    EXPECT_EQ(found.equal.original, (std::vector<int>{-1, 0}));
    expect_moved(found, 1);
}

TEST(EqualBodies, AreNoneThatAreMirroredScaledOrOther) {
    const TopoDS_Shape one = geometry::stored("filleted_box");
    const Found found = found_in(compound_of({one, at_place(geometry::mirrored(one), 50.0, 0.0),
                                              at_place(geometry::scaled(one, 1.0001), 100.0, 0.0),
                                              at_place(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(), 150.0, 0.0),
                                              at_place(BRepPrimAPI_MakeBox(1.0, 2.0, 3.000001).Shape(), 160.0, 0.0)}));
    EXPECT_EQ(found.equal.original, std::vector<int>(5, -1));
}

TEST(EqualBodies, HaveEqualDemands) {
    const TopoDS_Shape one = cone();
    const TopoDS_Shape shape = compound_of({one, at_place(one, 10.0, 0.7), at_place(one, 20.0, 0.7)});
    const int edges = static_cast<int>(geometry::make_shape_model(shape)->topology().edges.size());
    const Found found = found_in(shape, [&](geometry::Entity entity, geometry::Fingerprint& key) {
        if (entity == geometry::Entity{1, edges - 1}) {  // of the last one
            geometry::add_to(key, 0.5);
        }
    });
    EXPECT_EQ(found.equal.original, (std::vector<int>{-1, 0, -1}));
}

/// A vertex of several contracted nodes is at the lowest one, which may be of faces that were left out.
TEST(EqualBodies, EntitiesOfNoBodyHaveNoneInACopy) {
    Found found = found_in(compound_of({cone(), at_place(cone(), 10.0, 0.7)}));
    ASSERT_EQ(found.equal.original, (std::vector<int>{-1, 0}));
    EXPECT_GE(found.equal.in_copy({0, 0}, 1), 0);
    found.equal.places[0].push_back(-1);
    const int left_out = static_cast<int>(found.equal.places[0].size()) - 1;
    EXPECT_EQ(found.equal.in_copy({0, left_out}, 1), -1);
}

TEST(EqualBodies, ShareNothing) {
    const Found found = found_in(geometry::twin_solids());
    ASSERT_EQ(found.equal.original.size(), 2U);
    EXPECT_EQ(found.equal.original, std::vector<int>(2, -1));
}

}  // namespace
}  // namespace mq::triangulate

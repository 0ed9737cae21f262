// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/classified_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "triangulate/work_mesh/mesh_shaker.h"

namespace mq::triangulate {
namespace {

/// Returns V - E + F with an edge for every pair of twins and every segment.
int euler(const ClassifiedMesh& mesh) {
    std::set<int> vertices;
    int half_edges = 0;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        vertices.insert(mesh.vertex_of(h));
        half_edges += mesh.twin(h) >= 0 ? 1 : 0;
    }
    return static_cast<int>(vertices.size()) - half_edges / 2 - mesh.segment_count() + mesh.triangle_count();
}

/// Returns the signed area of every face in (u, v), which no operation changes, even with inverted triangles.
std::map<int, double> areas(const ClassifiedMesh& mesh) {
    std::map<int, double> result;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec2 a = mesh.site(mesh.site_of(3 * t)).uv;
        const Vec2 b = mesh.site(mesh.site_of(3 * t + 1)).uv - a;
        const Vec2 c = mesh.site(mesh.site_of(3 * t + 2)).uv - a;
        result[mesh.face_of(t)] += 0.5 * (b.x() * c.y() - b.y() * c.x());
    }
    return result;
}

/// Checks that the segments of a CAD edge are connected by vertices and by parameter, and all have the same number of
/// uses.
void expect_chains(const ClassifiedMesh& mesh) {
    std::map<int, std::map<double, int>> by_edge;
    for (int s = 0; s < mesh.segment_count(); ++s) {
        ASSERT_TRUE(by_edge[mesh.segment(s).edge].emplace(mesh.segment(s).t[0], s).second);
    }
    for (const auto& [edge, chain] : by_edge) {
        int last = -1;
        for (const auto& [t, s] : chain) {
            const ClassifiedMesh::Segment& here = mesh.segment(s);
            EXPECT_LT(here.t[0], here.t[1]);
            if (last >= 0) {
                const ClassifiedMesh::Segment& before = mesh.segment(last);
                EXPECT_EQ(before.t[1], here.t[0]) << "edge " << edge;
                EXPECT_EQ(before.vertices[1], here.vertices[0]) << "edge " << edge;
                ASSERT_EQ(before.uses.size(), here.uses.size()) << "edge " << edge;
                for (std::size_t k = 0; k < here.uses.size(); ++k) {
                    EXPECT_EQ(before.uses[k].use, here.uses[k].use);
                    EXPECT_EQ(mesh.face_of(before.uses[k].half_edge / 3), mesh.face_of(here.uses[k].half_edge / 3));
                }
            }
            for (const ClassifiedMesh::SegmentUse& use : here.uses) {
                EXPECT_EQ(mesh.segment_of(use.half_edge), s);
            }
            last = s;
        }
    }
}

/// Checks that the star contains all half-edges that leave the site, each once, counter-clockwise.
void expect_stars(const ClassifiedMesh& mesh) {
    std::map<int, std::size_t> leaving;
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        ++leaving[mesh.site_of(h)];
    }
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const std::vector<int> star = mesh.star(h);
        ASSERT_EQ(star.size(), leaving[mesh.site_of(h)]);
        ASSERT_EQ(std::count(star.begin(), star.end(), h), 1);
        const bool closed = mesh.segment_of(star.front()) < 0;
        if (closed) {
            EXPECT_EQ(star.front(), h);
        }
        for (std::size_t i = 0; i < star.size(); ++i) {
            ASSERT_EQ(mesh.site_of(star[i]), mesh.site_of(h));
            const int after = mesh.twin(ClassifiedMesh::prev(star[i]));
            const bool last = i + 1 == star.size();
            ASSERT_EQ(after, last ? (closed ? star.front() : -1) : star[i + 1]);
        }
    }
}

/// Removes a vertex inside a face, if none of the new edges exists already.
bool take_out(ClassifiedMesh& mesh, int h) {
    const std::vector<int> star = mesh.star(h);
    if (mesh.segment_of(star.front()) >= 0) {
        return false;
    }
    std::vector<int> removed;
    std::set<int> ring;
    for (const int spoke : star) {
        removed.push_back(spoke / 3);
        ring.insert(mesh.vertex_of(ClassifiedMesh::next(spoke)));
    }
    const int apex = ClassifiedMesh::next(star.front());
    for (const int spoke : mesh.star(apex)) {
        const int to = mesh.vertex_of(ClassifiedMesh::next(spoke));
        const bool beside = to == mesh.vertex_of(ClassifiedMesh::prev(star.front())) ||
                            to == mesh.vertex_of(ClassifiedMesh::next(star.back()));
        if (ring.count(to) > 0 && !beside) {
            return false;
        }
    }
    std::vector<std::array<int, 3>> added;
    for (std::size_t i = 1; i + 1 < star.size(); ++i) {
        added.push_back({mesh.site_of(apex), mesh.site_of(ClassifiedMesh::next(star[i])),
                         mesh.site_of(ClassifiedMesh::next(star[i + 1]))});
    }
    if (ring.size() != star.size() || added.empty()) {
        return false;
    }
    mesh.replace(removed, added);
    return true;
}

TEST(ClassifiedMesh, SamplesAreWhatTheyShouldBe) {
    for (const Sample& sample : all_samples()) {
        EXPECT_EQ(sample.mesh.inconsistency(), "") << sample.name;
        expect_stars(sample.mesh);
    }
    EXPECT_EQ(euler(samples::sheet(3, 2)), 1);
    EXPECT_EQ(euler(samples::tube(4, 2)), 0);
}

TEST(ClassifiedMesh, SplitTriangleKeepsItsSides) {
    ClassifiedMesh mesh = samples::sheet(3, 2);
    for (const int t : {0, 5}) {
        const std::array<int, 3> corners{mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
        const int site = mesh.add_site({mesh.add_vertex(Vec3(0.3, 0.2, 0), {2, 0})});
        const std::array<int, 3> made = mesh.split_triangle(t, site);
        EXPECT_EQ(made[0], t);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(mesh.site_of(3 * made[i]), corners[i]);
            EXPECT_EQ(mesh.site_of(3 * made[i] + 1), corners[(i + 1) % 3]);
            EXPECT_EQ(mesh.site_of(3 * made[i] + 2), site);
        }
        EXPECT_EQ(mesh.star(3 * t + 2).size(), 3u);
        EXPECT_EQ(mesh.inconsistency(), "");
    }
}

TEST(ClassifiedMesh, ReplacedTrianglesKeepTheRimAndCompactClosesTheGaps) {
    for (Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        ClassifiedMesh& mesh = sample.mesh;
        const int euler_before = euler(mesh);
        const std::map<int, double> areas_before = areas(mesh);
        Shaker shaker(mesh, 5);
        int taken = 0;
        for (int round = 0; round < 60; ++round) {
            for (int i = 0; i < 5; ++i) {
                shaker.step();
            }
            for (int h = 0; h < mesh.half_edge_count(); h += 7) {
                const int before = mesh.triangle_count();
                if (take_out(mesh, h)) {
                    ++taken;
                    EXPECT_EQ(mesh.inconsistency(), "");
                    for (const auto& [from, to] : mesh.compact()) {
                        EXPECT_GE(from, mesh.triangle_count());
                        EXPECT_LT(to, mesh.triangle_count());
                    }
                    EXPECT_EQ(mesh.triangle_count(), before - 2);
                    break;
                }
            }
            ASSERT_EQ(mesh.inconsistency(), "");
            ASSERT_EQ(euler(mesh), euler_before);
        }
        EXPECT_GT(taken, 10);
        for (const auto& [face, area] : areas(mesh)) {
            EXPECT_NEAR(area, areas_before.at(face), 1e-9);
        }
        expect_chains(mesh);
        expect_stars(mesh);
    }
}

/// A vertex of a seam has a site on either side, which swaps across the dissolved seam exchange: what is put back is
/// found by its vertices then.
TEST(ClassifiedMesh, SwapsAcrossADissolvedSeamCanBeUndone) {
    const ClassifiedMesh tube = samples::tube(4, 2);
    int seams = 0;
    for (int s = 0; s < tube.segment_count(); ++s) {
        if (tube.segment(s).uses.size() != 2) {
            continue;
        }
        ++seams;
        ClassifiedMesh mesh = tube;
        const int h = mesh.segment(s).uses[0].half_edge;
        mesh.dissolve(s);
        std::vector<int> both{ClassifiedMesh::triangle_of(h), ClassifiedMesh::triangle_of(mesh.twin(h))};
        std::vector<std::array<int, 3>> before;
        for (const int t : both) {
            before.push_back({mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)});
        }
        mesh.swap(h);
        EXPECT_EQ(mesh.inconsistency(), "");
        mesh.replace(both, before);
        EXPECT_EQ(mesh.inconsistency(), "");
    }
    EXPECT_GT(seams, 0);
}

TEST(ClassifiedMesh, SplitSegmentSplitsItForEveryUse) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        for (int s = 0; s < sample.mesh.segment_count(); ++s) {
            ClassifiedMesh mesh = sample.mesh;
            const ClassifiedMesh::Segment old = mesh.segment(s);
            const int far = Shaker(mesh, 1).split_segment(s);
            const ClassifiedMesh::Segment& a = mesh.segment(s);
            const ClassifiedMesh::Segment& b = mesh.segment(far);
            EXPECT_EQ(a.vertices[0], old.vertices[0]);
            EXPECT_EQ(b.vertices[1], old.vertices[1]);
            EXPECT_EQ(a.vertices[1], b.vertices[0]);
            EXPECT_EQ(mesh.triangle_count(), sample.mesh.triangle_count() + static_cast<int>(old.uses.size()));
            EXPECT_EQ(mesh.inconsistency(), "");
            expect_chains(mesh);
            expect_stars(mesh);
        }
    }
}

/// Joining restores the triangles that splitting divided, for every use.
TEST(ClassifiedMesh, JoinedSegmentsAreThoseBeforeTheSplit) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        for (int s = 0; s < sample.mesh.segment_count(); ++s) {
            ClassifiedMesh mesh = sample.mesh;
            const ClassifiedMesh::Segment old = mesh.segment(s);
            const int far = Shaker(mesh, 1).split_segment(s);
            std::vector<ClassifiedMesh::CavityFill> refills;
            for (const ClassifiedMesh::SegmentUse& use : old.uses) {
                const int h = use.half_edge;
                const std::array<int, 3> corners{sample.mesh.site_of(h), sample.mesh.site_of(ClassifiedMesh::next(h)),
                                                 sample.mesh.site_of(ClassifiedMesh::prev(h))};
                const int other = static_cast<int>(refills.size()) + sample.mesh.triangle_count();
                refills.push_back({{h / 3, other}, {corners}, {corners[0], corners[1]}});
            }
            mesh.join_segments(s, far, refills);
            EXPECT_EQ(mesh.segment(s).vertices, old.vertices);
            EXPECT_EQ(mesh.segment(s).t, old.t);
            EXPECT_TRUE(mesh.segment(far).uses.empty());
            EXPECT_EQ(mesh.inconsistency(), "");
            mesh.compact();
            EXPECT_EQ(mesh.triangle_count(), sample.mesh.triangle_count());
            EXPECT_EQ(mesh.inconsistency(), "");
            for (int t = 0; t < mesh.triangle_count(); ++t) {
                EXPECT_FALSE(mesh.gone(t));
            }
        }
    }
}

/// Only triangles around the vertex count as changed, and nothing uses the old vertex any more.
TEST(ClassifiedMesh, AnotherVertexTakesThePlaceBetweenTwoSegments) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        for (int s = 0; s < sample.mesh.segment_count(); ++s) {
            ClassifiedMesh mesh = sample.mesh;
            const int far = Shaker(mesh, 1).split_segment(s);
            const int old = mesh.segment(s).vertices[1];
            const int vertex = mesh.add_vertex(mesh.vertex(old).point, mesh.vertex(old).entity);
            std::vector<std::vector<int>> spokes;
            std::vector<int> sites;
            std::set<int> around;
            for (const ClassifiedMesh::SegmentUse& use : mesh.segment(s).uses) {
                const int h =
                    mesh.vertex_of(use.half_edge) == old ? use.half_edge : ClassifiedMesh::next(use.half_edge);
                spokes.push_back(mesh.star(h));
                ClassifiedMesh::VertexUse site = mesh.site(mesh.site_of(h));
                site.vertex = vertex;
                sites.push_back(mesh.add_site(site));
                for (const int spoke : spokes.back()) {
                    around.insert(spoke / 3);
                }
            }
            const ClassifiedMesh before = mesh;
            mesh.replace_between(s, far, vertex, 0.25, spokes, sites);
            EXPECT_EQ(mesh.inconsistency(), "");
            EXPECT_EQ(mesh.segment(s).t[1], 0.25);
            EXPECT_EQ(mesh.segment(far).t[0], 0.25);
            for (int h = 0; h < mesh.half_edge_count(); ++h) {
                EXPECT_NE(mesh.vertex_of(h), old);
                EXPECT_EQ(mesh.stamp(h / 3) != before.stamp(h / 3), around.count(h / 3) > 0);
                const bool at_vertex = mesh.vertex_of(h) == vertex || mesh.vertex_of(ClassifiedMesh::next(h)) == vertex;
                EXPECT_EQ(mesh.number_of(h) != before.number_of(h), at_vertex);
            }
        }
    }
}

TEST(ClassifiedMesh, SegmentsHaveOneTwoAndThreeUses) {
    const auto most_uses = [](const ClassifiedMesh& mesh) {
        std::size_t most = 0;
        for (int s = 0; s < mesh.segment_count(); ++s) {
            most = std::max(most, mesh.segment(s).uses.size());
        }
        return most;
    };
    EXPECT_EQ(most_uses(samples::sheet(3, 2)), 1u);
    EXPECT_EQ(most_uses(samples::book(2, 2, 2)), 2u);
    EXPECT_EQ(most_uses(samples::book(3, 2, 1)), 3u);
    EXPECT_EQ(most_uses(samples::tube(4, 2)), 2u);
}

TEST(ClassifiedMesh, ASecondSwapRestoresTheEdge) {
    for (const Sample& sample : all_samples()) {
        ClassifiedMesh mesh = sample.mesh;
        for (int h = 0; h < mesh.half_edge_count(); ++h) {
            if (!Shaker(mesh, 1).legal_swap(h)) {
                continue;
            }
            const int g = mesh.twin(h);
            const int t = h / 3;
            const int o = g / 3;
            const auto undirected = [&](int k) -> std::pair<int, int> {
                return std::minmax(mesh.site_of(k), mesh.site_of(ClassifiedMesh::next(k)));
            };
            const std::pair<int, int> before = undirected(h);
            const std::pair<int, int> opposite =
                std::minmax(mesh.site_of(ClassifiedMesh::prev(h)), mesh.site_of(ClassifiedMesh::prev(g)));
            const auto shared = [&] {
                int found = -1;
                for (int k = 3 * t; k < 3 * t + 3; ++k) {
                    found = mesh.twin(k) >= 0 && mesh.twin(k) / 3 == o ? k : found;
                }
                return found;
            };
            mesh.swap(h);
            ASSERT_GE(shared(), 0);
            EXPECT_EQ(undirected(shared()), opposite);
            EXPECT_EQ(mesh.inconsistency(), "");
            mesh.swap(shared());
            EXPECT_EQ(undirected(shared()), before);
            EXPECT_EQ(mesh.inconsistency(), "");
        }
    }
}

TEST(ClassifiedMesh, StaysConsistentUnderLongRandomSequences) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            ClassifiedMesh mesh = sample.mesh;
            const int characteristic = euler(mesh);
            const std::map<int, double> area = areas(mesh);
            Shaker shaker(mesh, seed);
            for (int i = 0; i < 300; ++i) {
                shaker.step();
                ASSERT_EQ(mesh.inconsistency(), "") << "seed " << seed << ", step " << i;
            }
            EXPECT_EQ(euler(mesh), characteristic);
            expect_chains(mesh);
            expect_stars(mesh);
            for (const auto& [face, value] : areas(mesh)) {
                EXPECT_NEAR(value, area.at(face), 1e-9);
            }
        }
    }
}

/// Queues identify triangles by index and stamp: an unchanged stamp must mean unchanged corners, and a triangle far
/// from an operation must keep its stamp.
TEST(ClassifiedMesh, StampsChangeWithTheCorners) {
    ClassifiedMesh mesh = samples::tube(5, 3);
    Shaker shaker(mesh, 7);
    for (int i = 0; i < 200; ++i) {
        std::vector<std::array<int, 3>> corners;
        std::vector<std::uint32_t> stamps;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            corners.push_back({mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)});
            stamps.push_back(mesh.stamp(t));
        }
        shaker.step();
        int restamped = 0;
        for (int t = 0; t < static_cast<int>(corners.size()); ++t) {
            if (mesh.stamp(t) != stamps[t]) {
                ++restamped;
                continue;
            }
            const std::array<int, 3> now{mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
            ASSERT_EQ(now, corners[t]);
        }
        EXPECT_LE(restamped, 2);
    }
}

/// Measurements are stored by an edge's number: it must always mean the same two vertices on one face.
TEST(ClassifiedMesh, NumbersOfEdgesStayWithTheirVertices) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        ClassifiedMesh mesh = sample.mesh;
        Shaker shaker(mesh, 11);
        std::map<int, std::array<int, 3>> known;  // face and vertices, by number
        int kept = 0;
        for (int i = 0; i < 200; ++i) {
            std::map<int, int> seen;
            for (int h = 0; h < mesh.half_edge_count(); ++h) {
                const int a = mesh.vertex_of(h);
                const int b = mesh.vertex_of(ClassifiedMesh::next(h));
                const std::array<int, 3> ends{mesh.face_of(h / 3), std::min(a, b), std::max(a, b)};
                const int number = mesh.number_of(h);
                ASSERT_GE(number, 0);
                ASSERT_LT(number, mesh.number_count());
                const auto [found, fresh] = known.emplace(number, ends);
                ASSERT_EQ(found->second, ends);
                kept += fresh ? 0 : 1;
                ++seen[number];
                ASSERT_EQ(mesh.twin(h) < 0 || mesh.number_of(mesh.twin(h)) == number, true);
            }
            for (const auto& [number, sides] : seen) {
                ASSERT_LE(sides, 2);
            }
            shaker.step();
        }
        EXPECT_GT(kept, 0);
    }
}

TEST(ClassifiedMesh, NewNumbersOfEdgesHaveNoGaps) {
    for (const Sample& sample : all_samples()) {
        SCOPED_TRACE(sample.name);
        ClassifiedMesh mesh = sample.mesh;
        Shaker shaker(mesh, 12);
        for (int i = 0; i < 100; ++i) {
            shaker.step();
        }
        std::vector<int> values(static_cast<std::size_t>(mesh.number_count()));
        std::vector<int> old;
        for (int h = 0; h < mesh.half_edge_count(); ++h) {
            old.push_back(mesh.number_of(h));
            values[static_cast<std::size_t>(old.back())] = 100 + old.back();
        }
        const std::int64_t made = mesh.edges_made();
        ASSERT_GT(made, mesh.edge_count());
        const mq::LargeVector<int> renewed = mesh.renumber_edges();
        mq::triangulate::move_to_numbers(renewed, values);
        EXPECT_EQ(mesh.number_count(), mesh.edge_count());
        EXPECT_EQ(mesh.edges_made(), made);
        EXPECT_EQ(values.size(), static_cast<std::size_t>(mesh.edge_count()));
        EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
        for (int h = 0; h < mesh.half_edge_count(); ++h) {
            const auto before = static_cast<std::size_t>(old[static_cast<std::size_t>(h)]);
            ASSERT_EQ(mesh.number_of(h), renewed[before]);
            ASSERT_EQ(values[static_cast<std::size_t>(mesh.number_of(h))], 100 + static_cast<int>(before));
        }
        EXPECT_EQ(mesh.inconsistency(), "");
    }
}

/// A triangle that reuses an index must not be mistaken for the earlier one.
TEST(ClassifiedMesh, StampsGoOnWherePlacesAreTakenAgain) {
    ClassifiedMesh mesh = samples::sheet(3, 2);
    const int last = mesh.triangle_count();
    const int site = mesh.add_site({mesh.add_vertex(Vec3(0.4, 0.2, 0), {2, 0})});
    const std::array<int, 3> corners{mesh.site_of(0), mesh.site_of(1), mesh.site_of(2)};
    const std::array<int, 3> made = mesh.split_triangle(0, site);
    ASSERT_EQ(made[2], last + 1);
    const std::uint32_t before = mesh.stamp(last);
    mesh.replace({made[0], made[1], made[2]}, {corners});
    mesh.compact();
    ASSERT_EQ(mesh.triangle_count(), last);
    mesh.split_triangle(0, site);
    EXPECT_GT(mesh.stamp(last), before);
    EXPECT_EQ(mesh.inconsistency(), "");
}

/// Where a side of the parameter domain is a point in space, an inner edge may end at two sites of one vertex.
TEST(ClassifiedMesh, ReplacesBothSidesOfAnEdgeWithTwoSitesAtAnEnd) {
    ClassifiedMesh mesh;
    std::array<int, 4> vertices{};
    std::array<int, 4> sites{};
    for (int i = 0; i < 4; ++i) {
        vertices[i] = mesh.add_vertex(Vec3(i % 2, i / 2, 0), {1, i});
        sites[i] = mesh.add_site({vertices[i]});
    }
    const int other = mesh.add_site({vertices[2]});
    const std::vector<std::array<int, 3>> corners{{sites[0], sites[1], sites[2]}, {sites[1], sites[3], other}};
    for (const auto& c : corners) {
        mesh.add_triangle(c, 0);
    }
    mesh.link(1, 5);
    for (const int h : {0, 2, 3, 4}) {
        const int s = mesh.add_segment(h, {mesh.vertex_of(h), mesh.vertex_of(ClassifiedMesh::next(h))}, {0.0, 1.0});
        mesh.bind(h, s, h);
    }
    ASSERT_EQ(mesh.inconsistency(), "");
    mesh.replace({0, 1}, {corners[1], corners[0]});
    EXPECT_EQ(mesh.inconsistency(), "");
    EXPECT_EQ(mesh.twin(2), 4);
}

TEST(ClassifiedMesh, InconsistencyNamesLooseAndWrongHalfEdges) {
    ClassifiedMesh mesh;
    std::array<int, 4> sites{};
    for (int i = 0; i < 4; ++i) {
        sites[i] = mesh.add_site({mesh.add_vertex(Vec3(i % 2, i / 2, 0), {2, 0})});
    }
    mesh.add_triangle({sites[0], sites[1], sites[2]}, 0);
    EXPECT_NE(mesh.inconsistency().find("half-edge 0"), std::string::npos);
    mesh.add_triangle({sites[1], sites[3], sites[2]}, 0);
    mesh.link(1, 5);
    for (const int h : {0, 2, 3, 4}) {
        const int s = mesh.add_segment(h, {mesh.vertex_of(h), mesh.vertex_of(ClassifiedMesh::next(h))}, {0.0, 1.0});
        mesh.bind(h, s, h);
    }
    EXPECT_EQ(mesh.inconsistency(), "");
    mesh.link(0, 3);
    EXPECT_NE(mesh.inconsistency(), "");
}

}  // namespace
}  // namespace mq::triangulate

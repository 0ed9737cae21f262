// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operand_repair.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "base/cases.h"
#include "base/error.h"
#include "boolean/random_meshes.h"
#include "mesh/corner_table.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/mesh_report.h"

namespace mq::boolean {
namespace {

using fuzz::cube;
using fuzz::sphere;
using mesh::TriangleMesh;

TriangleMesh as_mesh(const Operand& operand) {
    TriangleMesh mesh;
    mesh.vertices = operand.vertices;
    mesh.triangles = operand.triangles;
    return mesh;
}

double volume(const Operand& operand) {
    return fuzz::signed_volume(operand.vertices, operand.triangles);
}

std::int32_t component_count(const Operand& operand) {
    return mesh::components(mesh::edge_twins(operand.triangles, operand.vertices.size())).count;
}

/// Checks what the header promises of every operand, by the mesh report and by comparison with the input.
void expect_fit(const Operand& operand, const TriangleMesh& input) {
    const mesh::MeshReport report = mesh::measure(as_mesh(operand));
    EXPECT_TRUE(report.closed);
    EXPECT_TRUE(report.oriented);
    EXPECT_TRUE(report.manifold) << report.nonmanifold_edges << " edges, " << report.pinched_vertices << " vertices, "
                                 << report.degenerate_triangles << " degenerate";
    ASSERT_EQ(operand.source.size(), operand.triangles.size());
    for (std::size_t t = 0; t < operand.triangles.size(); ++t) {
        if (operand.source[t] < 0) {
            continue;
        }
        // All corners are the source's, unless the triangle was divided: then they lie in its plane all the same.
        const mesh::Triangle& now = operand.triangles[t];
        const mesh::Triangle& then = input.triangles[operand.source[t]];
        const Vec3& a = input.vertices[then[0]];
        const Vec3 normal = (input.vertices[then[1]] - a).cross(input.vertices[then[2]] - a);
        for (const std::int32_t v : now) {
            EXPECT_NEAR((operand.vertices[v] - a).dot(normal), 0.0, 1e-6 * normal.norm());
        }
    }
}

Operand prepared(const TriangleMesh& mesh) {
    Operand operand = prepare_operand(mesh, "operand A");
    expect_fit(operand, mesh);
    return operand;
}

void append(TriangleMesh& mesh, const TriangleMesh& other, bool inside_out = false) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const mesh::Triangle& t : other.triangles) {
        const mesh::Triangle moved{t[0] + first, t[1] + first, t[2] + first};
        mesh.triangles.push_back(inside_out ? mesh::Triangle{moved[0], moved[2], moved[1]} : moved);
    }
}

TriangleMesh scaled(TriangleMesh mesh, double scale, const Vec3& shift = Vec3(0, 0, 0)) {
    for (Vec3& v : mesh.vertices) {
        v = scale * v + shift;
    }
    return mesh;
}

std::string message_of(const TriangleMesh& mesh) {
    try {
        prepare_operand(mesh, "operand B");
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

void expect_refused(const TriangleMesh& mesh, const std::string& why) {
    const std::string message = message_of(mesh);
    EXPECT_NE(message.find("operand B"), std::string::npos) << message;
    EXPECT_NE(message.find(why), std::string::npos) << message;
}

TEST(Operand, ACleanMeshIsKeptAsItIs) {
    for (const TriangleMesh& mesh : {cube(2), sphere(3), fuzz::torus(20, 10, 0.4)}) {
        const Operand operand = prepared(mesh);
        EXPECT_FALSE(operand.repairs.any());
        EXPECT_EQ(operand.repairs.summary().text(), "none");
        EXPECT_EQ(operand.triangles, mesh.triangles);
        EXPECT_EQ(operand.vertices, mesh.vertices);
        for (std::size_t t = 0; t < operand.source.size(); ++t) {
            EXPECT_EQ(operand.source[t], static_cast<std::int32_t>(t));
        }
    }
}

TEST(Operand, WeldsEqualVertices) {
    TriangleMesh mesh = sphere(2);
    fuzz::Random random(1);
    fuzz::damage(mesh, fuzz::Defect::Unwelded, random);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(operand.repairs.welded, 3 * 128u - 66u);
    EXPECT_EQ(operand.repairs.summary().text(), "318 vertices welded");
}

TEST(Operand, ClosesHoles) {
    TriangleMesh mesh = sphere(3);
    const double whole = fuzz::signed_volume(mesh.vertices, mesh.triangles);
    mesh.triangles.erase(mesh.triangles.begin() + 10);
    mesh.triangles.erase(mesh.triangles.begin() + 199, mesh.triangles.begin() + 203);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.holes, 2u);
    EXPECT_EQ(operand.repairs.hole_triangles, 5u);
    EXPECT_NEAR(volume(operand), whole, 2e-3 * whole);
    EXPECT_EQ(operand.repairs.summary().text(), "2 holes closed (5 triangles)");
}

TEST(Operand, ABoxWithoutItsLidIsClosed) {
    TriangleMesh mesh = cube(2);
    mesh.triangles.erase(mesh.triangles.begin() + 2 * 16, mesh.triangles.begin() + 4 * 16);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.holes, 1u);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
}

TEST(Operand, HolesThatMeetInAVertexAreClosedBoth) {
    // Two opposite quadrants of the triangles around one vertex are missing.
    TriangleMesh mesh = cube(2);
    std::vector<mesh::Triangle> kept;
    int quadrant = 0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3 m = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0 - Vec3(0.5, 0.5, 1.0);
        const bool near = std::abs(m.z()) < 1e-9 && std::abs(m.x()) < 0.25 && std::abs(m.y()) < 0.25;
        if (near && m.x() * m.y() > 0) {
            ++quadrant;
        } else {
            kept.push_back(t);
        }
    }
    ASSERT_GT(quadrant, 1);
    mesh.triangles = kept;
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.holes, 2u);
    EXPECT_EQ(operand.repairs.nonmanifold_vertices, 0u);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
}

TEST(Operand, PrefersAFillingThatCrossesNothing) {
    // A box with a saddle for its rim: two roofs are possible, and a small solid pierces the one or the other.
    for (const bool high : {false, true}) {
        TriangleMesh mesh = cube();
        mesh.vertices[5].z() = 2.0;
        mesh.vertices[6].z() = 2.0;
        mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
        append(mesh, scaled(sphere(0), 0.05, Vec3(0.5, 0.5, high ? 2.0 : 1.0)));
        const Operand operand = prepared(mesh);
        EXPECT_EQ(operand.repairs.holes, 1u);
        EXPECT_TRUE(mesh::self_intersections(operand.vertices, operand.triangles).empty());
        EXPECT_EQ(volume(operand) > 1.5, !high);
    }
}

TEST(Operand, TurnsFlippedTrianglesAndSolids) {
    TriangleMesh mesh = sphere(2);
    std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
    std::swap(mesh.triangles[77][1], mesh.triangles[77][2]);
    EXPECT_EQ(prepared(mesh).repairs.flipped, 2u);
    TriangleMesh inside_out;
    append(inside_out, sphere(2), true);
    const Operand operand = prepared(inside_out);
    EXPECT_EQ(operand.repairs.flipped, 128u);
    EXPECT_GT(volume(operand), 0.0);
}

TEST(Operand, KeepsCavitiesAndNestedSolids) {
    const double solid = fuzz::signed_volume(sphere(2).vertices, sphere(2).triangles);
    const auto nested = [&](bool outer_turned, bool inner_turned, bool core_turned) {
        TriangleMesh mesh;
        append(mesh, scaled(sphere(2), 0.25, Vec3(0.1, 0, 0)), core_turned);
        append(mesh, sphere(2), outer_turned);
        append(mesh, scaled(sphere(2), 0.5), inner_turned);
        return volume(prepared(mesh)) / solid;
    };
    EXPECT_NEAR(nested(false, true, false), 1.0 - 0.125 + 0.015625, 1e-12);   // a shell with a core
    EXPECT_NEAR(nested(false, true, true), 1.0 - 0.125 + 0.015625, 1e-12);    // its core inside out
    EXPECT_NEAR(nested(true, false, true), 1.0 - 0.125 + 0.015625, 1e-12);    // all inside out
    EXPECT_NEAR(nested(false, false, false), 1.0 + 0.125 + 0.015625, 1e-12);  // solids in solids stay solids
    EXPECT_NEAR(nested(false, false, true), 1.0 + 0.125 - 0.015625, 1e-12);   // a cavity in the inner one
}

TEST(Operand, ASolidBesideAnotherIsNoCavity) {
    TriangleMesh mesh = sphere(2);
    append(mesh, scaled(sphere(2), 0.5, Vec3(3, 0, 0)), true);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.flipped, 128u);
}

TEST(Operand, DropsDuplicates) {
    TriangleMesh mesh = sphere(2);
    mesh.triangles.push_back(mesh.triangles[3]);
    mesh.triangles.push_back({mesh.triangles[9][1], mesh.triangles[9][2], mesh.triangles[9][0]});
    Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.duplicate, 2u);
    EXPECT_EQ(operand.triangles.size(), 128u);
    // Opposite ones: the one that fits the surface stays.
    mesh = sphere(2);
    mesh.triangles.insert(mesh.triangles.begin(), {mesh.triangles[9][0], mesh.triangles[9][2], mesh.triangles[9][1]});
    operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.duplicate, 1u);
    EXPECT_EQ(operand.repairs.holes, 0u);
    EXPECT_EQ(operand.source[0], 1);
    // A flap of no thickness on the surface is gone, a closed one beside it too.
    mesh = sphere(2);
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 1});
    operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.duplicate, 2u);
    EXPECT_EQ(operand.triangles.size(), 128u);
}

TEST(Operand, TwoSolidsWithACommonFaceBecomeOne) {
    TriangleMesh mesh = cube();
    append(mesh, scaled(cube(), 1.0, Vec3(1, 0, 0)));
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.duplicate, 4u);
    EXPECT_EQ(component_count(operand), 1);
    EXPECT_NEAR(volume(operand), 2.0, 1e-12);
}

TEST(Operand, TakesOutDegenerateTriangles) {
    TriangleMesh mesh = cube(1);
    for (const std::size_t k : {0u, 5u, 11u, 30u}) {
        fuzz::add_degenerate(mesh, k);
    }
    mesh.triangles.push_back({3, 3, 4});
    ASSERT_EQ(mesh.triangles.size(), 48u + 9u);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.degenerate, 5u);
    EXPECT_EQ(operand.repairs.holes, 0u);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
}

TEST(Operand, ClosesCracksAtVerticesOnEdges) {
    // As before, but the triangle of no area is missing: a hole whose border runs to and fro on one line.
    TriangleMesh mesh = cube(1);
    fuzz::add_degenerate(mesh, 7);
    mesh.triangles.pop_back();
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.holes, 1u);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
}

TEST(Operand, PartsSolidsThatShareAnEdgeOrAVertex) {
    TriangleMesh edge = cube();
    append(edge, scaled(cube(), 1.0, Vec3(1, 1, 0)));
    Operand operand = prepared(edge);
    EXPECT_EQ(operand.repairs.nonmanifold_edges, 1u);
    EXPECT_EQ(component_count(operand), 2);
    EXPECT_NEAR(volume(operand), 2.0, 1e-12);
    TriangleMesh vertex = cube();
    append(vertex, scaled(cube(), 1.0, Vec3(1, 1, 1)));
    operand = prepared(vertex);
    EXPECT_EQ(operand.repairs.nonmanifold_vertices, 1u);
    EXPECT_EQ(component_count(operand), 2);
    EXPECT_EQ(operand.vertices.size(), 17u);
}

TEST(Operand, PartsAnEdgeWhoseEndsAreOnePiece) {
    // Two cubes of a 2 x 2 x 3 grid touch in an edge, and others join them above and below: a ring around a slit edge.
    TriangleMesh mesh;
    for (int x = 0; x < 2; ++x) {
        for (int y = 0; y < 2; ++y) {
            for (int z = 0; z < 3; ++z) {
                if (z != 1 || x == y) {
                    append(mesh, scaled(cube(), 1.0, Vec3(x, y, z)));
                }
            }
        }
    }
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.nonmanifold_edges, 1u);
    EXPECT_EQ(operand.repairs.nonmanifold_vertices, 0u);
    EXPECT_NEAR(volume(operand), 10.0, 1e-12);
}

TEST(Operand, InnerWallsAndFinsAreLeftOut) {
    TriangleMesh mesh = cube();
    mesh.triangles.push_back({0, 3, 7});  // a wall from edge to edge
    mesh.triangles.push_back({0, 7, 4});
    const auto tip = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(-0.2, 0.1, 0.1);
    mesh.triangles.push_back({0, 2, tip});
    const Operand operand = prepared(mesh);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
    EXPECT_EQ(operand.repairs.scraps, 3u);
    EXPECT_EQ(operand.repairs.nonmanifold_edges, 5u);
    EXPECT_EQ(component_count(operand), 1);
}

TEST(Operand, ASurfaceDrawnFromBothSidesIsTakenOnce) {
    TriangleMesh mesh = sphere(2);
    append(mesh, sphere(2), true);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.triangles.size(), 128u);
    EXPECT_EQ(operand.repairs.duplicate, 128u);
    EXPECT_NEAR(volume(operand), volume(prepared(sphere(2))), 1e-12);
}

/// The cube's faces, each drawn in towards its middle by a share of its size, with vertices of their own.
TriangleMesh parted_cube(double gap) {
    TriangleMesh mesh;
    const TriangleMesh whole = cube();
    for (std::size_t t = 0; t < whole.triangles.size(); t += 2) {
        Vec3 middle = Vec3::Zero();
        std::map<std::int32_t, std::int32_t> own;
        for (const std::size_t k : {t, t + 1}) {
            for (const std::int32_t v : whole.triangles[k]) {
                if (own.emplace(v, static_cast<std::int32_t>(mesh.vertices.size() + own.size())).second) {
                    middle += 0.25 * whole.vertices[v];
                }
            }
        }
        std::vector<Vec3> places(own.size());
        for (const auto& [v, place] : own) {
            places[place - mesh.vertices.size()] = whole.vertices[v] + gap * (middle - whole.vertices[v]);
        }
        mesh.vertices.insert(mesh.vertices.end(), places.begin(), places.end());
        for (const std::size_t k : {t, t + 1}) {
            const mesh::Triangle& c = whole.triangles[k];
            mesh.triangles.push_back({own.at(c[0]), own.at(c[1]), own.at(c[2])});
        }
    }
    return mesh;
}

TEST(Operand, ClosesCracksWithinReach) {
    const TriangleMesh mesh = parted_cube(0.01);
    EXPECT_EQ(mesh.vertices.size(), 24u);
    expect_refused(mesh, "open surface");
    const Operand operand = prepare_operand(mesh, "operand A", 0.02);
    EXPECT_EQ(operand.triangles.size(), 12u);
    EXPECT_EQ(operand.repairs.cracks, 16u);
    EXPECT_EQ(operand.repairs.holes, 0u);
    EXPECT_NEAR(volume(operand), 1.0, 0.03);
    EXPECT_GT(operand.largest_move, 0.005);
    EXPECT_LE(operand.largest_move, 0.02);
}

TEST(Operand, ClosesCracksAtVerticesOnTheOtherSidesEdges) {
    // One face of the cube is four triangles around its middle, and its edges are divided at their middles, bent
    // inward.
    TriangleMesh mesh = cube();
    const mesh::Triangle one = mesh.triangles[0];
    const mesh::Triangle two = mesh.triangles[1];
    std::vector<std::int32_t> corners(one.begin(), one.end());
    for (const std::int32_t v : two) {
        if (std::find(one.begin(), one.end(), v) == one.end()) {
            for (std::size_t i = 0; i < 3; ++i) {  // between the ends of the common edge
                const bool common = std::count(two.begin(), two.end(), one[i]) == 1 &&
                                    std::count(two.begin(), two.end(), one[(i + 1) % 3]) == 1;
                if (common) {
                    corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, v);
                    break;
                }
            }
        }
    }
    ASSERT_EQ(corners.size(), 4u);
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
    const Vec3 middle = 0.5 * (mesh.vertices[corners[0]] + mesh.vertices[corners[2]]);
    const auto center = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 half = 0.5 * (mesh.vertices[corners[i]] + mesh.vertices[corners[(i + 1) % 4]]);
        mesh.vertices.emplace_back(half + 0.01 * (middle - half));
    }
    for (std::int32_t i = 0; i < 4; ++i) {
        mesh.triangles.push_back({corners[i], center + 1 + i, center});
        mesh.triangles.push_back({center + 1 + i, corners[(i + 1) % 4], center});
    }
    const Operand operand = prepare_operand(mesh, "operand A", 0.02);
    EXPECT_EQ(operand.repairs.cracks, 4u);
    EXPECT_EQ(operand.repairs.holes, 0u);
    EXPECT_EQ(operand.triangles.size(), 10u + 8u + 4u);
    EXPECT_NEAR(volume(operand), 1.0, 0.02);
}

TEST(Operand, SolidsInOneAnotherThatAreOpenAtOnePlaceAreNotJoinedThere) {
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
    append(mesh, scaled(mesh, 1.0002, Vec3(-1e-4, -1e-4, -1e-4)));
    const Operand operand = prepare_operand(mesh, "operand A", 1e-3);
    EXPECT_EQ(operand.repairs.cracks, 0u);
    EXPECT_EQ(operand.repairs.holes, 2u);
    EXPECT_NEAR(volume(operand), 2.0, 2e-3);
}

TEST(Operand, ASheetDrawnFromBothSidesBesideASolidCancels) {
    TriangleMesh mesh = cube();
    TriangleMesh sheet;
    sheet.vertices = {{2, 0, 0}, {8, 0, 0}, {8, 6, 0}, {2, 6, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    append(mesh, sheet);
    append(mesh, sheet, true);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.duplicate, 4u);
    EXPECT_NEAR(volume(operand), 1.0, 1e-12);
}

TEST(Operand, SheetsBesideASolidAreLeftOut) {
    TriangleMesh mesh = sphere(3);
    TriangleMesh sheet;
    sheet.vertices = {{2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}};  // a third of the sphere's area
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    append(mesh, sheet);
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.scraps, 2u);
    EXPECT_NEAR(volume(operand), volume(prepared(sphere(3))), 1e-12);
    // A sheet that is most of the operand may be what was meant.
    append(mesh, scaled(sheet, 3.0));
    expect_refused(mesh, "open surface");
}

/// The disc that would close it has half of its area: too much to be added, and too little for a sheet.
TriangleMesh half_sphere() {
    TriangleMesh half = sphere(3);
    std::vector<mesh::Triangle> upper;
    for (const mesh::Triangle& t : half.triangles) {
        if ((half.vertices[t[0]] + half.vertices[t[1]] + half.vertices[t[2]]).z() > 0) {
            upper.push_back(t);
        }
    }
    half.triangles = upper;
    return half;
}

TEST(Operand, SmallScrapsBesideASolidAreLeftOut) {
    TriangleMesh mesh = sphere(3);
    append(mesh, scaled(half_sphere(), 0.28, Vec3(3, 0, 0)));  // a twenty-sixth of the area
    const Operand operand = prepared(mesh);
    EXPECT_EQ(operand.repairs.scraps, half_sphere().triangles.size());
    EXPECT_EQ(operand.triangles, sphere(3).triangles);
    mesh = sphere(3);
    append(mesh, scaled(half_sphere(), 0.4, Vec3(3, 0, 0)));  // a thirteenth
    expect_refused(mesh, "open surface");
}

TEST(Operand, RefusesWhatEnclosesNothing) {
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.origin = Vec3(100, 0, 0);
    expect_refused(sheet, "open surface");
    expect_refused(sheet, "(102, 2, 0) mm");
    expect_refused(half_sphere(), "open surface");
    TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    expect_refused(flat, "no triangle");
    expect_refused(TriangleMesh{}, "no triangles");
}

TEST(Operand, RefusesAOneSidedSurface) {
    TriangleMesh strip;
    // Vertices of a circle.
    constexpr int kCircleVertices = 12;
    for (int i = 0; i < kCircleVertices; ++i) {
        const double u = 2 * M_PI * i / kCircleVertices;
        const Vec3 middle(std::cos(u), std::sin(u), 0);
        const Vec3 arm = std::cos(u / 2) * middle + std::sin(u / 2) * Vec3(0, 0, 1);
        strip.vertices.push_back(middle - 0.3 * arm);
        strip.vertices.push_back(middle + 0.3 * arm);
    }
    for (int i = 0; i < kCircleVertices; ++i) {
        const bool last = i == kCircleVertices - 1;
        const std::int32_t a = 2 * i;
        const std::int32_t b = 2 * i + 1;
        const std::int32_t c = last ? 1 : 2 * i + 2;
        const std::int32_t d = last ? 0 : 2 * i + 3;
        strip.triangles.push_back({a, c, b});
        strip.triangles.push_back({b, c, d});
    }
    expect_refused(strip, "one side only");
}

TEST(Operand, RefusesNumbersThatAreNone) {
    TriangleMesh mesh = cube();
    mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
    expect_refused(mesh, "vertex 5");
    mesh.vertices[5].y() = -1.1e15;
    expect_refused(mesh, "vertex 5 has a coordinate beyond 1e+15 mm");
    mesh = cube();
    mesh.triangles[2][1] = 8;
    expect_refused(mesh, "triangle 2 names vertex 8");
}

TEST(Operand, IsCancelled) {
    TriangleMesh mesh = sphere(3);
    mesh.triangles.pop_back();
    Progress progress;
    progress.cancel();
    EXPECT_THROW(prepare_operand(mesh, "operand A", 0.0, &progress), Cancelled);
}

TEST(Operand, RandomDefectsAreRepaired) {
    int refused = 0;
    const int cases = scaled_cases(1000);
    for (int i = 0; i <= cases; ++i) {
        const int seed = i == 0 ? 34913 : i;  // a triangle without area that faces another one
        fuzz::Random random(seed);
        TriangleMesh mesh = fuzz::closed_mesh(random);
        const double whole = fuzz::signed_volume(mesh.vertices, mesh.triangles);
        std::string what = "seed " + std::to_string(seed);
        bool overlap = false;
        for (int k = random.integer(1, 4); k > 0; --k) {
            const auto defect = static_cast<fuzz::Defect>(random.integer(0, int(fuzz::Defect::kCount) - 1));
            fuzz::damage(mesh, defect, random);
            overlap = overlap || defect == fuzz::Defect::Overlap;
            what += std::string(", ") + fuzz::name_of(defect);
        }
        SCOPED_TRACE(what);
        try {
            const Operand operand = prepare_operand(mesh, "operand A");
            expect_fit(operand, mesh);
            if (!overlap) {
                EXPECT_NEAR(volume(operand), whole, 0.3 * whole) << operand.repairs.summary().text();
            }
        } catch (const InvalidInput& error) {
            ++refused;
            EXPECT_LT(mesh.triangles.size(), 60u) << error.what();
        }
        if (testing::Test::HasFailure()) {
            break;
        }
    }
    EXPECT_LT(refused, cases / 20);
}

}  // namespace
}  // namespace mq::boolean

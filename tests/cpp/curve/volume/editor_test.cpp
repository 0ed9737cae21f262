// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/editor.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

/// Tries an operation at every tetrahedron; after any change the mesh still fills the same space.
template <typename Operation>
int changes_everywhere(Filled& filled, Operation&& operation) {
    int count = 0;
    const double before = filled.volume_sum();
    const std::size_t elements = filled.volume.tetrahedra.size();
    for (std::size_t t = 0; t < elements; ++t) {
        if (filled.volume.tetrahedra[t].alive && operation(static_cast<int>(t))) {
            ++count;
            EXPECT_NEAR(filled.volume_sum(), before, 1e-9 * before);
            EXPECT_GT(filled.least_straight(), 0.0);
        }
    }
    return count;
}

TEST(RegionOperations, SwapsFillTheSameSpace) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    const int edges = changes_everywhere(filled, [&](int t) {
        const auto v = filled.volume.tetrahedra[static_cast<std::size_t>(t)].corners;
        return swap_region_edge(filled.editor, v[0], v[1], VolumeEditor::Rule::Improve) ||
               swap_region_edge(filled.editor, v[2], v[3], VolumeEditor::Rule::Improve);
    });
    const int faces = changes_everywhere(filled, [&](int t) {
        const auto v = filled.volume.tetrahedra[static_cast<std::size_t>(t)].corners;
        return swap_region_face(filled.editor, v[0], v[1], v[2], VolumeEditor::Rule::Improve);
    });
    EXPECT_GT(edges + faces, 0);
}

TEST(RegionOperations, CollapsesFillTheSameSpace) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), 2);
    // A vertex inserted in an element makes a worse mesh; collapsing it into a neighbour restores it.
    const auto& corners = filled.volume.tetrahedra[0].corners;
    Vec3 near = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
        near += (k == 0 ? 0.34 : k == 1 ? 0.65 : 0.005) * filled.volume.point(corners[k]);
    }
    const std::array<int, 4> v = corners;
    const int p = filled.volume.add_vertex(near, 0);
    filled.volume.remove(0);
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<int, 4> part = v;
        part[k] = p;
        filled.volume.add(part, 0);
    }
    const double before = filled.volume_sum();
    EXPECT_TRUE(collapse_region_edge(filled.editor, p, v[0]));
    EXPECT_NEAR(filled.volume_sum(), before, 1e-9);
    EXPECT_TRUE(filled.volume.of_vertex(p).empty());
    EXPECT_FALSE(collapse_region_edge(filled.editor, v[0], v[1])) << "vertices of the part stay";
}

TEST(RegionOperations, SplitsFillTheSameSpace) {
    Filled filled(thin_wall(0.1, 0.5 * M_PI), 2);
    const int splits = changes_everywhere(filled, [&](int t) {
        const auto v = filled.volume.tetrahedra[static_cast<std::size_t>(t)].corners;
        return split_region_edge(filled.editor, v[0], v[1], VolumeEditor::Rule::Improve) ||
               split_region_face(filled.editor, v[0], v[1], v[2], VolumeEditor::Rule::Improve) ||
               split_region(filled.editor, t, VolumeEditor::Rule::Improve);
    });
    EXPECT_GT(splits, 0);
}

/// A face inside the volume, in the order of its first tetrahedron.
std::array<int, 3> inner_face(const TetrahedralMesh& volume) {
    for (const Tetrahedron& t : volume.tetrahedra) {
        for (std::size_t k = 0; k < 4; ++k) {
            const std::array<int, 3> face{t.corners[(k + 1) % 4], t.corners[(k + 2) % 4], t.corners[(k + 3) % 4]};
            if (!volume.fixed_face(face[0], face[1], face[2])) {
                return face;
            }
        }
    }
    ADD_FAILURE() << "no face inside";
    return {};
}

double worst_at(const TetrahedralMesh& volume, const std::array<int, 3>& face) {
    double least = 1.0;
    for (const int t : volume.of_face(face[0], face[1], face[2])) {
        least = std::min(least, volume.tetrahedra[static_cast<std::size_t>(t)].quality);
    }
    return least;
}

TEST(RegionOperations, RelocatedFaceNodesRaiseTheWorstElement) {
    for (const int order : {3, 4}) {
        Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), order);
        TetrahedralMesh& volume = filled.volume;
        const std::array<int, 3> face = inner_face(volume);
        const auto& [a, b, c] = face;
        const Vec3 across = (volume.point(b) - volume.point(a)).cross(volume.point(c) - volume.point(a)).normalized();
        const Vec3 off = volume.point(a) + 10.0 * across;
        volume.shapes().set_face(face, std::vector<Vec3>(order == 3 ? 1 : 3, off));
        volume.measure(volume.of_face(a, b, c));
        ASSERT_FALSE(worst_at(volume, face) > 0.0);
        EXPECT_TRUE(relocate_face_nodes(filled.editor, a, b, c));
        EXPECT_GT(worst_at(volume, face), 0.9);
        EXPECT_FALSE(relocate_face_nodes(filled.editor, a, b, c)) << "nothing is left to gain";
    }
}

TEST(RegionOperations, FaceNodesGiveWayToACurvedEdge) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), 3);
    TetrahedralMesh& volume = filled.volume;
    const std::array<int, 3> face = inner_face(volume);
    const auto& [a, b, c] = face;
    const Vec3 bulge = 0.4 * (volume.point(c) - 0.5 * (volume.point(a) + volume.point(b)));
    volume.shapes().set_edge(a, b, {volume.point(a) + bulge, volume.point(b) + bulge});
    volume.measure(volume.of_edge(a, b));
    const double before = worst_at(volume, face);
    const double all_before =
        volume.measure(volume.tetrahedra[static_cast<std::size_t>(volume.of_face(a, b, c)[0])].corners);
    ASSERT_LT(before, 0.9);
    EXPECT_TRUE(relocate_face_nodes(filled.editor, a, b, c));
    EXPECT_GT(worst_at(volume, face), before + 1e-3);
    EXPECT_GE(volume.measure(volume.tetrahedra[static_cast<std::size_t>(volume.of_face(a, b, c)[0])].corners),
              std::min(all_before, before));
}

TEST(RegionOperations, TheAverageOfTheCentroids) {
    elements::CurvedShapes shapes(3);
    shapes.vertices = {{Vec3(0.0, 0.0, 0.0), {3, 0}}, {Vec3(1.0, 0.0, 0.0), {3, 0}}, {Vec3(0.0, 1.0, 0.0), {3, 0}}};
    const std::array<int, 3> face{0, 1, 2};
    EXPECT_LT((average_of_centroids(shapes, face)[0] - Vec3(1.0 / 3.0, 1.0 / 3.0, 0.0)).norm(), 1e-12);
    shapes.set_edge(0, 1, {Vec3(0.3, 0.5, 0.7), Vec3(0.9, 0.4, 0.2)});
    const elements::Lattice& lattice = elements::Lattice::of(2, 3);
    shapes.set_face(face, average_of_centroids(shapes, face));
    std::vector<Vec3> control;
    shapes.triangle(face, control);
    const std::vector<Vec3> nodes = elements::bezier_to_nodes(lattice, control);
    Vec3 average = Vec3::Zero();
    for (int i = 0; i < lattice.size(); ++i) {
        average += (lattice.carriers(i) == 3 ? 0.0 : 1.0 / 9.0) * nodes[static_cast<std::size_t>(i)];
    }
    EXPECT_LT((nodes[static_cast<std::size_t>(lattice.index({1, 1, 1, 0}))] - average).norm(), 1e-12);
}

TEST(RegionOperations, TheAverageOfTheCentroidsKeepsStraightFacesStraight) {
    for (const int order : {3, 4}) {
        elements::CurvedShapes shapes(order);
        shapes.vertices = {{Vec3(0.0, 0.1, 0.0), {3, 0}}, {Vec3(1.0, 0.0, 0.5), {3, 0}}, {Vec3(0.0, 1.0, 0.2), {3, 0}}};
        const std::array<int, 3> face{0, 1, 2};
        std::vector<Vec3> blended;
        std::vector<Vec3> averaged;
        shapes.triangle(face, blended);
        shapes.set_face(face, average_of_centroids(shapes, face));
        shapes.triangle(face, averaged);
        for (std::size_t i = 0; i < blended.size(); ++i) {
            EXPECT_LT((blended[i] - averaged[i]).norm(), 1e-12) << order;
        }
    }
}

TEST(RegionOperations, LeaveTheSurfaceAlone) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    const auto& t = filled.surface.triangles.front().corners;
    EXPECT_FALSE(swap_region_edge(filled.editor, t[0], t[1], VolumeEditor::Rule::Free));
    EXPECT_FALSE(swap_region_face(filled.editor, t[0], t[1], t[2], VolumeEditor::Rule::Free));
    EXPECT_FALSE(relocate_face_nodes(filled.editor, t[0], t[1], t[2]));
    EXPECT_FALSE(split_region_edge(filled.editor, t[0], t[1], VolumeEditor::Rule::Free));
    EXPECT_FALSE(split_region_face(filled.editor, t[0], t[1], t[2], VolumeEditor::Rule::Free));
}

}  // namespace
}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp_Ax1.hxx>
#include <numeric>

#include "curve/checks.h"
#include "curve/straighten.h"
#include "curve/surface_repair.h"
#include "curve/volume_editor.h"
#include "curve/volume_repair.h"
#include "geometry/occt/shape_model.h"
#include "geometry/parts.h"

namespace mq::curve {
namespace {

/// A part of a thin tube: radii 1 - thickness and 1, height 1, about z.
std::shared_ptr<geometry::Model> thin_wall(double thickness, double angle) {
    BRepBuilderAPI_MakePolygon profile;
    for (const auto& [r, z] : {std::pair{1.0 - thickness, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {1.0 - thickness, 1.0}}) {
        profile.Add(gp_Pnt(r, 0.0, z));
    }
    profile.Close();
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(profile.Wire(), Standard_True).Shape();
    return geometry::make_shape_model(BRepPrimAPI_MakeRevol(face, gp_Ax1(gp::Origin(), gp::DZ()), angle).Shape());
}

TEST(RepairVolume, ThinWallsBecomeValid) {
    for (const double thickness : {0.1, 0.04}) {
        for (int order = 2; order <= 4; ++order) {
            const CurvedMesh mesh = curved(thin_wall(thickness, 0.5 * M_PI), of_order(order, true));
            EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << thickness << " " << order << "\n" << to_text(mesh.report);
            EXPECT_EQ(mesh.report.invalid, 0u);
            EXPECT_GT(mesh.report.min_distortion, 0.1);
            const double inner = 1.0 - thickness;
            EXPECT_NEAR(mesh.report.volume, 0.25 * M_PI * (1.0 - inner * inner), 1e-3);
            expect_conforming(mesh);
        }
    }
}

TEST(RepairVolume, ThereIsSomethingToRepair) {
    EXPECT_GT(curved(thin_wall(0.04, 0.5 * M_PI), of_order(2, true)).report.invalid_before, 0u);
}

/// Everything up to the filling, so that single operations can be tried.
class Filled {
  public:
    Filled(const std::shared_ptr<geometry::Model>& model, int order)
        : session(engine, model),
          surface(classify(session, straight_mesh(engine, model), order)),
          surface_editor(session, surface),
          volume(filled()),
          editor(volume) {}

    double volume_sum() const {
        double sum = 0.0;
        for (const int t : volume.living()) {
            sum += volume.straight_jacobian(volume.tetrahedra[static_cast<std::size_t>(t)].corners) / 6.0;
        }
        return sum;
    }
    double least_straight() const {
        double least = 1e300;
        for (const int t : volume.living()) {
            least = std::min(least, volume.straight_jacobian(volume.tetrahedra[static_cast<std::size_t>(t)].corners));
        }
        return least;
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session;
    Surface surface;
    SurfaceEditor surface_editor;
    Progress progress;
    Volume volume;
    VolumeEditor editor;

  private:
    static mesh::TriangleMesh straight_mesh(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model) {
        triangulate::Options options;
        options.max_edge = 0.7;
        return triangulate::triangulate(engine, model, options).mesh;
    }
    Volume filled() {
        use_fill_program();
        std::vector<int> all(surface.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        surface_editor.placement.place(all);
        return fill_solids(surface, session.topology(), 1.0, progress);
    }
};

/// Tries an operation at every tetrahedron; whatever it changes, the mesh still fills the same space.
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
    // A vertex put into an element makes a worse mesh; drawing it into a neighbour mends that.
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
std::array<int, 3> inner_face(const Volume& volume) {
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

double worst_at(const Volume& volume, const std::array<int, 3>& face) {
    double least = 1.0;
    for (const int t : volume.of_face(face[0], face[1], face[2])) {
        least = std::min(least, volume.tetrahedra[static_cast<std::size_t>(t)].quality);
    }
    return least;
}

TEST(RegionOperations, RelocatedFaceNodesRaiseTheWorstElement) {
    for (const int order : {3, 4}) {
        Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), order);
        Volume& volume = filled.volume;
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
    Volume& volume = filled.volume;
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
    Shapes shapes(3);
    shapes.vertices = {{Vec3(0.0, 0.0, 0.0), {3, 0}}, {Vec3(1.0, 0.0, 0.0), {3, 0}}, {Vec3(0.0, 1.0, 0.0), {3, 0}}};
    const std::array<int, 3> face{0, 1, 2};
    EXPECT_LT((average_of_centroids(shapes, face)[0] - Vec3(1.0 / 3.0, 1.0 / 3.0, 0.0)).norm(), 1e-12);
    shapes.set_edge(0, 1, {Vec3(0.3, 0.5, 0.7), Vec3(0.9, 0.4, 0.2)});
    const Lattice& lattice = Lattice::of(2, 3);
    shapes.set_face(face, average_of_centroids(shapes, face));
    std::vector<Vec3> control;
    shapes.triangle(face, control);
    const std::vector<Vec3> nodes = bezier_to_nodes(lattice, control);
    Vec3 average = Vec3::Zero();
    for (int i = 0; i < lattice.size(); ++i) {
        average += (lattice.carriers(i) == 3 ? 0.0 : 1.0 / 9.0) * nodes[static_cast<std::size_t>(i)];
    }
    EXPECT_LT((nodes[static_cast<std::size_t>(lattice.index({1, 1, 1, 0}))] - average).norm(), 1e-12);
}

TEST(RegionOperations, TheAverageOfTheCentroidsKeepsStraightFacesStraight) {
    for (const int order : {3, 4}) {
        Shapes shapes(order);
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

std::vector<int> invalid_triangles(const Surface& surface) {
    std::vector<int> result;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.triangles[t].alive && !(surface.triangles[t].quality > 0.0)) {
            result.push_back(static_cast<int>(t));
        }
    }
    return result;
}

TEST(SurfaceOperations, SplitsAndCollapsesKeepTheSurfaceClosed) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    SurfaceEditor& editor = filled.surface_editor;
    std::vector<int> fresh;
    const std::size_t count = filled.surface.triangles.size();
    for (std::size_t t = 0; t < count; t += 3) {
        const auto v = filled.surface.triangles[t].corners;
        if (filled.surface.triangles[t].alive) {
            const int p = split_surface_edge(editor, v[0], v[1], SurfaceEditor::Rule::Refine);
            ASSERT_GE(p, 0);
            fresh.push_back(p);
        }
    }
    EXPECT_TRUE(invalid_triangles(filled.surface).empty());
    for (const int p : fresh) {
        EXPECT_LT(std::min(std::abs(editor.point(p).head<2>().norm() - 1.0),
                           std::min(std::abs(editor.point(p).z()), std::abs(editor.point(p).z() - 2.0))),
                  1e-9);
    }
    for (const SurfaceTriangle& t : filled.surface.triangles) {
        for (std::size_t k = 0; k < 3 && t.alive; ++k) {
            EXPECT_EQ(filled.surface.triangles_of_edge(t.corners[k], t.corners[(k + 1) % 3]).size(), 2u);
        }
    }
}

std::vector<int> invalid_tetrahedra(const Volume& volume) {
    std::vector<int> result;
    for (const int t : volume.living()) {
        if (!(volume.tetrahedra[static_cast<std::size_t>(t)].quality > 0.0)) {
            result.push_back(t);
        }
    }
    return result;
}

TEST(Straighten, TetrahedraThatStayInvalidBecomeStraight) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape()), 3);
    Volume& volume = filled.volume;
    int bent = 0;
    for (std::size_t t = 0; t < volume.tetrahedra.size() && bent < 5; ++t) {
        const auto& v = volume.tetrahedra[t].corners;
        if (!volume.fixed_edge(v[0], v[1]) && !volume.shapes().has_edge(v[0], v[1])) {
            const Vec3 far(10.0 + bent, 0.0, 0.0);
            volume.shapes().set_edge(v[0], v[1], {volume.point(v[0]) + far, volume.point(v[1]) + far});
            ++bent;
        }
    }
    ASSERT_EQ(bent, 5);
    volume.measure(volume.living());
    const std::vector<int> before = invalid_tetrahedra(volume);
    ASSERT_GE(before.size(), 5u);
    const std::set<int> done = straighten_tetrahedra(volume, filled.surface_editor);
    EXPECT_TRUE(invalid_tetrahedra(volume).empty());
    for (const int t : before) {
        EXPECT_EQ(done.count(t), 1u);
        EXPECT_FALSE(volume.curved(volume.tetrahedra[static_cast<std::size_t>(t)].corners));
    }
    EXPECT_TRUE(straighten_tetrahedra(volume, filled.surface_editor).empty()) << "nothing is left to do";
}

TEST(Straighten, TrianglesThatStayInvalidBecomeStraightAndNoOthers) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2);
    Surface& surface = filled.surface;
    const auto v = surface.triangles[4].corners;
    const Vec3 along = filled.surface_editor.point(v[1]) - filled.surface_editor.point(v[0]);
    surface.shapes.set_edge(v[0], v[1], {filled.surface_editor.point(v[0]) + 4.0 * along});
    filled.surface_editor.placement.measure(surface.triangles_of_edge(v[0], v[1]));
    const std::vector<int> before = invalid_triangles(surface);
    ASSERT_FALSE(before.empty());
    const std::set<int> done = straighten_triangles(filled.surface_editor);
    EXPECT_TRUE(invalid_triangles(surface).empty());
    EXPECT_LT(done.size(), surface.alive() / 4);
    std::set<EdgeKey> straight;
    for (const int t : done) {
        const auto& c = surface.triangles[static_cast<std::size_t>(t)].corners;
        straight.insert({pair_key(c[0], c[1]), pair_key(c[1], c[2]), pair_key(c[2], c[0])});
    }
    for (const auto& [key, segment] : surface.segments) {
        const bool made_straight = straight.count(key) > 0;
        EXPECT_EQ(surface.shapes.has_edge(static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffffu)),
                  !made_straight)
            << "edges on the CAD stay curved elsewhere";
    }
}

TEST(Straighten, NothingIsMadeStraightWithoutNeed) {
    Options options = of_order(2, true);
    options.straighten = true;
    const CurvedMesh mesh = curved(thin_wall(0.1, 0.5 * M_PI), options);
    EXPECT_EQ(mesh.report.invalid, 0u);
    EXPECT_TRUE(mesh.report.straightened.empty());
    EXPECT_EQ(to_msh(mesh), to_msh(curved(thin_wall(0.1, 0.5 * M_PI), of_order(2, true))));
}

}  // namespace
}  // namespace mq::curve

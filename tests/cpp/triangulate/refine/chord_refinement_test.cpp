// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/chord_refinement.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <functional>
#include <gp_Ax2.hxx>
#include <random>

#include "base/error.h"
#include "geometry/occt/distance/shape_distance.h"
#include "mesh/quality/deviation_samples.h"
#include "triangulate/checks.h"
#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/warped_face.h"

namespace mq::triangulate {
namespace {

using Distance = std::function<double(const Vec3&)>;

struct Solid {
    const char* name;
    std::shared_ptr<geometry::Model> model;
    Distance distance;  ///< distance from the round face, which is face 0
    double size;        ///< largest dimension, mm
    long euler;
};

std::vector<Solid> solids() {
    return {{"sphere", geometry::make_sphere(2.0), [](const Vec3& p) { return std::abs(p.norm() - 2.0); }, 4.0, 2},
            {"cylinder", geometry::make_cylinder(2.0, 5.0),
             [](const Vec3& p) { return std::abs(p.head<2>().norm() - 2.0); }, 5.0, 2},
            {"torus", geometry::make_torus(5.0, 1.5),
             [](const Vec3& p) { return std::abs(std::hypot(p.head<2>().norm() - 5.0, p.z()) - 1.5); }, 13.0, 0}};
}

/// Returns the largest distance over the corners of an even subdivision of every triangle of face 0, mm.
double deviation(const mesh::TriangleMesh& mesh, const Distance& distance, int parts) {
    double worst = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<Vec3, 3> p = corners_of(mesh, t);
        for (int i = 0; mesh.triangle_face[t] == 0 && i <= parts; ++i) {
            for (int j = 0; i + j <= parts; ++j) {
                const Vec3 sample = (i * p[0] + j * p[1] + (parts - i - j) * p[2]) / parts + mesh.origin;
                worst = std::max(worst, distance(sample));
            }
        }
    }
    return worst;
}

// Ratio to the tolerance: distances are bounded only where an edge or a triangle is expected to be farthest.
constexpr double kBetweenSamples = 1.005;

/// Checks that the report names a point of the triangle that it names, at the reported distance from the solid.
void expect_place(const Solid& solid, const Result& result) {
    const auto t = static_cast<std::size_t>(result.report.max_chord_triangle);
    ASSERT_LT(t, result.mesh.triangles.size());
    const std::array<Vec3, 3> p = corners_of(result.mesh, t);
    const Vec3 at = result.report.max_chord_point - result.mesh.origin;
    const double whole = (p[1] - p[0]).cross(p[2] - p[0]).norm();
    double parts = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        parts += (p[i] - at).cross(p[(i + 1) % 3] - at).norm();
    }
    EXPECT_NEAR(parts, whole, 1e-9 * (1.0 + whole));
    EXPECT_NEAR(solid.distance(result.report.max_chord_point), result.report.max_chord_height, 1e-6);
}

void expect_chord(const Solid& solid, const TriangulateOptions& options, double bound) {
    SCOPED_TRACE(std::string(solid.name) + " to " + std::to_string(bound));
    const Result result = mesh_of(solid.model, options);
    expect_sound(result, solid.euler, true);
    expect_angles(result, options.min_angle);
    const double resolution = SinglePrecisionGrid(solid.model->topology().box).resolution();
    EXPECT_DOUBLE_EQ(result.report.chord_height_asked, bound);
    EXPECT_LE(result.report.max_chord_height, bound + resolution);
    EXPECT_LE(deviation(result.mesh, solid.distance, 2), bound + resolution);
    const double dense = deviation(result.mesh, solid.distance, 12);
    EXPECT_LE(dense, kBetweenSamples * bound + resolution);
    EXPECT_GE(dense, 0.05 * bound) << "far finer than asked";
    EXPECT_NEAR(dense, result.report.max_chord_height, 1e-6 + 0.02 * bound);
    expect_place(solid, result);
}

/// Triangles that do not change when a segment beside them is split first, or that cannot be split at the first side,
/// are tried again.
TEST(ChordRefinement, EveryTriangleOfARingKeepsTheChordHeight) {
    const double rings[4][4] = {// radii, chord height, angle
                                {5.259051005402928, 2.7591574110792747, 0.061115928338595096, 17.786116049799865},
                                {5.77, 1.42519, 0.0416747, 24.7},
                                {1.57, 0.76302, 0.00620206, 20.7},
                                {5.84, 3.40472, 0.0234467, 24.3}};
    for (const auto& [large, small, chord, angle] : rings) {
        TriangulateOptions options;
        options.chord_height = chord;
        options.min_angle = angle;
        EXPECT_LE(mesh_of(geometry::make_torus(large, small), options).report.max_chord_height, chord) << large;
    }
}

TEST(Chord, AbsoluteBoundHoldsOnDenseSamples) {
    for (const Solid& solid : solids()) {
        for (const double bound : {0.2, 0.05, 0.01}) {
            TriangulateOptions options;
            options.chord_height = bound;
            expect_chord(solid, options, bound);
        }
    }
}

/// Edges and triangles whose largest distance from the surface is not where their corners and sides predict it.
TEST(Chord, HoldsBesideThePlacesThatAreMeasured) {
    for (const auto& [waves, height] : {std::pair(5.0, 0.5), std::pair(5.0, 1.0), std::pair(8.0, 2.0)}) {
        const auto model = wavy_face(waves, height);
        const geometry::Face& face = model->topology().faces[0];
        const auto distance = [&](const Vec3& p) {
            const double u = face.low[0] + 0.1 * p.x() * (face.high[0] - face.low[0]);
            const double v = face.low[1] + 0.1 * p.y() * (face.high[1] - face.low[1]);
            return model->answer(geometry::Query::face_nearest(0, p, u, v)).distance;
        };
        for (const double bound : {0.1, 0.05, 0.02, 0.01}) {
            for (const double angle : {25.0, 30.0}) {
                SCOPED_TRACE(std::to_string(waves) + " " + std::to_string(height) + " to " + std::to_string(bound));
                TriangulateOptions options;
                options.min_angle = angle;
                options.chord_height = bound;
                const Result result = mesh_of(model, options);
                EXPECT_LE(result.report.max_chord_height, bound);
                EXPECT_LE(deviation(result.mesh, distance, 12), kBetweenSamples * bound);
            }
        }
    }
}

TEST(Chord, RelativeBoundIsAFractionOfTheLargestDimension) {
    for (const Solid& solid : solids()) {
        TriangulateOptions options;
        options.min_angle = 30.0;
        options.chord_height_relative = 0.004;
        const double bound = 0.004 * solid.model->topology().box.largest_side();
        EXPECT_NEAR(bound, 0.004 * solid.size, 0.02 * bound);
        expect_chord(solid, options, bound);
    }
}

// Returns the largest height of the cubic at places with all barycentric weights at least an eighth.
double highest_inside(const TriangleHeights& heights) {
    constexpr int kParts = 120;  // Steps of the grid along each side.
    double highest = 0.0;
    for (int i = kParts / 8; i <= kParts; ++i) {
        for (int j = kParts / 8; i + j <= kParts - kParts / 8; ++j) {
            const double a = static_cast<double>(i) / kParts;
            const double b = static_cast<double>(j) / kParts;
            highest = std::max(highest, std::abs(heights.at({a, b, 1.0 - a - b})));
        }
    }
    return highest;
}

TEST(Chord, PeakOfATriangleIsThatOfTheCubicOverIt) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> heights(0.1, 1.0);
    std::uniform_real_distribution<double> skews(-1.0, 1.0);
    for (const double skewed : {0.0, 1.0}) {
        for (int n = 0; n < 200; ++n) {
            const TriangleHeights over{{-heights(random), -heights(random), -heights(random)},
                                       {skewed * skews(random), skewed * skews(random), skewed * skews(random)}};
            const TrianglePeak peak = triangle_peak(over);
            // A peak beside a side is one of the places of a lattice.
            EXPECT_NEAR(peak.height, highest_inside(over), 0.03) << n;
            EXPECT_NEAR(std::abs(over.at(peak.weights)), peak.height, 1e-12);
            EXPECT_LE(peak.height, over.bound());
            EXPECT_NEAR(peak.weights[0] + peak.weights[1] + peak.weights[2], 1.0, 1e-12);
        }
    }
    EXPECT_NEAR(triangle_peak({{1.0, 1.0, 1.0}, {}}).height, 4.0 / 3.0, 1e-12);
    EXPECT_EQ(triangle_peak({}).height, 0.0);
}

TEST(Chord, SkewIsThatOfTheSurface) {
    constexpr double kSmall = 1e-4;  // Coefficient of the cubic: slopes small enough for linear formulas.
    // z = kSmall x^3 is -kSmall x (1 - x) (1 + x) over its chord, and 1 + x = 3/2 - (1 - 2 x) / 2.
    ClassifiedMesh::VertexUse from;
    from.normal = Vec3::UnitZ();
    ClassifiedMesh::VertexUse to;
    to.point = {1.0, 0.0, kSmall};
    to.normal = Vec3(-3.0 * kSmall, 0.0, 1.0).normalized();
    EXPECT_NEAR(side_skew(from, to), 0.5 * kSmall, 1e-10);
    EXPECT_NEAR(side_skew(to, from), -0.5 * kSmall, 1e-10);
}

TEST(Chord, HoldsOnEveryPart) {
    for (const Insertion insertion : {Insertion::OffCentre, Insertion::Circumcentre}) {
        for (const geometry::Part& part : geometry::all_parts()) {
            for (const double bound : {0.02, 0.002}) {
                SCOPED_TRACE(part.name + " to " + std::to_string(bound));
                TriangulateOptions options;
                options.insertion = insertion;
                options.chord_height_relative = bound;
                const Result result = mesh_of(part.model, options);
                expect_sound(result, part.euler, part.closed);
                expect_angles(result, options.min_angle);
                const double resolution = SinglePrecisionGrid(part.model->topology().box).resolution();
                EXPECT_LE(result.report.max_chord_height, result.report.chord_height_asked + resolution + 1e-7);
            }
        }
    }
}

TEST(Chord, HoldsOnShapes) {
    for (const char* name : {"filleted_box", "fused", "blade"}) {
        SCOPED_TRACE(name);
        const TopoDS_Shape shape = geometry::stored(name);
        TriangulateOptions options;
        options.chord_height = 0.02;
        const Result result = mesh_of(geometry::make_shape_model(shape), options);
        expect_sound(result, 2, true);
        expect_angles(result, options.min_angle);
        EXPECT_LE(result.report.max_chord_height, 0.02 + 1e-6);
        for (const double d : geometry::distances_to_faces(shape, mesh::deviation_samples(result.mesh).points)) {
            EXPECT_LE(d, 0.02 + 1e-6);
        }
    }
}

double dimples(double x, double y) {
    constexpr double kTwoPi = 6.283185307179586;  // A full turn, radians.
    return 0.3 * (1.0 - std::cos(kTwoPi * x / 25.0)) * (1.0 - std::cos(kTwoPi * y / 25.0));
}

/// Two triangles with flat sides are not measured at any place where their surface is curved.
TEST(Chord, HoldsOnDimplesBetweenTheMiddles) {
    constexpr int kPoints = 37;     // Points along each parameter.
    constexpr double kSize = 50.0;  // mm: side of the square.
    TColgp_Array2OfPnt points(1, kPoints, 1, kPoints);
    for (int i = 1; i <= kPoints; ++i) {
        for (int k = 1; k <= kPoints; ++k) {
            const double x = kSize * (i - 1) / (kPoints - 1);
            const double y = kSize * (k - 1) / (kPoints - 1);
            points(i, k) = gp_Pnt(x, y, dimples(x, y));
        }
    }
    GeomAPI_PointsToBSplineSurface spline;
    spline.Interpolate(points);
    const auto model = geometry::make_shape_model(BRepBuilderAPI_MakeFace(spline.Surface(), 1e-6).Shape());
    EXPECT_EQ(model->topology().faces[0].spans[0].bounds.size(), static_cast<std::size_t>(kPoints));
    TriangulateOptions options;
    options.chord_height = 0.1;
    const Result result = mesh_of(model, options);
    expect_angles(result, options.min_angle);
    constexpr int kParts = 12;  // Steps of the subdivision along each side.
    double farthest = 0.0;
    for (const auto& t : result.mesh.triangles) {
        for (int i = 0; i <= kParts; ++i) {
            for (int k = 0; i + k <= kParts; ++k) {
                const Vec3 p = (i * result.mesh.vertices[t[0]] + k * result.mesh.vertices[t[1]] +
                                (kParts - i - k) * result.mesh.vertices[t[2]]) /
                               kParts;
                farthest = std::max(farthest, std::abs(p.z() - dimples(p.x(), p.y())));
            }
        }
    }
    EXPECT_LE(farthest, 0.1 + 0.001);
    EXPECT_GE(farthest, 0.05);
    EXPECT_LE(result.report.max_chord_height, 0.1);
}

/// Splitting an edge there swaps others around the cylinder, one after the other, until all are within the tolerance.
TEST(Chord, HoldsWhereEachEdgeThatIsSplitMakesAnother) {
    const gp_Ax2 axis(gp_Pnt(2.5087625022713453, -2.978303498885108, 1.8125630772789592), gp::DZ());
    const auto model =
        geometry::make_shape_model(BRepPrimAPI_MakeCylinder(axis, 4.0696492436333855, 4.223834131583539).Shape());
    TriangulateOptions options;
    options.min_angle = 23.557490993033504;
    options.chord_height_relative = 0.0026144965210652517;
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    const mesh::MeshReport report = triangulate(engine, model, options).report;
    EXPECT_LE(report.max_chord_height, report.chord_height_asked);
    EXPECT_GE(report.min_angle, options.min_angle);
}

TEST(Chord, FlatPartsStayAsTheyAre) {
    TriangulateOptions options;
    const Result coarse = mesh_of(geometry::make_box(1.0, 2.0, 3.0), options);
    options.chord_height = 1e-4;
    const Result fine = mesh_of(geometry::make_box(1.0, 2.0, 3.0), options);
    EXPECT_EQ(coarse.mesh.triangles, fine.mesh.triangles);
    EXPECT_LE(fine.report.max_chord_height, 1e-6);
}

TEST(Chord, FinerBoundsTakeMoreTriangles) {
    std::size_t before = 0;
    for (const double bound : {0.1, 0.03, 0.01}) {
        TriangulateOptions options;
        options.chord_height = bound;
        const std::size_t now = mesh_of(geometry::make_torus(5.0, 1.5), options).mesh.triangles.size();
        EXPECT_GT(now, before);
        before = now;
    }
    // n triangles of side a: the height over each is a^2 / 8 r, and their total area is that of the torus.
    const double side = std::sqrt(8.0 * 1.5 * 0.01);
    const double ideal = 4.0 * M_PI * M_PI * 5.0 * 1.5 / (0.433 * side * side);
    EXPECT_LT(before, 6.0 * ideal);
}

TEST(Chord, RefusesABoundBelowTheGrid) {
    for (const double scale : {1e-3, 1.0, 1e6}) {
        TriangulateOptions options;
        options.chord_height = 1e-9 * scale;
        try {
            mesh_of(geometry::make_sphere(2.0 * scale), options);
            ADD_FAILURE() << "taken at scale " << scale;
        } catch (const InvalidInput& error) {
            EXPECT_NE(std::string(error.what()).find("chord_height"), std::string::npos) << error.what();
        }
    }
}

/// A box of 1 mm with one edge that deviates from both of its faces by `bulge`.
TopoDS_Shape bulging_box(double bulge) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
    const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current());
    double from = 0.0;
    double to = 0.0;
    const Handle(Geom_Curve) line = BRep_Tool::Curve(edge, from, to);
    const gp_Pnt a = line->Value(from);
    const gp_Pnt b = line->Value(to);
    const gp_Pnt middle(0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()), 0.5 * (a.Z() + b.Z()));
    const gp_Vec out(gp_Pnt(0.5, 0.5, 0.5), middle);
    TColgp_Array1OfPnt poles(1, 3);
    poles.SetValue(1, a);
    poles.SetValue(2, middle.Translated(2.0 * bulge * out.Normalized()));
    poles.SetValue(3, b);
    EXPECT_EQ(from, 0.0);
    EXPECT_EQ(to, 1.0);
    BRep_Builder().UpdateEdge(edge, new Geom_BezierCurve(poles), 2.0 * bulge);
    return box;
}

TEST(Chord, EndsWhereEdgesLieOffTheirFaces) {
    TriangulateOptions options;
    options.chord_height = 0.0005;
    const Result result = mesh_of(geometry::make_shape_model(bulging_box(0.01)), options);
    expect_sound(result, 2, true);
    EXPECT_GT(result.report.max_chord_height, 0.0005);
    EXPECT_LT(result.report.max_chord_height, 0.01);
    ASSERT_FALSE(result.report.notes.empty());
    EXPECT_NE(result.report.notes.back().text().find("deviate from it by more than that"), std::string::npos);
    EXPECT_LT(result.mesh.triangles.size(), 20000u);
    EXPECT_TRUE(result.report.complete);
}

TEST(Chord, MaxEdgeBoundsEveryEdge) {
    for (const Solid& solid : solids()) {
        SCOPED_TRACE(solid.name);
        TriangulateOptions options;
        options.max_edge = 0.7;
        const Result result = mesh_of(solid.model, options);
        expect_sound(result, solid.euler, true);
        expect_angles(result, options.min_angle);
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(result.mesh, t);
            EXPECT_LE((p[1] - p[0]).norm(), 0.7);
        }
    }
}

}  // namespace
}  // namespace mq::triangulate

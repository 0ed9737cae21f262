// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "curve/measuring.h"
#include "curve/surface/editor.h"
#include "curve/volume/editor.h"
#include "curve/volume/remeshing/local_remeshing.h"
#include "curve/volume/tuning.h"
#include "curve/volume/untangle.h"
#include "geometry/occt/shape_model.h"

/// Carries out each local operation of Dey, O'Bara, Shephard 1999 on the smallest mesh that needs it, for
/// papers/dey_operations.py. Prints one JSON object an operation: the elements and their edges, as points, before and
/// after.
namespace {

using namespace mq;
using namespace mq::curve;
using namespace mq::elements;

constexpr int kEdgePoints = 24;
constexpr int kFacePoints = 12;

void print_point(const Vec3& p, bool first) {
    std::printf("%s[%.6g,%.6g,%.6g]", first ? "" : ",", p.x(), p.y(), p.z());
}

void print_edge(const CurvedShapes& shapes, int a, int b, bool fixed) {
    const Lattice& lattice = Lattice::of(1, shapes.order());
    std::vector<Vec3> control{shapes.vertices[static_cast<std::size_t>(a)].point};
    for (const Vec3& inner : shapes.edge_inner(a, b)) {
        control.push_back(inner);
    }
    control.push_back(shapes.vertices[static_cast<std::size_t>(b)].point);
    std::printf("{\"vertices\":[%d,%d],\"fixed\":%s,\"points\":[", a, b, fixed ? "true" : "false");
    for (int i = 0; i <= kEdgePoints; ++i) {
        const double s = static_cast<double>(i) / kEdgePoints;
        print_point(value(lattice, control, {1.0 - s, s, 0.0, 0.0}), i == 0);
    }
    std::printf("]}");
}

/// Prints "edges" of elements, each once, and "elements" with their qualities.
template <std::size_t N, typename Fixed>
void print_state(const CurvedShapes& shapes, const std::vector<std::pair<std::array<int, N>, double>>& elements,
                 Fixed&& fixed) {
    std::set<std::pair<int, int>> edges;
    std::printf("{\"elements\":[");
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::printf("%s{\"quality\":%.4f,\"corners\":[", i == 0 ? "" : ",", elements[i].second);
        for (std::size_t k = 0; k < N; ++k) {
            std::printf("%s%d", k == 0 ? "" : ",", elements[i].first[k]);
            for (std::size_t j = 0; j < k; ++j) {
                edges.insert(std::minmax(elements[i].first[j], elements[i].first[k]));
            }
        }
        std::printf("]}");
    }
    std::printf("],\"edges\":[");
    bool first = true;
    for (const auto& [a, b] : edges) {
        std::printf("%s", first ? "" : ",");
        print_edge(shapes, a, b, fixed(a, b));
        first = false;
    }
    std::printf("]}");
}

// ---------------------------------------------------------------------------------------------------------------------
// On a face: a plane one whose lower border is an arc that rises into it.

const Vec3 kA(0.0, 0.0, 0.0);
const Vec3 kB(4.0, 0.0, 0.0);
constexpr double kRise = 0.6;  // of the arc from A to B

gp_Pnt at(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// A face between the arc from A to B and the polygon on from B back to A.
std::shared_ptr<geometry::Model> face_over_arc(const std::vector<Vec3>& rest) {
    const Vec3 middle = 0.5 * (kA + kB) + kRise * Vec3::UnitY();
    BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(at(kA), at(middle), at(kB)).Value()));
    std::vector<Vec3> corners{kB};
    corners.insert(corners.end(), rest.begin(), rest.end());
    corners.push_back(kA);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        wire.Add(BRepBuilderAPI_MakeEdge(at(corners[i]), at(corners[i + 1])));
    }
    return geometry::make_shape_model(BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Shape());
}

/// The mesh of such a face. Vertices are numbered: A, B, the rest of the outline, those inside.
class FaceScene {
  public:
    FaceScene(const std::vector<Vec3>& rest, const std::vector<Vec3>& inside,
              const std::vector<std::array<int, 3>>& triangles)
        : session_(engine_, face_over_arc(rest)),
          surface(classify(session_, straight(rest, inside, triangles), 2)),
          editor(session_, surface) {
        editor.placement.place(live_triangles(surface));
    }

    void print() const {
        std::vector<std::pair<std::array<int, 3>, double>> elements;
        for (const int t : live_triangles(surface)) {
            elements.emplace_back(editor.triangle(t).corners, editor.triangle(t).quality);
        }
        print_state(surface.shapes, elements, [&](int a, int b) { return surface.segment(a, b) != nullptr; });
    }
    int triangle(const std::array<int, 3>& corners) const {
        for (const int t : live_triangles(surface)) {
            const FaceKey key = face_key(corners[0], corners[1], corners[2]);
            const auto& v = editor.triangle(t).corners;
            if (face_key(v[0], v[1], v[2]) == key) {
                return t;
            }
        }
        return -1;
    }

  private:
    mesh::TriangleMesh straight(const std::vector<Vec3>& rest, const std::vector<Vec3>& inside,
                                const std::vector<std::array<int, 3>>& triangles) {
        mesh::TriangleMesh mesh;
        mesh.vertices = {kA, kB};
        mesh.vertices.insert(mesh.vertices.end(), rest.begin(), rest.end());
        for (const Vec3& p : mesh.vertices) {
            const auto& nodes = session_.topology().nodes;
            std::int32_t nearest = 0;
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                if ((nodes[n].point - p).norm() < (nodes[static_cast<std::size_t>(nearest)].point - p).norm()) {
                    nearest = static_cast<std::int32_t>(n);
                }
            }
            mesh.vertex_entity.push_back({0, nearest});
        }
        for (const Vec3& p : inside) {
            mesh.vertices.push_back(p);
            mesh.vertex_entity.push_back({2, 0});
        }
        for (const auto& t : triangles) {
            mesh.triangles.push_back({t[0], t[1], t[2]});
            mesh.triangle_face.push_back(0);
        }
        return mesh;
    }

    geometry::Engine engine_{geometry::Engine::Mode::Direct};
    geometry::Session session_;

  public:
    CurvedSurface surface;
    SurfaceEditor editor;
};

/// Prints the operation; `change` returns whether it changed the mesh.
template <typename Scene>
void carry_out(const char* name, Scene& scene, const std::function<bool()>& change) {
    std::printf("{\"operation\":\"%s\",\"before\":", name);
    scene.print();
    const bool done = change();
    std::printf(",\"done\":%s,\"after\":", done ? "true" : "false");
    scene.print();
    std::printf("}\n");
}

void operations_on_faces() {
    constexpr SurfaceEditor::Rule kImprove = SurfaceEditor::Rule::Improve;
    const std::vector<std::array<int, 3>> diagonal{{0, 1, 2}, {0, 2, 3}};
    {
        FaceScene scene({{6.0, 2.0, 0.0}, {0.5, 3.0, 0.0}}, {}, diagonal);
        carry_out("edge swap on a face", scene, [&] { return swap_surface_edge(scene.editor, 0, 2); });
    }
    {
        FaceScene scene({{4.0, 3.0, 0.0}, {0.0, 3.0, 0.0}}, {{2.0, 0.7, 0.0}},
                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
        carry_out("edge collapse on a face", scene,
                  [&] { return collapse_surface_edge(scene.editor, 4, 2, kImprove); });
    }
    {
        FaceScene scene({{4.0, 2.0, 0.0}, {0.0, 2.0, 0.0}}, {}, diagonal);
        carry_out("curving an edge on a face", scene, [&] { return curve_face_edge(scene.editor, 0, 2, 1); });
    }
    {
        FaceScene scene({{5.0, 2.2, 0.0}, {2.0, 2.8, 0.0}, {-1.0, 2.2, 0.0}}, {{1.8, 0.5, 0.0}},
                        {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}});
        carry_out("refilling a cavity of a face", scene, [&] {
            return retriangulate_cavity(scene.editor, scene.triangle({0, 1, 5}));
        });
    }
    {
        FaceScene scene({{4.0, 1.4, 0.0}, {0.0, 1.4, 0.0}}, {}, diagonal);
        carry_out("boundary point, then swap", scene, [&] {
            const int middle = split_surface_edge(scene.editor, 0, 1, SurfaceEditor::Rule::Try);
            return middle >= 0 && swap_surface_edge(scene.editor, 0, 2);
        });
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// Inside a region.

/// A closed surface of straight triangles, some of whose edges are curved, and the tetrahedra inside.
class RegionScene {
  public:
    RegionScene(int order, const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& hull)
        : surface(order) {
        for (const Vec3& p : points) {
            surface.add_vertex({p, {2, 0}});
        }
        for (const auto& t : hull) {
            const int added = surface.add_triangle(t, 0);
            surface.triangles[static_cast<std::size_t>(added)].quality = 1.0;
        }
        surface.volume_faces = {{{0, false}}};
        volume.emplace(surface);
        editor.emplace(*volume);
    }

    /// Adds tetrahedra, turned so that their volumes are positive.
    void fill(const std::vector<std::array<int, 4>>& tetrahedra) {
        for (std::array<int, 4> v : tetrahedra) {
            if (volume->straight_jacobian(v) < 0.0) {
                std::swap(v[2], v[3]);
            }
            volume->add(v, 0);
        }
        volume->measure(volume->live_tetrahedra());
    }
    int worst() const {
        int found = -1;
        for (const int t : volume->live_tetrahedra()) {
            if (found < 0 || quality(t) < quality(found)) {
                found = t;
            }
        }
        return found;
    }
    double quality(int t) const { return volume->tetrahedra[static_cast<std::size_t>(t)].quality; }

    void print() const {
        std::vector<std::pair<std::array<int, 4>, double>> elements;
        for (const int t : volume->live_tetrahedra()) {
            elements.emplace_back(volume->tetrahedra[static_cast<std::size_t>(t)].corners, quality(t));
        }
        print_state(surface.shapes, elements, [&](int a, int b) { return volume->fixed_edge(a, b); });
    }

    CurvedSurface surface;
    std::optional<TetrahedralMesh> volume;
    std::optional<VolumeEditor> editor;
};

const std::vector<std::array<int, 3>> kOctahedron{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                                                  {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};

/// Four vertices around, two on the axis (x, x), and vertices inside; the control point of the edge
/// between vertices 0 and 1 is `bend`.
std::unique_ptr<RegionScene> octahedron(double x, const Vec3& bend, const std::vector<Vec3>& inside) {
    auto scene = std::make_unique<RegionScene>(
        2,
        std::vector<Vec3>{
            {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {x, x, 1.0}, {x, x, -1.0}},
        kOctahedron);
    scene->surface.shapes.set_edge(0, 1, {bend});
    std::vector<std::array<int, 4>> tetrahedra;
    if (inside.empty()) {
        tetrahedra = {{4, 5, 0, 1}, {4, 5, 1, 2}, {4, 5, 2, 3}, {4, 5, 3, 0}};
    }
    for (const Vec3& p : inside) {
        const int v = scene->volume->add_vertex(p, 0);
        for (const auto& t : kOctahedron) {
            tetrahedra.push_back({t[0], t[1], t[2], v});
        }
    }
    scene->fill(tetrahedra);
    return scene;
}

const Vec3 kNearBend(0.33, 0.33, 0.0);  // a vertex inside, which the bent edge passes
const Vec3 kBend(0.2, 0.2, 0.0);

void reconnections_in_regions() {
    constexpr VolumeEditor::Rule kImprove = VolumeEditor::Rule::Improve;
    {
        const auto scene = octahedron(0.4, kBend, {});
        carry_out("edge swap in a region", *scene, [&] { return swap_region_edge(*scene->editor, 4, 5, kImprove); });
    }
    {
        const double h = 0.5 * std::sqrt(3.0);
        RegionScene scene(2, {{1.0, 0.0, 0.0}, {-0.5, h, 0.0}, {-0.5, -h, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}},
                          {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
        scene.surface.shapes.set_edge(0, 3, {Vec3(0.3, 0.0, -0.1)});
        scene.fill({{0, 1, 2, 3}, {0, 1, 2, 4}});
        carry_out("face swap in a region", scene, [&] { return swap_region_face(*scene.editor, 0, 1, 2, kImprove); });
    }
    {
        const auto scene = octahedron(0.0, kBend, {kNearBend});
        carry_out("edge collapse in a region", *scene, [&] { return collapse_region_edge(*scene->editor, 6, 2); });
    }
}

void curving_in_regions() {
    {
        // Only one corner is inverted: an edge is curved at one end at a time.
        const auto scene = octahedron(0.0, {0.55, 0.0, 0.0}, {kNearBend});
        carry_out("curving an edge in a region", *scene,
                  [&] { return curve_region_edge(*scene->editor, scene->worst()); });
    }
    {
        // Two corners of an element are inverted alike: no single edge helps.
        const auto scene = octahedron(0.0, kBend, {kNearBend});
        carry_out("curving a patch in a region", *scene, [&] {
            if (curve_region_edge(*scene->editor, scene->worst())) {
                return false;
            }
            const Progress progress;
            UntanglingPatch patch(*scene->volume, scene->volume->live_tetrahedra(), {}, scene->surface.shapes.order(),
                                  progress);
            patch.propagate_curvature(VolumeTuning::kInwardSweeps);
            untangle(patch, VolumeTuning::kTargetJacobian, progress);
            patch.store(progress);
            return true;
        });
    }
    {
        const auto scene = octahedron(0.0, kBend, {kNearBend});
        carry_out("vertex relocation in a region", *scene, [&] {
            std::vector<std::array<int, 4>> star;
            for (const int t : scene->volume->of_vertex(6)) {
                star.push_back(scene->volume->tetrahedra[static_cast<std::size_t>(t)].corners);
            }
            const double before = scene->quality(scene->worst());
            relocate_vertex(*scene->editor, 6, star, 1.0);
            scene->volume->measure(scene->volume->live_tetrahedra());
            return scene->quality(scene->worst()) > before;
        });
    }
    {
        const auto scene = octahedron(0.4, kBend, {});
        carry_out("refilling a region", *scene, [&] {
            LocalRemeshing done;
            const Progress progress;
            remesh_and_repair(scene->volume, scene->surface, RepairScope::Poor, done, progress);
            return done.cavities > 0;
        });
    }
}

/// Two tetrahedra on a face whose cubic edge bends past the node inside: figure 14.
class FaceNodes {
  public:
    FaceNodes()
        : scene_(3, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 0.9, 0.0}, {0.5, 0.3, 0.8}, {0.5, 0.3, -0.8}},
                 {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}) {
        CurvedShapes& shapes = scene_.surface.shapes;
        shapes.set_edge(0, 1, {Vec3(1.0 / 3.0, 0.5, 0.0), Vec3(2.0 / 3.0, 0.5, 0.0)});
        const Lattice& lattice = Lattice::of(2, 3);
        std::vector<Vec3> control;
        shapes.triangle(kFace, control);
        std::vector<Vec3> nodes = bezier_to_nodes(lattice, control);
        const auto inner = static_cast<std::size_t>(lattice.index({1, 1, 1, 0}));
        nodes[inner] = Vec3(0.5, 0.3, 0.0);  // where it is in the straight face
        shapes.set_face(kFace, {nodes_to_bezier(lattice, nodes)[inner]});
        scene_.fill({{0, 1, 2, 3}, {0, 1, 2, 4}});
    }

    void print() const {
        std::printf("{\"state\":");
        scene_.print();
        const Lattice& lattice = Lattice::of(2, 3);
        std::vector<Vec3> control;
        scene_.surface.shapes.triangle(kFace, control);
        std::printf(",\"node\":");
        print_point(value(lattice, control, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0}), true);
        std::printf(",\"lines\":[");
        for (int i = 1; i < kFacePoints; ++i) {
            std::printf("%s[", i == 1 ? "" : ",");
            const double s = static_cast<double>(i) / kFacePoints;
            for (int j = 0; j <= kEdgePoints; ++j) {
                const double r = (1.0 - s) * j / kEdgePoints;
                print_point(value(lattice, control, {1.0 - s - r, r, s, 0.0}), j == 0);
            }
            std::printf("]");
        }
        std::printf("]}");
    }
    bool relocate() { return relocate_face_nodes(*scene_.editor, kFace[0], kFace[1], kFace[2]); }

  private:
    static constexpr std::array<int, 3> kFace{0, 1, 2};
    RegionScene scene_;
};

}  // namespace

int main() {
    operations_on_faces();
    reconnections_in_regions();
    curving_in_regions();
    FaceNodes nodes;
    carry_out("relocating the nodes of a face", nodes, [&] { return nodes.relocate(); });
    return 0;
}

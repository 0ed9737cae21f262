// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/degree_raising.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "curve/measuring.h"
#include "given/matching/given_mesh.h"

namespace mq::given {

using curve::CurvedSurface;
using curve::SurfaceEditor;
using curve::TetrahedralMesh;
using curve::Tetrahedron;
using elements::CurvedShapes;
using elements::Lattice;

namespace {

using Corners = std::array<int, 3>;

std::vector<Corners> faces_of(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra) {
    std::vector<Corners> faces;
    for (const int t : curve::live_triangles(surface)) {
        faces.push_back(surface.triangles[static_cast<std::size_t>(t)].corners);
    }
    for (const Tetrahedron& t : tetrahedra) {
        if (t.alive) {
            const auto four = curve::outward_faces(t.corners);
            faces.insert(faces.end(), four.begin(), four.end());
        }
    }
    return faces;
}

class Placing {
  public:
    Placing(SurfaceEditor& editor, TetrahedralMesh* volume)
        : editor_(editor), volume_(volume), before_(editor.surface.shapes), valid_(volume == nullptr ? 0 : count()) {
        for (std::size_t t = 0; t < valid_.size(); ++t) {
            valid_[t] = volume_->tetrahedra[t].quality > 0.0 ? 1 : 0;
        }
    }

    std::size_t run(const Progress& progress) {
        const std::vector<int> all = curve::live_triangles(editor_.surface);
        for (const int t : all) {
            if (editor_.triangle(t).quality > 0.0) {
                valid_triangles_.insert(t);
            }
        }
        for (const int t : all) {
            const Corners& v = editor_.triangle(t).corners;
            for (std::size_t k = 0; k < 3; ++k) {
                shapes().forget_edge(v[k], v[(k + 1) % 3]);
            }
            shapes().forget_face(v);
        }
        editor_.placement.place(all);
        if (volume_ != nullptr) {
            volume_->measure(volume_->live_tetrahedra(), &progress);
        }
        while (undo_invalid()) {
            progress.check();
        }
        return faces_.size();
    }

  private:
    CurvedShapes& shapes() { return editor_.surface.shapes; }
    std::size_t count() const { return volume_->tetrahedra.size(); }

    /// Gives the edges and faces on the surface of elements that became invalid their former shapes.
    /// @return whether there were elements with new shapes among these.
    bool undo_invalid() {
        std::set<int> touched;
        std::set<std::pair<int, int>> edges;
        const auto mark_edges = [&](const auto& corners) {
            for (std::size_t i = 0; i < corners.size(); ++i) {
                for (std::size_t k = i + 1; k < corners.size(); ++k) {
                    const std::pair<int, int> edge = std::minmax(corners[i], corners[k]);
                    if (editor_.surface.has_edge(edge.first, edge.second) && edges_.insert(edge).second) {
                        edges.insert(edge);
                    }
                }
            }
        };
        for (const int t : valid_triangles_) {
            if (!(editor_.triangle(t).quality > 0.0) && faces_.insert(t).second) {
                mark_edges(editor_.triangle(t).corners);
                touched.insert(t);
            }
        }
        for (std::size_t t = 0; t < valid_.size(); ++t) {
            const Tetrahedron& tetrahedron = volume_->tetrahedra[t];
            if (tetrahedron.alive && valid_[t] != 0 && !(tetrahedron.quality > 0.0)) {
                mark_edges(tetrahedron.corners);
                mark_faces(tetrahedron.corners, touched);
            }
        }
        for (const auto& [a, b] : edges) {
            restore_edge(a, b);
            for (const int t : editor_.surface.triangles_of_edge(a, b)) {
                touched.insert(t);
            }
        }
        measure_again({touched.begin(), touched.end()});
        return !touched.empty();
    }

    void mark_faces(const std::array<int, 4>& corners, std::set<int>& touched) {
        for (const Corners& face : curve::outward_faces(corners)) {
            for (const int t : editor_.surface.triangles_of_edge(face[0], face[1])) {
                const Corners& own = editor_.triangle(t).corners;
                if (elements::face_key(own[0], own[1], own[2]) == elements::face_key(face[0], face[1], face[2]) &&
                    faces_.insert(t).second) {
                    touched.insert(t);
                }
            }
        }
    }

    void restore_edge(int a, int b) {
        if (before_.has_edge(a, b)) {
            shapes().set_edge(a, b, before_.edge_inner(a, b));
        } else {
            shapes().forget_edge(a, b);
        }
    }

    /// Fits triangles beside edges that got their former shapes back to these edges.
    void measure_again(const std::vector<int>& touched) {
        std::vector<int> fresh;
        std::set<int> tetrahedra;
        for (const int t : touched) {
            const Corners& v = editor_.triangle(t).corners;
            if (faces_.count(t) == 0) {
                fresh.push_back(t);
            } else {
                restore_face(v);
            }
            for (std::size_t k = 0; volume_ != nullptr && k < 3; ++k) {
                const std::vector<int>& around = volume_->of_vertex(v[k]);
                tetrahedra.insert(around.begin(), around.end());
            }
        }
        editor_.placement.place(fresh);
        // Placing gives shapes to straight edges of curved faces.
        for (const auto& [a, b] : edges_) {
            restore_edge(a, b);
        }
        editor_.placement.measure(touched);
        if (volume_ != nullptr) {
            volume_->measure({tetrahedra.begin(), tetrahedra.end()});
        }
    }

    void restore_face(const Corners& v) {
        std::vector<Vec3> control;
        before_.triangle(v, control);
        shapes().set_inside(v, control);
    }

    SurfaceEditor& editor_;
    TetrahedralMesh* volume_;
    CurvedShapes before_;
    std::vector<char> valid_;              ///< by tetrahedron: whether it was valid before
    std::set<int> valid_triangles_;        ///< triangles that were valid before
    std::set<int> faces_;                  ///< triangles that got their former shapes back
    std::set<std::pair<int, int>> edges_;  ///< edges that got their former shapes back
};

}  // namespace

CurvedSurface with_degree_raised(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra) {
    CurvedSurface result = surface;
    const CurvedShapes& shapes = surface.shapes;
    result.shapes = CurvedShapes(shapes.order() + 1);
    result.shapes.vertices = shapes.vertices;
    const Lattice& low = Lattice::of(2, shapes.order());
    const Lattice& high = Lattice::of(2, shapes.order() + 1);
    std::vector<Vec3> control;
    for (const Corners& v : faces_of(surface, tetrahedra)) {
        bool bent = shapes.has_face(v);
        for (std::size_t k = 0; k < 3; ++k) {
            const Corners turned{v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
            if (shapes.has_edge(turned[0], turned[1])) {
                bent = true;
                shapes.triangle(turned, control);
                const std::vector<Vec3> all = elements::raised_to(high.degree(), low, control);
                std::vector<Vec3> edge;
                for (int m = 1; m < high.degree(); ++m) {
                    edge.push_back(all[static_cast<std::size_t>(high.index({high.degree() - m, m, 0, 0}))]);
                }
                result.shapes.set_edge(turned[0], turned[1], edge);
            }
        }
        // Blending a triangle from its edges reproduces quadratic triangles.
        if (bent && (shapes.order() > 2 || shapes.has_face(v))) {
            shapes.triangle(v, control);
            result.shapes.set_inside(v, elements::raised_to(high.degree(), low, control));
        }
    }
    return result;
}

std::size_t place_where_valid(SurfaceEditor& editor, TetrahedralMesh* volume, const Progress& progress) {
    return Placing(editor, volume).run(progress);
}

}  // namespace mq::given

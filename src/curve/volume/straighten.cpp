// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/straighten.h"

#include <algorithm>

namespace mq::curve {

namespace {

template <std::size_t N>
void make_straight(elements::CurvedShapes& shapes, const std::array<int, N>& v) {
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t k = i + 1; k < N; ++k) {
            shapes.forget_edge(v[i], v[k]);
            for (std::size_t m = k + 1; m < N; ++m) {
                shapes.forget_face({v[i], v[k], v[m]});
            }
        }
    }
}

void measure_around(SurfaceEditor& editor, const std::set<int>& vertices) {
    std::set<int> triangles;
    for (const int v : vertices) {
        const std::vector<int>& at = editor.surface.triangles_of_vertex(v);
        triangles.insert(at.begin(), at.end());
    }
    editor.placement.measure({triangles.begin(), triangles.end()});
}

}  // namespace

std::set<int> straighten_triangles(SurfaceEditor& editor) {
    std::set<int> done;
    for (std::set<int> vertices;; vertices.clear()) {
        for (std::size_t t = 0; t < editor.surface.triangles.size(); ++t) {
            const SurfaceTriangle& triangle = editor.surface.triangles[t];
            if (triangle.alive && !(triangle.quality > 0.0) && done.insert(static_cast<int>(t)).second) {
                make_straight(editor.surface.shapes, triangle.corners);
                vertices.insert(triangle.corners.begin(), triangle.corners.end());
            }
        }
        if (vertices.empty()) {
            return done;
        }
        measure_around(editor, vertices);
    }
}

std::set<int> straighten_tetrahedra(TetrahedralMesh& volume, SurfaceEditor& editor) {
    std::set<int> done;
    for (std::set<int> vertices;; vertices.clear()) {
        for (const int t : volume.live_tetrahedra()) {
            const Tetrahedron& tetrahedron = volume.tetrahedra[static_cast<std::size_t>(t)];
            if (!(tetrahedron.quality > 0.0) && done.insert(t).second) {
                make_straight(volume.shapes(), tetrahedron.corners);
                vertices.insert(tetrahedron.corners.begin(), tetrahedron.corners.end());
            }
        }
        if (vertices.empty()) {
            return done;
        }
        for (const int v : vertices) {
            volume.measure(volume.of_vertex(v));
        }
        measure_around(editor, vertices);
    }
}

}  // namespace mq::curve

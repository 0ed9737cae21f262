// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/tetrahedral_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/surface/self_intersections.h"
#include "curve/volume/tuning.h"
#include "elements/bezier/validity.h"
#include "tetrahedralise/tetrahedralise.h"

namespace mq::curve {

using elements::CurvedShapes;
using elements::face_key;

TetrahedralMesh::TetrahedralMesh(CurvedSurface& given) : surface(given) {
    for (const SurfaceTriangle& t : surface.triangles) {
        if (!t.alive) {
            continue;
        }
        fixed_faces_.insert(face_key(t.corners[0], t.corners[1], t.corners[2]));
        for (std::size_t k = 0; k < 3; ++k) {
            fixed_edges_.insert(pair_key(t.corners[k], t.corners[(k + 1) % 3]));
        }
    }
    stars_.resize(surface.shapes.vertices.size());
}

TetrahedralMesh::TetrahedralMesh(CurvedSurface& given, const std::vector<Tetrahedron>& kept) : TetrahedralMesh(given) {
    for (const Tetrahedron& t : kept) {
        if (t.alive) {
            tetrahedra[static_cast<std::size_t>(add(t.corners, t.volume))].quality = t.quality;
        }
    }
}

int TetrahedralMesh::add(const std::array<int, 4>& corners, int volume) {
    const int index = static_cast<int>(tetrahedra.size());
    Tetrahedron t;
    t.corners = corners;
    t.volume = volume;
    tetrahedra.push_back(t);
    stars_.add(index, corners);
    return index;
}

void TetrahedralMesh::remove(int tetrahedron) {
    Tetrahedron& t = tetrahedra[static_cast<std::size_t>(tetrahedron)];
    t.alive = false;
    stars_.remove(tetrahedron, t.corners);
}

int TetrahedralMesh::add_vertex(const Vec3& point, int volume) {
    const int v = surface.add_vertex({point, {3, volume}});
    stars_.resize(surface.shapes.vertices.size());
    return v;
}

double TetrahedralMesh::straight_jacobian(const std::array<int, 4>& c) const {
    return (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0])).dot(point(c[3]) - point(c[0]));
}

double TetrahedralMesh::squared_edges(const std::array<int, 4>& c) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = i + 1; k < 4; ++k) {
            squares += (point(c[i]) - point(c[k])).squaredNorm();
        }
    }
    return squares;
}

double TetrahedralMesh::straight_shape(const std::array<int, 4>& c) const {
    // The mean ratio: 12 (3 V)^(2/3) / sum of the squared edges, with 3 V = J / 2.
    const double half = 0.5 * straight_jacobian(c);
    return std::copysign(12.0 * std::cbrt(half * half), half) / squared_edges(c);
}

double TetrahedralMesh::reference_jacobian(const std::array<int, 4>& c) const {
    const double least = 2.0 * std::pow(VolumeTuning::kSliverShape / 12.0 * squared_edges(c), 1.5);
    return std::max(straight_jacobian(c), least);
}

bool TetrahedralMesh::curved(const std::array<int, 4>& c) const {
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = i + 1; k < 4; ++k) {
            if (shapes().has_edge(c[i], c[k])) {
                return true;
            }
        }
    }
    for (std::size_t i = 0; i < 4 && shapes().order() > 2; ++i) {
        if (shapes().has_face({c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4]})) {
            return true;
        }
    }
    return false;
}

double TetrahedralMesh::measure(const std::array<int, 4>& corners) const {
    if (shapes().order() == 1 || !curved(corners)) {
        return straight_jacobian(corners) > 0.0 ? 1.0 : -1.0;
    }
    std::vector<Vec3> control;
    shapes().tetrahedron(corners, control);
    return elements::certified_ratio(elements::jacobian_by_nodes(elements::Lattice::of(3, shapes().order()), control));
}

void TetrahedralMesh::measure(const std::vector<int>& list, const Progress* progress) {
    const auto one = [&](int i) {
        check_cancelled(progress);
        Tetrahedron& tetrahedron = tetrahedra[static_cast<std::size_t>(list[static_cast<std::size_t>(i)])];
        tetrahedron.quality = measure(tetrahedron.corners);
    };
    for_chunks(static_cast<int>(list.size()), one);
}

std::array<std::array<int, 3>, 4> outward_faces(const std::array<int, 4>& v) {
    return {{{v[1], v[2], v[3]}, {v[0], v[3], v[2]}, {v[0], v[1], v[3]}, {v[0], v[2], v[1]}}};
}

FoldedTriangles::FoldedTriangles(const CurvedSurface& surface) {
    for (const SurfaceTriangle& t : surface.triangles) {
        if (t.alive && !(t.quality > 0.0)) {
            folded_.insert(face_key(t.corners[0], t.corners[1], t.corners[2]));
        }
    }
}

bool FoldedTriangles::has_face_of(const std::array<int, 4>& v) const {
    return !folded_.empty() && folded_.count(face_key(v[0], v[1], v[2])) + folded_.count(face_key(v[0], v[1], v[3])) +
                                       folded_.count(face_key(v[0], v[2], v[3])) +
                                       folded_.count(face_key(v[1], v[2], v[3])) >
                                   0;
}

std::size_t TetrahedralMesh::invalid() const {
    return static_cast<std::size_t>(std::count_if(tetrahedra.begin(), tetrahedra.end(),
                                                  [](const Tetrahedron& t) { return t.alive && !(t.quality > 0.0); }));
}

std::vector<int> TetrahedralMesh::live_tetrahedra() const {
    std::vector<int> result;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        if (tetrahedra[t].alive) {
            result.push_back(static_cast<int>(t));
        }
    }
    return result;
}

namespace {

/// Outward triangles of one volume, with their own numbering of vertices.
struct Shell {
    std::vector<int> vertices;  // vertices of the surface
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
    tetrahedralise::EndTangents tangents;
};

/// The tangents of the triangle's curved edges.
void add_tangents(const CurvedShapes& edges, const std::array<int, 3>& corners, Shell& shell) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int from = corners[k];
        const int to = corners[(k + 1) % 3];
        const int a = shell.vertices[static_cast<std::size_t>(from)];
        const int b = shell.vertices[static_cast<std::size_t>(to)];
        if (edges.has_edge(a, b)) {
            const std::vector<Vec3> inner = edges.edge_inner(a, b);
            shell.tangents[tetrahedralise::directed_edge(from, to)] =
                inner.front() - shell.points[static_cast<std::size_t>(from)];
            shell.tangents[tetrahedralise::directed_edge(to, from)] =
                inner.back() - shell.points[static_cast<std::size_t>(to)];
        }
    }
}

Shell shell_of(const CurvedSurface& surface, const CurvedShapes& edges, std::size_t volume) {
    Shell shell;
    std::unordered_map<int, int> number;
    double sum = 0.0;
    for (const auto& [face, flipped] : surface.volume_faces[volume]) {
        for (const SurfaceTriangle& t : surface.triangles) {
            if (!t.alive || t.face != face) {
                continue;
            }
            std::array<int, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                const int v = t.corners[flipped ? 2 - k : k];
                const auto [found, fresh] = number.emplace(v, static_cast<int>(shell.vertices.size()));
                if (fresh) {
                    shell.vertices.push_back(v);
                    shell.points.push_back(surface.shapes.vertices[static_cast<std::size_t>(v)].point);
                }
                corners[k] = found->second;
            }
            const auto at = [&](std::size_t k) -> const Vec3& {
                return shell.points[static_cast<std::size_t>(corners[k])];
            };
            sum += at(0).dot(at(1).cross(at(2)));
            shell.triangles.push_back(corners);
            add_tangents(edges, corners, shell);
        }
    }
    if (sum < 0.0) {
        for (auto& t : shell.triangles) {
            std::swap(t[1], t[2]);
        }
    }
    return shell;
}

/// The error of a filling with the solid and the place.
Message in_solid(std::size_t solid, const Error& error, const std::string& place) {
    return {phrases::kFaultInSolid,
            {{"solid", "Solid" + std::to_string(solid + 1)}, {"phrase", error.message()}, {"value", place}}};
}

}  // namespace

TetrahedralMesh tetrahedralise_solids(CurvedSurface& surface, const CurvedShapes& edges,
                                      const geometry::Topology& topology, const Progress& progress,
                                      const SizeField* field) {
    std::vector<std::size_t> solids;
    for (std::size_t i = 0; i < topology.volumes.size(); ++i) {
        if (topology.volumes[i].kind == geometry::Volume::Kind::Solid) {
            solids.push_back(i);
        }
    }
    struct Filled {
        std::vector<int> vertices;
        tetrahedralise::Tetrahedra filling;
    };
    std::vector<Filled> filled(solids.size());
    parallel_for(static_cast<int>(solids.size()), [&](int k) {
        progress.check();
        const std::size_t solid = solids[static_cast<std::size_t>(k)];
        Shell shell = shell_of(surface, edges, solid);
        Filled& result = filled[static_cast<std::size_t>(k)];
        try {
            result.filling =
                tetrahedralise::tetrahedralise(shell.points, shell.triangles, {1.0, field}, progress, shell.tangents);
        } catch (const tetrahedralise::MeshingFailed& error) {
            throw tetrahedralise::MeshingFailed(
                in_solid(solid, error, first_fault(surface, topology, solid, progress)));
        }
        result.vertices = std::move(shell.vertices);
    });
    TetrahedralMesh volume(surface);
    for (std::size_t k = 0; k < solids.size(); ++k) {
        const int solid = static_cast<int>(solids[k]);
        auto& [number, filling] = filled[k];
        for (const Vec3& p : filling.inner_points) {
            number.push_back(volume.add_vertex(p, solid));
        }
        for (const auto& t : filling.tetrahedra) {
            const auto at = [&](std::size_t corner) { return number[static_cast<std::size_t>(t[corner])]; };
            volume.add({at(0), at(1), at(2), at(3)}, solid);
        }
    }
    return volume;
}

}  // namespace mq::curve

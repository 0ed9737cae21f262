// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/measure_given.h"

#include <algorithm>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/surface/node_placement.h"
#include "elements/product/reference_nodes.h"
#include "given/matching/matching.h"

namespace mq::given {

using elements::Lattice;

namespace {

/// The corners of the curved triangles as a given mesh.
GivenMesh corners_of(const std::vector<Vec3>& nodes, const std::vector<std::int32_t>& triangles, std::size_t width) {
    GivenMesh mesh;
    mesh.nodes = nodes;
    for (std::size_t first = 0; first + 2 < triangles.size(); first += width) {
        mesh.triangles.push_back({triangles[first], triangles[first + 1], triangles[first + 2]});
    }
    return mesh;
}

/// Gives the edges and the inside of a mesh triangle the shapes that the nodes of one given triangle define.
/// @param corners  vertices of the surface
void set_shapes(elements::CurvedShapes& shapes, const std::array<int, 3>& corners, const std::vector<Vec3>& given) {
    const Lattice& lattice = Lattice::of(2, shapes.order());
    const std::vector<Vec3> control = elements::gmsh_to_bezier(lattice, given);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        std::vector<Vec3> inner;
        for (int i = 1; i < shapes.order(); ++i) {
            elements::Exponents e{};
            e[k] = shapes.order() - i;
            e[next] = i;
            inner.push_back(control[static_cast<std::size_t>(lattice.index(e))]);
        }
        shapes.set_edge(corners[k], corners[next], inner);
    }
    shapes.set_inside(corners, control);
}

}  // namespace

GivenSurfaceMeasures measure_given_surface(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                                           const std::vector<Vec3>& nodes, int order,
                                           const std::vector<std::int32_t>& triangles, Progress* progress) {
    if (order < 1 || order > elements::kMaxOrder) {
        throw InvalidInput(phrases::kElementOrder, {{"count", elements::kMaxOrder}, {"count2", order}});
    }
    const auto width = static_cast<std::size_t>(Lattice::of(2, order).size());
    GivenMesh mesh = corners_of(nodes, triangles, width);
    require_sound(mesh);
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    geometry::Session session(engine, model, &watched);
    watched.stage("classifying", 0.0, 0.3);
    MatchedMesh matched = match_bodies(session, mesh, order);
    curve::CurvedSurface& surface = matched.surface;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (matched.vertex_of_node[n] >= 0) {
            surface.shapes.vertices[static_cast<std::size_t>(matched.vertex_of_node[n])].point =
                nodes[static_cast<std::size_t>(matched.given_node[n])];
        }
    }
    std::vector<Vec3> own(width);
    for (std::size_t t = 0; t < mesh.triangles.size() && order > 1; ++t) {
        std::array<int, 3> corners{};
        for (std::size_t i = 0; i < width; ++i) {
            own[i] = nodes[static_cast<std::size_t>(triangles[t * width + i])];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = matched.vertex_of_node[static_cast<std::size_t>(mesh.triangles[t][k])];
        }
        set_shapes(surface.shapes, corners, own);
    }
    watched.stage("measuring the distance", 0.3, 1.0);
    curve::Placement placement(session, surface);
    GivenSurfaceMeasures result;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        watched.check();
        const int index = static_cast<int>(t);
        placement.measure({index});
        const std::vector<double> distances = placement.deviations({index});
        result.face.push_back(session.topology().of_shape({2, surface.triangles[t].face}).index);
        result.quality.push_back(surface.triangles[t].quality);
        result.deviation.push_back(distances.empty() ? 0.0 : *std::max_element(distances.begin(), distances.end()));
    }
    return result;
}

}  // namespace mq::given

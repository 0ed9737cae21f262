// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/enclosed_volume.h"

#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "elements/bezier/jacobian.h"

namespace mq::curve {

namespace {

/// By CAD face: the volume of the cone from `apex` to its triangles.
std::vector<double> cones_of_faces(const CurvedSurface& surface, std::size_t faces, const Vec3& apex,
                                   const Progress& progress) {
    const elements::Lattice& lattice = elements::Lattice::of(2, surface.shapes.order());
    std::vector<double> of_triangles(surface.triangles.size(), 0.0);
    for_chunks(static_cast<int>(of_triangles.size()), [&](int t) {
        const auto k = static_cast<std::size_t>(t);
        if (!surface.triangles[k].alive) {
            return;
        }
        progress.check();
        std::vector<Vec3> control;
        surface.shapes.triangle(surface.triangles[k].corners, control);
        for (Vec3& point : control) {
            point -= apex;
        }
        // The reference triangle has area 1/2; the mean of the coefficients is that of the polynomial.
        const std::vector<double> flux =
            elements::normal_component(lattice, control, elements::bezier_to_nodes(lattice, control)).coefficients;
        of_triangles[k] = std::accumulate(flux.begin(), flux.end(), 0.0) / (6.0 * static_cast<double>(flux.size()));
    });
    std::vector<double> cones(faces, 0.0);
    for (std::size_t t = 0; t < of_triangles.size(); ++t) {
        cones[static_cast<std::size_t>(surface.triangles[t].face)] += of_triangles[t];
    }
    return cones;
}

}  // namespace

double enclosed_volume(const CurvedSurface& surface, const geometry::Topology& topology, const Progress& progress) {
    const std::vector<double> cones = cones_of_faces(surface, topology.faces.size(), topology.box.center(), progress);
    double sum = 0.0;
    for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
        if (topology.volumes[v].kind == geometry::Volume::Kind::Solid) {
            double solid = 0.0;
            for (const auto& [face, flipped] : surface.volume_faces[v]) {
                solid += (flipped ? -1.0 : 1.0) * cones[static_cast<std::size_t>(face)];
            }
            sum += std::abs(solid);
        }
    }
    return sum;
}

}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/surface_alignment.h"

#include <algorithm>

namespace mq::triangulate {

Corner corner_of(const ClassifiedMesh& mesh, int site) {
    const auto& s = mesh.site(site);
    return {s.point, s.normal};
}

double alignment(const Corner& a, const Corner& b, const Corner& c) {
    const Vec3 normal = (b.point - a.point).cross(c.point - a.point);
    const double length = normal.norm();
    if (!(length > 0.0)) {
        return -1.0;
    }
    double least = length;
    bool singular = false;
    for (const Corner* corner : {&a, &b, &c}) {
        if (corner->normal.squaredNorm() > 0.0) {
            least = std::min(least, normal.dot(corner->normal));
        } else {
            singular = true;
        }
    }
    const double worst = least / length;
    // Around the apex of a slender cone there is room for at most four triangles of 25 degrees, so that the normal of
    // each has to deviate far from the surface at its other corners.
    return singular && worst > kAlignedAtApex ? std::max(worst, kWellAligned) : worst;
}

double alignment(const ClassifiedMesh& mesh, int triangle) {
    const int h = 3 * triangle;
    return alignment(corner_of(mesh, mesh.site_of(h)), corner_of(mesh, mesh.site_of(h + 1)),
                     corner_of(mesh, mesh.site_of(h + 2)));
}

int most_turned_side(const ClassifiedMesh& mesh, int triangle) {
    int best = 3 * triangle;
    double least = 2.0;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const Vec3& a = mesh.site(mesh.site_of(h)).normal;
        const Vec3& b = mesh.site(mesh.site_of(ClassifiedMesh::next(h))).normal;
        if (a.dot(b) < least) {
            least = a.dot(b);
            best = h;
        }
    }
    return best;
}

}  // namespace mq::triangulate

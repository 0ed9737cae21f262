// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/fill.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace nglib {
#include <netgen/nglib.h>
}
namespace netgen {
// How much Netgen prints to the standard output; not in its public header.
extern int printmessage_importance;
}  // namespace netgen

namespace mq::curve {

namespace {

std::mutex& netgen_in_use() {
    static std::mutex mutex;
    return mutex;
}

/// Netgen's own state, up while a filling lasts.
class Netgen {
  public:
    Netgen() : lock_(netgen_in_use()) {
        nglib::Ng_Init();
        netgen::printmessage_importance = 0;
        mesh_ = nglib::Ng_NewMesh();
    }
    ~Netgen() {
        nglib::Ng_DeleteMesh(mesh_);
        nglib::Ng_Exit();
    }
    Netgen(const Netgen&) = delete;
    Netgen& operator=(const Netgen&) = delete;

    nglib::Ng_Mesh* mesh() const { return mesh_; }

  private:
    std::lock_guard<std::mutex> lock_;
    nglib::Ng_Mesh* mesh_ = nullptr;
};

Vec3 point_of(const Netgen& netgen, int i) {
    double x[3];
    nglib::Ng_GetPoint(netgen.mesh(), i + 1, x);
    return {x[0], x[1], x[2]};
}

double box_product(const std::array<Vec3, 4>& p) {
    return (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
}

Filling read_back(const Netgen& netgen, const std::vector<Vec3>& points) {
    Filling filling;
    const auto given = static_cast<int>(points.size());
    for (int i = 0; i < nglib::Ng_GetNP(netgen.mesh()); ++i) {
        const Vec3 p = point_of(netgen, i);
        if (i >= given) {
            filling.inner_points.push_back(p);
        } else if (p != points[static_cast<std::size_t>(i)]) {
            throw GeometryError("the tetrahedral mesher moved a vertex of the surface");
        }
    }
    const auto at = [&](int v) -> const Vec3& {
        return v < given ? points[static_cast<std::size_t>(v)]
                         : filling.inner_points[static_cast<std::size_t>(v - given)];
    };
    for (int i = 0; i < nglib::Ng_GetNE(netgen.mesh()); ++i) {
        int v[NG_VOLUME_ELEMENT_MAXPOINTS];
        nglib::Ng_GetVolumeElement(netgen.mesh(), i + 1, v);
        std::array<int, 4> corners{v[0] - 1, v[1] - 1, v[2] - 1, v[3] - 1};
        if (box_product({at(corners[0]), at(corners[1]), at(corners[2]), at(corners[3])}) < 0.0) {
            std::swap(corners[2], corners[3]);
        }
        filling.tetrahedra.push_back(corners);
    }
    return filling;
}

}  // namespace

Filling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles) {
    const Netgen netgen;
    for (const Vec3& p : points) {
        double x[3] = {p.x(), p.y(), p.z()};
        nglib::Ng_AddPoint(netgen.mesh(), x);
    }
    for (const auto& t : triangles) {
        int v[3] = {t[0] + 1, t[1] + 1, t[2] + 1};
        nglib::Ng_AddSurfaceElement(netgen.mesh(), nglib::NG_TRIG, v);
    }
    nglib::Ng_Meshing_Parameters parameters;
    parameters.maxh = 1e30;
    std::string why = "no reason given";
    try {
        if (nglib::Ng_GenerateVolumeMesh(netgen.mesh(), &parameters) == nglib::NG_OK &&
            nglib::Ng_GetNE(netgen.mesh()) > 0) {
            return read_back(netgen, points);
        }
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {  // Netgen's own
        why = error.what();
    }
    throw CannotFill("the surface could not be filled with tetrahedra (" + why +
                     "): it meets itself, or walls are too thin for its triangles; ask for a smaller chord height");
}

}  // namespace mq::curve

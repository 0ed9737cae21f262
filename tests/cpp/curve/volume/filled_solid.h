// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp_Ax1.hxx>
#include <memory>
#include <numeric>
#include <vector>

#include "curve/checks.h"
#include "curve/surface/editor.h"
#include "curve/volume/editor.h"
#include "curve/volume/remeshing/tetrahedralise_and_repair.h"
#include "geometry/occt/shape_model.h"
#include "tetrahedralise/cells/tetrahedra.h"

namespace mq::curve {

/// A sector of a thin tube: radii 1 - thickness and 1, height 1, about z.
inline TopoDS_Shape thin_wall_shape(double thickness, double angle) {
    BRepBuilderAPI_MakePolygon profile;
    for (const auto& [r, z] : {std::pair{1.0 - thickness, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {1.0 - thickness, 1.0}}) {
        profile.Add(gp_Pnt(r, 0.0, z));
    }
    profile.Close();
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(profile.Wire(), Standard_True).Shape();
    return BRepPrimAPI_MakeRevol(face, gp_Ax1(gp::Origin(), gp::DZ()), angle).Shape();
}

inline std::shared_ptr<geometry::Model> thin_wall(double thickness, double angle) {
    return geometry::make_shape_model(thin_wall_shape(thickness, angle));
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
        for (const int t : volume.live_tetrahedra()) {
            sum += volume.straight_jacobian(volume.tetrahedra[static_cast<std::size_t>(t)].corners) / 6.0;
        }
        return sum;
    }
    double least_straight() const {
        double least = 1e300;
        for (const int t : volume.live_tetrahedra()) {
            least = std::min(least, volume.straight_jacobian(volume.tetrahedra[static_cast<std::size_t>(t)].corners));
        }
        return least;
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session;
    CurvedSurface surface;
    SurfaceEditor surface_editor;
    Progress progress;
    TetrahedralMesh volume;
    VolumeEditor editor;

  private:
    static mesh::TriangleMesh straight_mesh(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model) {
        triangulate::TriangulateOptions options;
        options.max_edge = 0.7;
        return triangulate::triangulate(engine, model, options).mesh;
    }
    TetrahedralMesh filled() {
        std::vector<int> all(surface.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        surface_editor.placement.place(all);
        return tetrahedralise_solids(surface, surface.shapes, session.topology(), progress);
    }
};

}  // namespace mq::curve

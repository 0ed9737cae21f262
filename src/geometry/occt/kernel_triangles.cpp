// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/kernel_triangles.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <map>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/failure_text.h"

namespace mq::geometry {

KernelTriangles kernel_triangles(const TopoDS_Shape& face, double distance) {
    KernelTriangles found;
    try {
        // In single precision, as FreeCAD asks for it.
        const BRepMesh_IncrementalMesh mesher(face, static_cast<double>(static_cast<float>(distance)));
        TopLoc_Location location;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(face), location);
        if (mesh.IsNull()) {
            return found;
        }
        // Nodes on a seam are there twice.
        std::map<std::array<double, 3>, std::int32_t> numbers;
        std::vector<std::int32_t> number_of;
        for (int i = 1; i <= mesh->NbNodes(); ++i) {
            const Vec3 p = to_vec(mesh->Node(i).Transformed(location.Transformation()));
            const auto [at, is_new] =
                numbers.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, static_cast<std::int32_t>(numbers.size()));
            number_of.push_back(at->second);
            if (is_new) {
                found.vertices.push_back(p);
            }
        }
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            std::array<int, 3> corners;
            mesh->Triangle(i).Get(corners[0], corners[1], corners[2]);
            if (face.Orientation() == TopAbs_REVERSED) {
                std::swap(corners[0], corners[1]);
            }
            std::array<std::int32_t, 3> triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                triangle[k] = number_of[static_cast<std::size_t>(corners[k]) - 1];
            }
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
                found.triangles.push_back(triangle);
            }
        }
    } catch (const Standard_Failure& failure) {
        throw GeometryError(phrases::kKernelFails, {{"text", failure_text(failure)}});
    }
    return found;
}

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/shape_measures.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    return parts;
}

GeometryError failed(const char* work, const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    return GeometryError(std::string("OpenCASCADE cannot ") + work + ": " + (text != nullptr ? text : ""));
}

}  // namespace

std::shared_ptr<const TopoDS_Shape> kept(const TopoDS_Shape& shape) {
    return std::make_shared<TopoDS_Shape>(shape);
}

Box box_of(const TopoDS_Shape& shape) {
    Bnd_Box bounds;
    try {
        BRepBndLib::Add(shape, bounds, false);
    } catch (const Standard_Failure& failure) {
        throw failed("find the box of the shape", failure);
    }
    Box box;
    if (!bounds.IsVoid()) {
        bounds.SetGap(0.0);
        box.add(to_vec(bounds.CornerMin()));
        box.add(to_vec(bounds.CornerMax()));
    }
    return box;
}

std::vector<double> mean_thicknesses(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape bodies = parts_of(shape, TopAbs_SOLID);
    if (bodies.IsEmpty()) {
        bodies.Add(shape);
    }
    std::vector<double> found;
    try {
        for (int i = 1; i <= bodies.Extent(); ++i) {
            GProp_GProps content;
            GProp_GProps skin;
            BRepGProp::VolumeProperties(bodies(i), content);
            BRepGProp::SurfaceProperties(bodies(i), skin);
            const double thickness = 2.0 * std::abs(content.Mass()) / skin.Mass();
            if (skin.Mass() != 0.0 && thickness > 0.0) {
                found.push_back(thickness);
            }
        }
    } catch (const Standard_Failure& failure) {
        throw failed("measure the volume and the area of the shape", failure);
    }
    return found;
}

std::size_t face_count(const TopoDS_Shape& shape) {
    return static_cast<std::size_t>(parts_of(shape, TopAbs_FACE).Extent());
}

std::shared_ptr<const TopoDS_Shape> copied_face(const TopoDS_Shape& shape, std::size_t face) {
    return std::make_shared<TopoDS_Shape>(
        BRepBuilderAPI_Copy(parts_of(shape, TopAbs_FACE)(static_cast<int>(face) + 1)).Shape());
}

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
        throw failed("triangulate the face", failure);
    }
    return found;
}

}  // namespace mq::geometry

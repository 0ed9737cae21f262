// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/repair.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Trsf.hxx>

#include "base/parallel.h"
#include "curve/files.h"
#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

TEST(RepairTetrahedralMesh, ThinWallsBecomeValid) {
    for (const double thickness : {0.1, 0.04}) {
        for (int order = 2; order <= 4; ++order) {
            const CurvedMesh mesh = curved(thin_wall(thickness, 0.5 * M_PI), of_order(order, true));
            EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << thickness << " " << order << "\n" << to_text(mesh.report);
            EXPECT_EQ(mesh.report.invalid, 0u);
            EXPECT_GT(mesh.report.min_distortion, 0.1);
            const double inner = 1.0 - thickness;
            EXPECT_NEAR(mesh.report.volume, 0.25 * M_PI * (1.0 - inner * inner), 1e-3);
            expect_conforming(mesh);
        }
    }
}

TEST(RepairTetrahedralMesh, ThereIsSomethingToRepair) {
    EXPECT_GT(curved(thin_wall(0.02, 0.5 * M_PI), of_order(2, true)).report.invalid_before, 0u);
}

/// Hollow balls beside each other.
std::shared_ptr<geometry::Model> shells(int count) {
    const TopoDS_Shape one =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(1.0).Shape(), BRepPrimAPI_MakeSphere(0.9).Shape()).Shape();
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < count; ++i) {
        gp_Trsf aside;
        aside.SetTranslation(gp_Vec(3.0 * i, 0.0, 0.0));
        builder.Add(all, one.Moved(aside));
    }
    return geometry::make_shape_model(all);
}

VolumeRepairs repaired(const std::shared_ptr<geometry::Model>& model, int order) {
    Filled filled(model, order);
    return repair_volume(filled.volume, filled.progress);
}

TEST(RepairTetrahedralMesh, WorkGrowsWithWhatIsInvalid) {
    // Jacobians evaluated for an invalid element at most.
    constexpr double kEach = 1000.0;
    for (int order = 2; order <= 3; ++order) {
        const VolumeRepairs one = repaired(shells(1), order);
        const VolumeRepairs four = repaired(shells(4), order);
        EXPECT_GT(one.invalid_before, 0);
        EXPECT_GT(one.evaluations, 0U);
        EXPECT_LT(static_cast<double>(one.evaluations), kEach * one.invalid_before) << order;
        EXPECT_LT(static_cast<double>(four.evaluations), kEach * four.invalid_before)
            << order << " " << one.evaluations << " " << one.invalid_before;
    }
}

TEST(RepairTetrahedralMesh, IsTheSameForAnyNumberOfThreads) {
    for (int order = 2; order <= 3; ++order) {
        const auto with = [&](int threads) {
            const ThreadLimit limit(threads);
            return curved(shells(4), of_order(order, true));
        };
        const CurvedMesh one = with(1);
        EXPECT_GT(one.report.invalid_before, 0U);
        for (const int threads : {2, 3, 8}) {
            const CurvedMesh several = with(threads);
            EXPECT_EQ(to_msh(several), to_msh(one)) << order << " " << threads;
            EXPECT_EQ(several.report.repairs, one.report.repairs) << order << " " << threads;
            EXPECT_EQ(several.tetrahedron_quality, one.tetrahedron_quality) << order << " " << threads;
        }
    }
}

/// Six tetrahedra beside each other, of which all but the first one are open, as solids.
struct OpenSolids {
    OpenSolids() : surface(2) {
        topology.faces.resize(6);
        topology.volumes.resize(6);
        for (int i = 0; i < 6; ++i) {
            std::array<int, 4> v{};
            for (std::size_t k = 0; k < 4; ++k) {
                v[k] = surface.add_vertex({Vec3(2.0 * i + (k == 1 ? 1.0 : 0.0), k == 2, k == 3), {2, i}});
            }
            surface.add_triangle({v[0], v[2], v[1]}, i);
            surface.add_triangle({v[0], v[1], v[3]}, i);
            surface.add_triangle({v[1], v[2], v[3]}, i);
            if (i == 0) {
                surface.add_triangle({v[0], v[3], v[2]}, i);
            }
            surface.volume_faces.push_back({{i, false}});
            topology.volumes[static_cast<std::size_t>(i)].kind = geometry::Volume::Kind::Solid;
        }
    }

    TetrahedralMesh fill(const Progress& progress) {
        return tetrahedralise_solids(surface, surface.shapes, topology, progress);
    }

    CurvedSurface surface;
    geometry::Topology topology;
};

TEST(TetrahedraliseSolids, TheFirstSolidThatCannotBeFilledIsNamed) {
    OpenSolids solids;
    for (const int threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        try {
            solids.fill(Progress());
            FAIL() << "nothing was thrown";
        } catch (const tetrahedralise::MeshingFailed& error) {
            EXPECT_NE(std::string(error.what()).find("Solid2"), std::string::npos) << error.what();
        }
    }
}

TEST(TetrahedralMesh, AFlatElementIsToHaveTheJacobianOfOneThatIsNot) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape()), 2);
    std::vector<elements::Vertex>& vertices = filled.volume.shapes().vertices;
    const std::array<int, 4> corners = filled.volume.tetrahedra.front().corners;
    const auto place = [&](std::size_t k) -> Vec3& { return vertices[static_cast<std::size_t>(corners[k])].point; };
    place(0) = Vec3::Zero();
    place(1) = Vec3::UnitX();
    place(2) = Vec3::UnitY();
    place(3) = Vec3::UnitZ();
    EXPECT_DOUBLE_EQ(filled.volume.reference_jacobian(corners), 1.0);
    // Squared edges of 1, 1, 2, 0.5, 0.5, 0.5 and a mean ratio of 0.05.
    place(3) = Vec3(0.5, 0.5, 1e-9);
    EXPECT_NEAR(filled.volume.reference_jacobian(corners), 2.0 * std::pow(0.05 / 12.0 * 5.5, 1.5), 1e-9);
}

TEST(RepairTetrahedralMesh, CancelledAtOnce) {
    for (const int threads : {1, 3}) {
        const ThreadLimit limit(threads);
        Filled filled(shells(1), 3);
        filled.progress.cancel();
        EXPECT_THROW(repair_volume(filled.volume, filled.progress), Cancelled);
    }
}

}  // namespace
}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/pipeline/assemble.h"

#include <map>

#include "triangulate/checks.h"
#include "triangulate/report/manifold_output.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

TEST(Assemble, GluesTheFacesOfEveryPart) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        const Pipeline pipeline(part.model);
        const ClassifiedMesh& mesh = pipeline.surface;
        EXPECT_EQ(mesh.inconsistency(), "");
        const geometry::Topology& topology = part.model->topology();
        std::set<int> faces;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            faces.insert(mesh.face_of(t));
        }
        EXPECT_EQ(faces.size(), topology.faces.size());
        for (int s = 0; s < mesh.segment_count(); ++s) {
            const ClassifiedMesh::Segment& segment = mesh.segment(s);
            EXPECT_EQ(segment.uses.size(), topology.edges[segment.edge].uses.size());
            for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
                EXPECT_EQ(topology.uses[use.use].edge, segment.edge);
                EXPECT_EQ(topology.uses[use.use].face, mesh.face_of(use.half_edge / 3));
            }
        }
    }
}

/// Written out without refinement, S_C already has the topology of the shape.
TEST(Assemble, HasTheTopologyOfThePart) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        const Pipeline pipeline(part.model);
        const Output out = write_out(pipeline.surface, part.model->topology(), pipeline.grid.origin(), Progress());
        const mesh::MeshReport report = mesh::measure(out.mesh);
        EXPECT_EQ(report.euler, part.euler);
        EXPECT_EQ(report.closed, part.closed);
        EXPECT_TRUE(report.oriented);
        EXPECT_EQ(report.components, part.model->topology().volumes.size());
        ASSERT_EQ(out.source.size(), out.mesh.triangles.size());
        for (std::size_t i = 0; i < out.source.size(); ++i) {
            EXPECT_EQ(out.mesh.triangle_face[i], pipeline.surface.face_of(out.source[i]));
        }
    }
}

TEST(Assemble, AFaceBetweenTwoSolidsComesTwice) {
    const auto model = geometry::make_shape_model(geometry::twin_solids());
    const Pipeline pipeline(model);
    const Output out = write_out(pipeline.surface, model->topology(), pipeline.grid.origin(), Progress());
    std::map<int, int> times;
    for (const int t : out.source) {
        ++times[t];
    }
    std::set<int> shared;
    for (const auto& [t, count] : times) {
        EXPECT_LE(count, 2);
        if (count == 2) {
            shared.insert(pipeline.surface.face_of(t));
        }
    }
    EXPECT_EQ(shared.size(), 1u);
}

}  // namespace
}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Files with patches, by their texts; tests/freecad/test_exchange.py has other programs read them.

#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/io/io.h"
#include "mesh/io/io_formats.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;

/// Four triangles in two patches.
ExportMesh patched(double scale = 1.0) {
    Patches patches;
    patches.groups = {{"inlet", {255, 0, 128}}, {"walls", {0, 0, 255}}};
    patches.of_triangle = {1, 0, 1, 1};
    patches.given = true;
    return exported(tetrahedron(), patches, scale);
}

/// The corners of a tetrahedron, filled by one of order 1.
ExportMesh filled() {
    ExportMesh mesh = patched();
    mesh.blocks.push_back({&element_type("tetrahedron", 4), {0, 1, 2, 3}, {0}, {0}, {}});
    mesh.groups[3] = {{"Solid1"}};
    return mesh;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
    std::size_t at = 0;
    for (const std::string& part : parts) {
        const std::size_t found = text.find(part, at);
        ASSERT_NE(found, std::string::npos) << "'" << part << "' is missing, or in another place, in\n" << text;
        at = found + part.size();
    }
}

TEST(PatchFormats, StlHasOneSolidAPatch) {
    expect_parts(text_of(to_stl_text, patched()),
                 {"solid inlet\nfacet normal ", "outer loop\nvertex 0 0 0\n", "endloop\nendfacet\n",
                  "endsolid inlet\nsolid walls\n", "endsolid walls\n"});
    const std::string binary = text_of(to_stl, patched());
    EXPECT_EQ(binary[84 + 48], 1);
    EXPECT_EQ(binary[84 + 50 + 48], 0);
    EXPECT_EQ(text_of(to_stl, exported(tetrahedron()))[84 + 48], 0);
}

TEST(PatchFormats, ObjAndPly) {
    expect_parts(text_of(to_obj, patched()), {"g inlet\nf 1 2 4\n", "g walls\nf 1 3 2\n"});
    const std::string ply = text_of(to_ply, patched());
    expect_parts(
        ply, {"comment patch 0 inlet\ncomment patch 1 walls\n", "property int face\nproperty int patch\nend_header\n"});
    const std::size_t body = ply.find("end_header\n") + 11;
    EXPECT_EQ(ply.size(), body + 4 * 12 + 4 * 21);
}

TEST(PatchFormats, GmshHasAPhysicalGroupAPatch) {
    expect_parts(text_of(to_msh, patched()), {"$PhysicalNames\n2\n2 1 \"inlet\"\n2 2 \"walls\"\n$EndPhysicalNames\n",
                                              "$Entities\n0 0 4 0\n1 0 0 0 1 1 0 1 2 0\n"});
    expect_parts(text_of(to_msh2, filled()),
                 {"2.2 0 8\n", "$PhysicalNames\n3\n2 1 \"inlet\"\n2 2 \"walls\"\n3 1 \"Solid1\"\n",
                  "$Elements\n5\n1 2 2 2 1 1 3 2\n", "5 4 2 1 1 1 2 3 4\n"});
}

TEST(PatchFormats, Su2) {
    expect_parts(text_of(to_su2, filled()),
                 {"NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0 0\n1 0 0 1\n", "NMARK= 2\nMARKER_TAG= inlet\n",
                  "MARKER_ELEMS= 1\n5 0 1 3\nMARKER_TAG= walls\nMARKER_ELEMS= 3\n"});
}

TEST(PatchFormats, Cart3dNumbersComponentsFromOne) {
    expect_parts(text_of(to_tri, patched(0.5)), {"4 4\n0 0 0\n0.5 0 0\n", "1 3 2\n1 2 4\n", "\n2\n1\n2\n2\n"});
}

TEST(PatchFormats, NastranHasLongFieldsAndAPropertyAPatch) {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[1].x() = 0.1f;
    mesh.vertices[2].y() = -1.25e-7;
    const std::string text = text_of(to_nastran, exported(mesh));
    expect_parts(text, {"$ property 1: patch Surface\n", "GRID*                  2                0.10000000149012"});
    for (std::size_t at = text.find("GRID*"); at != std::string::npos; at = text.find("GRID*", at + 1)) {
        EXPECT_EQ(text.find('\n', at) - at, 72u);
    }
    expect_parts(text, {"-1.25e-07", "CTRIA3         1       1       1       3       2\n"});
    expect_parts(
        text_of(to_nastran, filled()),
        {"$ property 3: solid Solid1\n", "CTETRA         5       3       1       2       3       4\n", "ENDDATA\n"});
}

TEST(PatchFormats, AbaqusHasSetsAndSidesAPatch) {
    expect_parts(text_of(to_abaqus, patched()),
                 {"*NODE\n1, 0, 0, 0\n", "*ELEMENT, TYPE=S3, ELSET=inlet\n2,1,2,4\n",
                  "*ELEMENT, TYPE=S3, ELSET=walls\n1,1,3,2\n", "*NSET, NSET=inlet\n1, 2, 4\n"});
    // Triangle 2 has corners 1, 2, 4: side 2 of the tetrahedron 1, 2, 3, 4.
    expect_parts(text_of(to_abaqus, filled()),
                 {"*ELEMENT, TYPE=C3D4, ELSET=Solid1\n1,1,2,3,4\n", "*ELSET, ELSET=inlet\n1\n",
                  "*SURFACE, NAME=inlet_surface, TYPE=ELEMENT\n1, S2\n"});
    EXPECT_EQ(text_of(to_abaqus, filled()).find("TYPE=S3"), std::string::npos) << "a volume has no shells";
}

TEST(PatchFormats, UnvHasGroups) {
    expect_parts(text_of(to_unv, filled()),
                 {"    -1\n  2411\n         1         1         1        11\n", "   0.0000000000000000E+00",
                  "    -1\n    -1\n  2412\n",
                  "         1        91         2         1         7         3\n         1         3",
                  "         5       111         3         1         7         4\n", "  2467\n", "inlet\n", "walls\n",
                  "Solid1\n", "    -1\n"});
}

TEST(PatchFormats, FoamEdgesAndCfMesh) {
    expect_parts(text_of(to_emesh, patched()), {"class       featureEdgeMesh;", "4\n(\n(0 0 0)\n", "6\n(\n(0 1)\n"});
    expect_parts(text_of(to_fms, patched()),
                 {"2\n(\ninlet wall\nwalls wall\n)\n4\n(\n(0 0 0)\n", "4\n(\n((0 2 1) 1)\n((0 1 3) 0)\n",
                  "6\n(\n(0 1)\n", "0\n(\n)\n0\n(\n)\n2\n(\nsharpEdges 8 6( 0 1 2 3 4 5)\n", "patchBorders 8 3("});
}

TEST(PatchFormats, PrintingHasColoursAPatch) {
    expect_parts(text_of(to_3mf_mesh, patched()),
                 {"<mesh>\n", "<vertex x=\"1\" y=\"0\" z=\"0\"/>\n",
                  "<triangle v1=\"0\" v2=\"2\" v3=\"1\" pid=\"1\" p1=\"1\"/>\n", "</mesh>\n"});
    EXPECT_EQ(text_of(to_3mf_mesh, exported(tetrahedron())).find("pid"), std::string::npos);
    expect_parts(text_of(to_amf, patched(0.001)),
                 {"unit=\"meter\"", "<x>0.001</x>",
                  "<triangle><color><r>0</r><g>0</g><b>1</b></color><v1>0</v1><v2>2</v2><v3>1</v3>"});
}

TEST(PatchFormats, WhatAFormatDoesNotKnowIsRefused) {
    ExportMesh mesh = patched();
    EXPECT_THROW(write(mesh, "/nowhere/mesh.step", "step"), IoError);
    EXPECT_THROW(write(mesh, "/nowhere/mesh.su2", "su2"), IoError);
    mesh.blocks[0].type = &element_type("triangle", 6);
    EXPECT_THROW(write(mesh, "/nowhere/mesh.su2", "su2"), InvalidInput);
}

TEST(PatchFormats, AMeshWithoutTrianglesIsWritten) {
    const ExportMesh empty = exported(TriangleMesh());
    for (const auto writer :
         {to_stl_text, to_tri, to_emesh, to_fms, to_su2, to_nastran, to_abaqus, to_unv, to_msh2, to_3mf_mesh, to_amf}) {
        EXPECT_FALSE(text_of(writer, empty).empty());
    }
}

}  // namespace
}  // namespace mq::mesh

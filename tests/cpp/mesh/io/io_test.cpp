// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/io.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.h"
#include "mesh/io/io_formats.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using samples::tetrahedron;
using samples::torus;

template <typename T>
T value_at(const std::string& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

TriangleMesh far_tetrahedron() {
    TriangleMesh mesh = tetrahedron();
    mesh.vertices[1].x() = 0.1f;
    mesh.origin = Vec3(1e7, 0, 0);
    return mesh;
}

TEST(Io, StlHoldsEveryTriangleInOrder) {
    const std::string bytes = text_of(to_stl, exported(tetrahedron()));
    ASSERT_EQ(bytes.size(), 84u + 4u * 50u);
    EXPECT_EQ(value_at<std::uint32_t>(bytes, 80), 4u);
    EXPECT_EQ(value_at<float>(bytes, 84 + 8), -1.0f);       // normal of (0, 2, 1) looks down
    EXPECT_EQ(value_at<float>(bytes, 84 + 12 + 16), 1.0f);  // y of its second corner
}

TEST(Io, PlyIsSingleWhereThatIsExactAndDoubleElsewhere) {
    const std::string near = text_of(to_ply, exported(tetrahedron()));
    EXPECT_NE(near.find("property float x"), std::string::npos);
    const std::size_t body = near.find("end_header\n") + 11;
    ASSERT_EQ(near.size(), body + 4 * 12 + 4 * 13);
    EXPECT_EQ(value_at<std::int32_t>(near, body + 48 + 1 + 4), 2);

    const std::string far = text_of(to_ply, exported(far_tetrahedron()));
    EXPECT_NE(far.find("property double x"), std::string::npos);
    EXPECT_EQ(value_at<double>(far, far.find("end_header\n") + 11 + 24), 1e7 + static_cast<double>(0.1f));
}

TEST(Io, TextFormatsKeepAllDigits) {
    const TriangleMesh mesh = far_tetrahedron();
    for (const std::string& text :
         {text_of(to_obj, exported(mesh)), text_of(to_off, exported(mesh)), text_of(to_msh, exported(mesh))}) {
        std::istringstream words(text);
        bool found = false;
        for (std::string word; words >> word;) {
            found = found || std::strtod(word.c_str(), nullptr) == mesh.vertices[1].x() + 1e7;
        }
        EXPECT_TRUE(found) << text;
    }
}

TEST(Io, ObjGroupsByFace) {
    const std::string text = text_of(to_obj, exported(tetrahedron()));
    EXPECT_NE(text.find("g Face3\nf 2 3 4\n"), std::string::npos) << text;
}

TEST(Io, MshHasOneSurfaceAndNameAFace) {
    const std::string text = text_of(to_msh, exported(tetrahedron()));
    EXPECT_EQ(text.rfind("$MeshFormat\n4.1 0 8\n", 0), 0u);
    EXPECT_NE(text.find("$PhysicalNames\n4\n2 1 \"Face1\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("$Entities\n0 0 4 0\n1 0 0 0 1 1 0 1 1 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("$Elements\n4 4 1 4\n2 1 2 1\n1 1 3 2\n"), std::string::npos) << text;
}

TEST(Io, MshWithoutCadHasNoNames) {
    TriangleMesh mesh = tetrahedron();
    mesh.triangle_face.clear();
    const std::string text = text_of(to_msh, exported(mesh));
    EXPECT_EQ(text.find("PhysicalNames"), std::string::npos);
    EXPECT_NE(text.find("$Elements\n1 4 1 4\n2 1 2 4\n"), std::string::npos) << text;
}

TEST(Io, VtuArraysDecode) {
    const std::string text = text_of(to_vtu, exported(tetrahedron()));
    EXPECT_NE(text.find("NumberOfPoints=\"4\" NumberOfCells=\"4\""), std::string::npos);
    // Types: eight bytes of length 4, then 5 5 5 5.
    EXPECT_NE(text.find("Name=\"types\" format=\"binary\">BAAAAAAAAAAFBQUF<"), std::string::npos) << text;
}

TEST(Io, BmsHasNeighboursAcrossEachEdge) {
    const TriangleMesh mesh = torus(16);
    const std::string bytes = to_bms(mesh);
    ASSERT_EQ(bytes.size(), 272 + 12 * mesh.vertices.size() + 24 * mesh.triangles.size() + 24);
    EXPECT_EQ(value_at<std::uint32_t>(bytes, 0), 0xA0B0C0D0u);
    EXPECT_EQ(value_at<std::uint32_t>(bytes, 264), mesh.vertices.size());
    EXPECT_EQ(value_at<std::uint32_t>(bytes, 268), mesh.triangles.size());
    const std::size_t facets = 272 + 12 * mesh.vertices.size();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const auto facet = value_at<std::array<std::int32_t, 6>>(bytes, facets + 24 * k);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(facet[i], mesh.triangles[k][i]);
            const Triangle& other = mesh.triangles.at(facet[3 + i]);
            const int a = facet[i], b = facet[(i + 1) % 3];
            EXPECT_TRUE((other[0] == b && other[1] == a) || (other[1] == b && other[2] == a) ||
                        (other[2] == b && other[0] == a));
        }
    }
}

TEST(Io, BmsOfOpenAndNonManifoldEdgesHasNoNeighbourThere) {
    TriangleMesh mesh = tetrahedron();
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 3}};
    mesh.triangle_face.clear();
    const std::string bytes = to_bms(mesh);
    const auto facet = value_at<std::array<std::uint32_t, 6>>(bytes, 272 + 48);
    EXPECT_EQ(facet[3], 0xFFFFFFFFu);
    EXPECT_EQ(facet[4], 0xFFFFFFFFu);
}

TEST(Io, WriteChoosesByExtensionAndNamesThePathOnFailure) {
    const auto folder = std::filesystem::temp_directory_path() / "meshquality_io_test";
    std::filesystem::create_directories(folder);
    for (const char* name : {"a.stl", "a.PLY", "a.obj", "a.off", "a.msh", "a.vtu"}) {
        const std::string path = (folder / name).string();
        write(tetrahedron(), path);
        EXPECT_GT(std::filesystem::file_size(path), 50u);
    }
    std::filesystem::remove_all(folder);
    for (const std::string path : {"part.step", "part", "folder.ply/part", "/nowhere/at/all/part.ply"}) {
        try {
            write(tetrahedron(), path);
            FAIL() << path;
        } catch (const IoError& e) {
            EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
        }
    }
}

TEST(Io, EmptyMeshIsWritten) {
    const TriangleMesh empty;
    EXPECT_EQ(text_of(to_stl, exported(empty)).size(), 84u);
    EXPECT_NE(text_of(to_msh, exported(empty)).find("$Nodes\n0 0 0 0\n$EndNodes"), std::string::npos)
        << text_of(to_msh, exported(empty));
    EXPECT_EQ(to_bms(empty).size(), 272u + 24u);
    EXPECT_NE(text_of(to_vtu, exported(empty)).find("NumberOfCells=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace mq::mesh

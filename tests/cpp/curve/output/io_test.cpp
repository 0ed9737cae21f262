// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What curved meshes look like in files: counts, orders and names, read back from the texts.

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <sstream>

#include "curve/checks.h"
#include "curve/elements.h"
#include "curve/files.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

CurvedMesh cylinder(int order) {
    return curved(geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), of_order(order), 1.0);
}

/// What stands between the lines $NAME and $EndNAME.
std::string section(const std::string& text, const std::string& name) {
    const std::size_t from = text.find("$" + name + "\n");
    const std::size_t to = text.find("$End" + name);
    EXPECT_NE(from, std::string::npos) << name;
    EXPECT_NE(to, std::string::npos) << name;
    return text.substr(from + name.size() + 2, to - from - name.size() - 2);
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++count;
    }
    return count;
}

TEST(CurvedFiles, GmshGetsAllNodesAndTheNamesOfTheFaces) {
    for (int order = 1; order <= 4; ++order) {
        const CurvedMesh mesh = cylinder(order);
        const std::string text = to_msh(mesh);
        EXPECT_EQ(section(text, "MeshFormat").substr(0, 5), "4.1 0");
        std::istringstream nodes(section(text, "Nodes"));
        std::size_t blocks = 0;
        std::size_t count = 0;
        nodes >> blocks >> count;
        EXPECT_EQ(count, mesh.nodes.size()) << order;
        std::istringstream elements(section(text, "Elements"));
        elements >> blocks >> count;
        EXPECT_GE(count, mesh.triangle_face.size()) << "edges may be elements, too";
        for (const char* name : {"\"Face1\"", "\"Face2\"", "\"Face3\""}) {
            EXPECT_EQ(count_of(section(text, "PhysicalNames"), name), 1U);
        }
    }
}

TEST(CurvedFiles, VtkGetsOneCellForEachTriangle) {
    for (int order = 1; order <= 4; ++order) {
        const CurvedMesh mesh = cylinder(order);
        const std::string text = to_vtu(mesh);
        const std::string number = std::to_string(mesh.triangle_face.size());
        EXPECT_EQ(count_of(text, "NumberOfPoints=\"" + std::to_string(mesh.nodes.size()) + "\""), 1U);
        EXPECT_EQ(count_of(text, "NumberOfCells=\"" + number + "\""), 1U);
        // In base64, behind their number of eight bytes, types 5, 22 or 69.
        const std::size_t types = text.find('>', text.find("Name=\"types\"")) + 1;
        EXPECT_EQ(text.substr(types + 8, 8), order == 1 ? "AAAFBQUF" : order == 2 ? "AAAWFhYW" : "AABFRUVF") << order;
    }
}

}  // namespace
}  // namespace mq::curve

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <exception>

#include "netgen_program.h"

/// Meshes a part with tetrahedra by Netgen's nglib, for given_meshes.py:
///
///     given_netgen MODEL.brep STRAIGHT.msh PLACED.msh ELEMENTS_PER_CURVE
///
/// STRAIGHT.msh has elements of the first order, PLACED.msh those of the second, whose middle nodes Netgen puts on the
/// CAD. Where Netgen makes no tetrahedra, as of shells, the files have triangles only. Prints as JSON the seconds of
/// the processor that the second order took.
namespace {

using namespace nglib;

constexpr double kElementsPerEdge = 1.0;

/// Type of an element in a .msh file, and by its node the position of it in Netgen's element.
template <std::size_t N>
struct Kind {
    int number;
    std::array<int, N> order;
};

constexpr Kind<3> kTriangle{2, {0, 1, 2}};
constexpr Kind<4> kTetrahedron{4, {0, 1, 2, 3}};
// Netgen has the middle node opposite of each corner.
constexpr Kind<6> kTriangle6{9, {0, 1, 2, 5, 3, 4}};
// Netgen's middle nodes are those of the edges 01, 02, 03, 12, 13, 23; Gmsh's of 01, 12, 20, 30, 32, 31.
constexpr Kind<10> kTetrahedron10{11, {0, 1, 2, 3, 4, 7, 5, 6, 9, 8}};

bool generate_surface(Ng_OCC_Geometry* geometry, Ng_Mesh* mesh, Ng_Meshing_Parameters& chosen) {
    if (!netgen_program::generate_edges(geometry, mesh, chosen)) {
        return false;
    }
    // It calls a surface without points inside its faces a failure, too.
    Ng_OCC_GenerateSurfaceMesh(geometry, mesh, &chosen);
    return Ng_GetNSE(mesh) > 0;
}

/// Says why where there are none.
void generate_tetrahedra(Ng_Mesh* mesh, Ng_Meshing_Parameters& chosen) {
    try {
        if (Ng_GenerateVolumeMesh(mesh, &chosen) != NG_OK) {
            std::fprintf(stderr, "Netgen made no tetrahedra\n");
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "Netgen made no tetrahedra: %s\n", error.what());
    }
}

template <std::size_t N>
void write_element(std::FILE* out, int number, const Kind<N>& kind, const int* nodes) {
    std::fprintf(out, "%d %d 2 1 1", number, kind.number);
    for (const int i : kind.order) {
        std::fprintf(out, " %d", nodes[i]);
    }
    std::fprintf(out, "\n");
}

bool write(const char* path, Ng_Mesh* mesh) {
    std::FILE* out = std::fopen(path, "w");
    if (out == nullptr) {
        return false;
    }
    const int points = Ng_GetNP(mesh);
    const int triangles = Ng_GetNSE(mesh);
    const int tetrahedra = Ng_GetNE(mesh);
    std::fprintf(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n", points);
    for (int i = 1; i <= points; ++i) {
        double x[3];
        Ng_GetPoint(mesh, i, x);
        std::fprintf(out, "%d %.17g %.17g %.17g\n", i, x[0], x[1], x[2]);
    }
    std::fprintf(out, "$EndNodes\n$Elements\n%d\n", triangles + tetrahedra);
    bool known = true;
    for (int i = 1; i <= triangles; ++i) {
        int nodes[16] = {};
        const Ng_Surface_Element_Type type = Ng_GetSurfaceElement(mesh, i, nodes);
        known = known && (type == NG_TRIG || type == NG_TRIG6);
        if (type == NG_TRIG) {
            write_element(out, i, kTriangle, nodes);
        } else {
            write_element(out, i, kTriangle6, nodes);
        }
    }
    for (int i = 1; i <= tetrahedra; ++i) {
        int nodes[16] = {};
        const Ng_Volume_Element_Type type = Ng_GetVolumeElement(mesh, i, nodes);
        known = known && (type == NG_TET || type == NG_TET10);
        if (type == NG_TET) {
            write_element(out, triangles + i, kTetrahedron, nodes);
        } else {
            write_element(out, triangles + i, kTetrahedron10, nodes);
        }
    }
    std::fprintf(out, "$EndElements\n");
    return std::fclose(out) == 0 && known;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "given_netgen MODEL.brep STRAIGHT.msh PLACED.msh ELEMENTS_PER_CURVE\n");
        return 2;
    }
    Ng_OCC_Geometry* geometry = netgen_program::read(argv[1]);
    Ng_Mesh* mesh = Ng_NewMesh();
    Ng_Meshing_Parameters chosen = netgen_program::parameters(std::atof(argv[4]), kElementsPerEdge);
    if (!generate_surface(geometry, mesh, chosen)) {
        std::fprintf(stderr, "Netgen failed\n");
        return 1;
    }
    generate_tetrahedra(mesh, chosen);
    if (!write(argv[2], mesh)) {
        std::fprintf(stderr, "%s cannot be written\n", argv[2]);
        return 1;
    }
    const std::clock_t start = std::clock();
    Ng_OCC_Generate_SecondOrder(geometry, mesh);
    const double seconds = netgen_program::seconds_since(start);
    if (!write(argv[3], mesh)) {
        std::fprintf(stderr, "%s cannot be written\n", argv[3]);
        return 1;
    }
    netgen_program::end(seconds);
}

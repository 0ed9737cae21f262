// SPDX-License-Identifier: LGPL-2.1-or-later
#include "netgen_program.h"

/// Meshes the faces of one solid with Netgen's nglib, for quality_peers.py:
///
///     quality_netgen MODEL.brep OUT.off ELEMENTS_PER_CURVE
///
/// Prints the seconds of the processor that meshing took as JSON.
namespace {

using namespace nglib;

constexpr double kElementsPerEdge = 2.0;
bool generate(Ng_OCC_Geometry* geometry, Ng_Mesh* mesh, Ng_Meshing_Parameters& chosen) {
    return netgen_program::generate_edges(geometry, mesh, chosen) &&
           Ng_OCC_GenerateSurfaceMesh(geometry, mesh, &chosen) == NG_OK;
}

bool write(const char* path, Ng_Mesh* mesh) {
    std::FILE* out = std::fopen(path, "w");
    if (out == nullptr) {
        return false;
    }
    const int points = Ng_GetNP(mesh);
    const int triangles = Ng_GetNSE(mesh);
    std::fprintf(out, "OFF\n%d %d 0\n", points, triangles);
    for (int i = 1; i <= points; ++i) {
        double x[3];
        Ng_GetPoint(mesh, i, x);
        std::fprintf(out, "%.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    for (int i = 1; i <= triangles; ++i) {
        int corners[8] = {};
        Ng_GetSurfaceElement(mesh, i, corners);
        std::fprintf(out, "3 %d %d %d\n", corners[0] - 1, corners[1] - 1, corners[2] - 1);
    }
    return std::fclose(out) == 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "quality_netgen MODEL.brep OUT.off ELEMENTS_PER_CURVE\n");
        return 2;
    }
    Ng_OCC_Geometry* geometry = netgen_program::read(argv[1]);
    Ng_Mesh* mesh = Ng_NewMesh();
    Ng_Meshing_Parameters chosen = netgen_program::parameters(std::atof(argv[3]), kElementsPerEdge);
    const std::clock_t start = std::clock();
    const bool done = generate(geometry, mesh, chosen);
    const double seconds = netgen_program::seconds_since(start);
    if (!done || !write(argv[2], mesh)) {
        std::fprintf(stderr, "Netgen failed\n");
        return 1;
    }
    netgen_program::end(seconds);
}

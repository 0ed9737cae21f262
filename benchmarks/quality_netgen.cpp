// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <cstdlib>
#include <ctime>

#define OCCGEOMETRY
namespace nglib {
#include <netgen/nglib.h>
}

/// Meshes the faces of one solid with Netgen's nglib, for quality_peers.py:
///
///     quality_netgen MODEL.brep OUT.off ELEMENTS_PER_CURVE
///
/// Prints the seconds of the processor that meshing took as JSON. A program of its own, because Netgen aborts on some
/// parts.
namespace {

using namespace nglib;

constexpr double kElementsPerEdge = 2.0;
constexpr double kGrading = 0.3;

Ng_Meshing_Parameters parameters(double elements_per_curve) {
    Ng_Meshing_Parameters result;
    result.uselocalh = 1;
    result.elementspercurve = elements_per_curve;
    result.elementsperedge = kElementsPerEdge;
    result.grading = kGrading;
    result.maxh = 1e9;
    result.minh = 0.0;
    return result;
}

bool generate(Ng_OCC_Geometry* geometry, Ng_Mesh* mesh, Ng_Meshing_Parameters& chosen) {
    return Ng_OCC_SetLocalMeshSize(geometry, mesh, &chosen) == NG_OK &&
           Ng_OCC_GenerateEdgeMesh(geometry, mesh, &chosen) == NG_OK &&
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
    Ng_Init();
    Ng_OCC_Geometry* geometry = Ng_OCC_Load_BREP(argv[1]);
    if (geometry == nullptr) {
        std::fprintf(stderr, "%s cannot be read\n", argv[1]);
        return 1;
    }
    Ng_Mesh* mesh = Ng_NewMesh();
    Ng_Meshing_Parameters chosen = parameters(std::atof(argv[3]));
    const std::clock_t start = std::clock();
    const bool done = generate(geometry, mesh, chosen);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    if (!done || !write(argv[2], mesh)) {
        std::fprintf(stderr, "Netgen failed\n");
        return 1;
    }
    std::printf("\n{\"seconds\": %.4f}\n", seconds);
    std::fflush(stdout);
    // Netgen's own clean-up crashes at times.
    std::_Exit(0);
}

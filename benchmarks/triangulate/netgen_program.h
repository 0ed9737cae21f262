// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>

#define OCCGEOMETRY
namespace nglib {
#include <netgen/nglib.h>
}

/// What the benchmarks' programs that run Netgen's nglib have in common. Each is a program of its own, because Netgen
/// aborts on some parts.
namespace netgen_program {

/// Elements of a size that follows the curvature, and grow with Netgen's usual grading of 0.3.
inline nglib::Ng_Meshing_Parameters parameters(double elements_per_curve, double elements_per_edge) {
    nglib::Ng_Meshing_Parameters result;
    result.uselocalh = 1;
    result.elementspercurve = elements_per_curve;
    result.elementsperedge = elements_per_edge;
    result.grading = 0.3;
    result.maxh = 1e9;
    result.minh = 0.0;
    return result;
}

/// Reads a BREP file; ends the program where that fails.
inline nglib::Ng_OCC_Geometry* read(const char* path) {
    nglib::Ng_Init();
    nglib::Ng_OCC_Geometry* geometry = nglib::Ng_OCC_Load_BREP(path);
    if (geometry == nullptr) {
        std::fprintf(stderr, "%s cannot be read\n", path);
        std::exit(1);
    }
    return geometry;
}

inline bool generate_edges(nglib::Ng_OCC_Geometry* geometry, nglib::Ng_Mesh* mesh,
                           nglib::Ng_Meshing_Parameters& chosen) {
    return nglib::Ng_OCC_SetLocalMeshSize(geometry, mesh, &chosen) == nglib::NG_OK &&
           nglib::Ng_OCC_GenerateEdgeMesh(geometry, mesh, &chosen) == nglib::NG_OK;
}

inline double seconds_since(std::clock_t start) {
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Prints the seconds of the processor as JSON and ends the program, without Netgen's own clean-up, which crashes at
/// times.
[[noreturn]] inline void end(double seconds) {
    std::printf("\n{\"seconds\": %.4f}\n", seconds);
    std::fflush(stdout);
    std::_Exit(0);
}

}  // namespace netgen_program

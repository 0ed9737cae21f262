// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's alpha wrapping (Portaneri et al. 2022) of a triangle soup, for wrap_assemblies.py and peers.py. Built by these
// when CGAL is there.
//     alpha_wrap IN.off OUT.off ALPHA OFFSET
// Without arguments it prints its version.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/version.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <vector>

int main(int argc, char** argv) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    if (argc != 5) {
        std::cout << CGAL_VERSION_STR << "\n";
        return 0;
    }
    if (!(std::atof(argv[4]) > 0.0)) {
        std::cout << "a wrap lies outside\n";
        return 1;
    }
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(argv[1], points, faces)) {
        return 1;
    }
    CGAL::Surface_mesh<Kernel::Point_3> wrap;
    const std::clock_t start = std::clock();
    const auto began = std::chrono::steady_clock::now();
    CGAL::alpha_wrap_3(points, faces, std::atof(argv[3]), std::atof(argv[4]), wrap);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
    CGAL::IO::write_polygon_mesh(argv[2], wrap, CGAL::parameters::stream_precision(17));
    std::cout << "{\"seconds\": " << seconds << ", \"wall\": " << wall.count() << "}\n";
    return 0;
}

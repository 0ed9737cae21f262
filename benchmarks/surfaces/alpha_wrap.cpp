// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's alpha wrapping (Portaneri et al. 2022) of a triangle soup, for wrap_assemblies.py. Built by that when CGAL is
// there.
//     alpha_wrap IN.off OUT.off ALPHA OFFSET
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <vector>

int main(int argc, char** argv) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    if (argc != 5) {
        return 2;
    }
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(argv[1], points, faces)) {
        return 1;
    }
    CGAL::Surface_mesh<Kernel::Point_3> wrap;
    const auto began = std::chrono::steady_clock::now();
    CGAL::alpha_wrap_3(points, faces, std::atof(argv[3]), std::atof(argv[4]), wrap);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
    CGAL::IO::write_polygon_mesh(argv[2], wrap, CGAL::parameters::stream_precision(17));
    std::cout << seconds.count() << " " << num_faces(wrap) << "\n";
    return 0;
}

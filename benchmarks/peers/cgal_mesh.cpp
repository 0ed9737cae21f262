// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's Mesh_3 for peers.py, which builds it when CGAL is there: Delaunay refinement of a closed triangulation whose
// sharp edges are protected, with facets of 25 degrees. Its surface is written.
//     cgal_mesh IN.off OUT.off DISTANCE EDGE
// EDGE bounds the pieces of sharp edges, which have no distance of their own. Without arguments it prints its version.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/version.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>

int main(int count, char** arguments) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel>;
    using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
    using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
    using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
    namespace parameters = CGAL::parameters;
    if (count != 5) {
        std::cout << CGAL_VERSION_STR << "\n";
        return 0;
    }
    CGAL::Mesh_polyhedron_3<Kernel>::type given;
    std::ifstream(arguments[1]) >> given;
    if (given.empty() || !given.is_closed()) {
        std::cout << "the triangulation is not closed\n";
        return 1;
    }
    const std::clock_t start = std::clock();
    const auto began = std::chrono::steady_clock::now();
    Domain domain(given);
    domain.detect_features(20.0);
    const Criteria criteria(parameters::edge_size = std::atof(arguments[4]), parameters::facet_angle = 25.0,
                            parameters::facet_distance = std::atof(arguments[3]));
    const auto made = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
    std::ofstream file(arguments[2]);
    file.precision(17);
    made.output_boundary_to_off(file);
    std::cout << "{\"seconds\": " << seconds << ", \"wall\": " << wall.count() << "}\n";
    return 0;
}

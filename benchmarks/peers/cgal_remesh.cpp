// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's isotropic remeshing of a mesh, for peers.py, which builds it when CGAL is there. Edges at which the surface
// turns by more than 35 degrees are kept, split to the length first.
//     cgal_remesh IN.off OUT.off LENGTH
// Without arguments it prints its version.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <vector>

int main(int count, char** arguments) {
    namespace processing = CGAL::Polygon_mesh_processing;
    using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
    if (count != 4) {
        std::cout << CGAL_VERSION_STR << "\n";
        return 0;
    }
    Mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(arguments[1], mesh)) {
        std::cout << "the mesh is not manifold\n";
        return 1;
    }
    const double length = std::atof(arguments[3]);
    const std::clock_t start = std::clock();
    const auto began = std::chrono::steady_clock::now();
    auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    processing::detect_sharp_edges(mesh, 35.0, sharp);
    std::vector<Mesh::Edge_index> edges;
    for (const Mesh::Edge_index edge : mesh.edges()) {
        if (sharp[edge]) {
            edges.push_back(edge);
        }
    }
    const auto kept = CGAL::parameters::edge_is_constrained_map(sharp).protect_constraints(true);
    processing::split_long_edges(edges, length, mesh, CGAL::parameters::edge_is_constrained_map(sharp));
    processing::isotropic_remeshing(faces(mesh), length, mesh,
                                    kept.number_of_iterations(10).number_of_relaxation_steps(3));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
    mesh.collect_garbage();
    CGAL::IO::write_polygon_mesh(arguments[2], mesh, CGAL::parameters::stream_precision(17));
    std::cout << "{\"seconds\": " << seconds << ", \"wall\": " << wall.count() << "}\n";
    return 0;
}

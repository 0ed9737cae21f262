// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's corefinement of two closed meshes, for peers.py, which builds it when CGAL is there. Constructed points are
// exact (a map of the vertices to points of an exact kernel) and rounded at the end, which is its safest use.
//     cgal_boolean OPERATION A.off B.off OUT.off
// Without arguments it prints its version.
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <chrono>
#include <ctime>
#include <iostream>
#include <string>

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The exact point of each vertex; writing one rounds it into the mesh, too.
struct ExactPoints {
    using key_type = Mesh::Vertex_index;
    using value_type = Exact::Point_3;
    using reference = value_type;
    using category = boost::read_write_property_map_tag;

    ExactPoints() = default;  // CGAL's pairs of maps need it
    explicit ExactPoints(Mesh& of)
        : mesh(&of), points(of.add_property_map<Mesh::Vertex_index, Exact::Point_3>("v:exact").first) {
        const CGAL::Cartesian_converter<Kernel, Exact> exact;
        for (const Mesh::Vertex_index v : of.vertices()) {
            points[v] = exact(of.point(v));
        }
    }

    friend reference get(const ExactPoints& map, key_type v) { return map.points[v]; }
    friend void put(const ExactPoints& map, key_type v, const value_type& point) {
        const CGAL::Cartesian_converter<Exact, Kernel> rounded;
        map.points[v] = point;
        map.mesh->point(v) = rounded(point);
    }

    Mesh* mesh = nullptr;
    Mesh::Property_map<Mesh::Vertex_index, Exact::Point_3> points;
};

bool computed(const std::string& operation, Mesh& a, Mesh& b, Mesh& result) {
    const ExactPoints of_a(a), of_b(b), of_result(result);
    const auto first = CGAL::parameters::vertex_point_map(of_a);
    const auto second = CGAL::parameters::vertex_point_map(of_b);
    const auto third = CGAL::parameters::vertex_point_map(of_result);
    if (operation == "union") {
        return processing::corefine_and_compute_union(a, b, result, first, second, third);
    }
    if (operation == "intersection") {
        return processing::corefine_and_compute_intersection(a, b, result, first, second, third);
    }
    return processing::corefine_and_compute_difference(a, b, result, first, second, third);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 5) {
        std::cout << CGAL_VERSION_STR << "\n";
        return 0;
    }
    Mesh a, b, result;
    if (!CGAL::IO::read_polygon_mesh(arguments[2], a) || !CGAL::IO::read_polygon_mesh(arguments[3], b)) {
        std::cout << "an operand is not manifold\n";
        return 1;
    }
    const std::clock_t start = std::clock();
    const auto began = std::chrono::steady_clock::now();
    const bool done = computed(arguments[1], a, b, result);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
    if (!done) {
        std::cout << "the result is not manifold\n";
        return 1;
    }
    result.collect_garbage();
    CGAL::IO::write_polygon_mesh(arguments[4], result, CGAL::parameters::stream_precision(17));
    std::cout << "{\"seconds\": " << seconds << ", \"wall\": " << wall.count() << "}\n";
    return 0;
}

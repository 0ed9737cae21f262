// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/mixed_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "base/error.h"
#include "elements/product/reference_nodes.h"
#include "given/mixed/blocks.h"

namespace mq::given {

using elements::ElementKind;

namespace {

double volume_of(const GivenMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.tetrahedra) {
        const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(t[k])]; };
        sum += (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6.0;
    }
    return sum;
}

TEST(MixedMesh, EveryKindIsDividedIntoPositiveTetrahedraWhateverItsNumbers) {
    std::mt19937 random(3);
    const std::map<ElementKind, double> volumes{{ElementKind::Tetrahedron, 1.0 / 6.0},
                                                {ElementKind::Pyramid, 4.0 / 3.0},
                                                {ElementKind::Prism, 1.0},
                                                {ElementKind::Hexahedron, 8.0}};
    for (const auto& [kind, volume] : volumes) {
        for (int round = 0; round < 20; ++round) {
            const std::vector<Vec3> places = elements::reference_nodes(kind, 1);
            std::vector<std::int32_t> number(places.size());
            for (std::size_t i = 0; i < number.size(); ++i) {
                number[i] = static_cast<std::int32_t>(i);
            }
            std::shuffle(number.begin(), number.end(), random);
            MixedMesh mesh;
            mesh.nodes.resize(places.size());
            MixedElement element;
            element.kind = kind;
            for (std::size_t i = 0; i < places.size(); ++i) {
                mesh.nodes[static_cast<std::size_t>(number[i])] = places[i];
                element.corners[i] = number[i];
            }
            mesh.elements.push_back(element);
            const Simplices simplices = divided_into_simplices(mesh);
            EXPECT_NEAR(volume_of(simplices.mesh), volume, 1e-12) << elements::name_of(kind);
        }
    }
}

TEST(MixedMesh, NeighboursDivideTheirFaceAlike) {
    std::mt19937 random(4);
    MixedMesh mesh = cubes(2, 2, 2);
    std::vector<std::int32_t> number(mesh.nodes.size());
    for (std::size_t i = 0; i < number.size(); ++i) {
        number[i] = static_cast<std::int32_t>(i);
    }
    std::shuffle(number.begin(), number.end(), random);
    const std::vector<Vec3> places = mesh.nodes;
    for (std::size_t i = 0; i < number.size(); ++i) {
        mesh.nodes[static_cast<std::size_t>(number[i])] = places[i];
    }
    for (MixedElement& element : mesh.elements) {
        for (std::int32_t& corner : element.corners) {
            corner = number[static_cast<std::size_t>(corner)];
        }
    }
    const Simplices simplices = divided_into_simplices(mesh);
    EXPECT_EQ(simplices.mesh.tetrahedra.size(), 48u);
    EXPECT_EQ(surface_of(simplices.mesh).size(), 48u);  // two on each of 24 squares, and none inside
}

TEST(MixedMesh, ElementsThatAreInsideOutAreTurned) {
    MixedMesh mesh = cubes(2, 2, 2);
    std::swap_ranges(mesh.elements[3].corners.begin(), mesh.elements[3].corners.begin() + 4,
                     mesh.elements[3].corners.begin() + 4);
    EXPECT_EQ(orient_elements(mesh), 1u);
    EXPECT_EQ(mesh.elements[3].corners, cubes(2, 2, 2).elements[3].corners);
    EXPECT_EQ(orient_elements(mesh), 0u);
    EXPECT_NEAR(volume_of(divided_into_simplices(mesh).mesh), 8.0, 1e-12);
}

TEST(MixedMesh, FaultsAreNamed) {
    MixedMesh mesh = cubes(1, 1, 1);
    mesh.elements[0].corners[3] = mesh.elements[0].corners[2];
    EXPECT_THROW(require_sound(mesh), InvalidInput);
    mesh.elements[0].corners[3] = 8;
    EXPECT_THROW(require_sound(mesh), InvalidInput);
    mesh.elements.clear();
    EXPECT_THROW(require_sound(mesh), InvalidInput);
}

}  // namespace
}  // namespace mq::given

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/uniform_operand.h"

#include <utility>

#include "base/error.h"
#include "mesh/edge_table.h"

namespace mq::boolean {

namespace {

/// A hash that is zero when every directed edge has its reverse; for an open surface it is zero with probability 2^-64.
std::uint64_t edge_balance(const mesh::TriangleMesh& mesh) {
    const auto mixed = [](std::uint64_t from, std::uint64_t to) {
        std::uint64_t x = (from << 32 | to) * 0x9e3779b97f4a7c15ULL;
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ x >> 27) * 0x94d049bb133111ebULL;
        return x ^ x >> 31;
    };
    std::uint64_t sum = 0;
    for (const mesh::Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const auto from = static_cast<std::uint32_t>(t[i]), to = static_cast<std::uint32_t>(t[(i + 1) % 3]);
            if (from != to) {
                sum += mixed(from, to) - mixed(to, from);
            }
        }
    }
    return sum;
}

/// Whether all edges are in balance: as many triangles run one way along each as the other. Such a surface has as many
/// entries as exits on every ray, however it crosses itself.
bool closed(const mesh::TriangleMesh& mesh) {
    if (edge_balance(mesh) == 0) {
        return true;
    }
    bool balanced = true;
    const mesh::EdgeTable edges(mesh.triangles, mesh.vertices.size());
    edges.for_each([&](std::int32_t low, std::int32_t, const std::uint32_t* first, const std::uint32_t* last) {
        std::ptrdiff_t up = 0;
        for (const std::uint32_t* c = first; c != last; ++c) {
            up += mesh.triangles[*c / 3][*c % 3] == low ? 1 : -1;
        }
        balanced = balanced && up == 0;
    });
    return balanced;
}

/// A reversed operand would be all outside by the normal index, and vanish.
bool outward(const mesh::TriangleMesh& mesh) {
    double volume = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3& base = mesh.vertices[mesh.triangles.front()[0]];
        volume += (mesh.vertices[t[0]] - base).dot((mesh.vertices[t[1]] - base).cross(mesh.vertices[t[2]] - base));
    }
    return volume >= 0.0;
}

void require_valid(const mesh::TriangleMesh& mesh, const std::string& name) {
    try {
        mesh::require_valid(mesh);
    } catch (const InvalidInput& error) {
        throw InvalidInput(name + ": " + error.what());
    }
}

}  // namespace

UniformOperand::UniformOperand(const mesh::TriangleMesh& given, const std::string& name, double reach,
                               const Progress* progress)
    : given_(&given) {
    require_valid(given, name);
    if (closed(given) && outward(given)) {
        return;
    }
    check_cancelled(progress);
    try {
        take(prepare_operand(given, name, reach, progress), name);
    } catch (const OpenOperand&) {
        take(prepare_open_operand(given, name, progress), name);
        winding_ = std::make_unique<mesh::WindingNumber>(made_->vertices, made_->triangles);
    }
}

void UniformOperand::take(Operand&& operand, const std::string& name) {
    source_.reserve(operand.triangles.size());
    for (std::size_t t = 0; t < operand.triangles.size(); ++t) {
        source_.push_back(has_corners_of(operand, t, *given_) ? operand.source[t] : -1);
    }
    repaired_ = operand.repairs.any() ? name + ": " + operand.repairs.summary() : std::string();
    largest_move_ = operand.largest_move;
    made_ = std::make_unique<mesh::TriangleMesh>();
    made_->origin = given_->origin;
    made_->vertices = std::move(operand.vertices);
    made_->triangles = std::move(operand.triangles);
}

}  // namespace mq::boolean

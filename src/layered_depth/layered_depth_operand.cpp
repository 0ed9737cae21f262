// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/layered_depth_operand.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/message.h"
#include "boolean/input/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "layered_depth/samples/rasterise.h"
#include "layered_depth/samples/winding_samples.h"
#include "mesh/edge_table.h"

namespace mq::layered_depth {

namespace {

void require_valid(const mesh::TriangleMesh& mesh, const std::string& name) {
    try {
        mesh::require_valid(mesh);
    } catch (const InvalidInput& error) {
        throw InvalidInput(phrases::kNamed, {{"name", name}, {"phrase", error.message()}});
    }
}

/// Rays along the longest side of an open operand by which the guessed fraction of its surface is estimated.
constexpr int kEstimate = 65;

/// Refuses a sheet, which bounds no volume: the surface that closes it would be about as large as the sheet itself.
void require_volume(const mesh::TriangleMesh& mesh, const mesh::SurfaceWinding& winding, const std::string& name,
                    const Progress* progress) {
    const OperandSet alone({&mesh}, {winding.border()});
    const SampleGrid grid(winding.tree().box(), kEstimate);
    LayeredDepthSet set = rasterise(alone, 0, grid, progress);
    WindingSampleCounts counts;
    sample_by_winding(set, alone, 0, grid, winding, counts, progress);
    if (counts.guessed_area >= boolean::InputTuning::kLeastSheetShare * counts.kept_area) {
        const double whole = std::max(1.0, counts.kept_area + counts.guessed_area);
        throw boolean::OpenOperand(phrases::kGuessedVolume,
                                   {{"name", name}, {"number", in_digits(100.0 * counts.guessed_area / whole, 2)}});
    }
}

}  // namespace

UniformOperand::UniformOperand(const mesh::TriangleMesh& given, const std::string& name, double reach,
                               const Progress* progress)
    : given_(&given) {
    require_valid(given, name);
    if (given.triangles.empty()) {
        return;
    }
    try {
        boolean::Operand operand = boolean::prepare_operand(given, name, reach, progress);
        if (operand.repairs.any()) {
            adopt(std::move(operand), name);
        }
    } catch (const boolean::OpenOperand&) {
        adopt(boolean::prepare_open_operand(given, name, progress), name);
        winding_ = std::make_unique<mesh::SurfaceWinding>(made_->vertices, made_->triangles);
        require_volume(*made_, *winding_, name, progress);
    }
}

std::vector<std::int32_t> UniformOperand::faces(const std::vector<std::int32_t>& given) const {
    if (as_given()) {
        return given;
    }
    if (open() || std::find(origin_.begin(), origin_.end(), -1) != origin_.end()) {
        return {};
    }
    std::vector<std::int32_t> faces;
    for (const std::int32_t t : origin_) {
        faces.push_back(given[static_cast<std::size_t>(t)]);
    }
    return faces;
}

void UniformOperand::adopt(boolean::Operand&& operand, const std::string& name) {
    source_.reserve(operand.triangles.size());
    for (std::size_t t = 0; t < operand.triangles.size(); ++t) {
        source_.push_back(boolean::has_corners_of(operand, t, *given_) ? operand.source[t] : -1);
    }
    origin_ = std::move(operand.source);
    repaired_ = operand.repairs.of_operand(name);
    largest_move_ = operand.largest_move;
    made_ = std::make_unique<mesh::TriangleMesh>();
    made_->origin = given_->origin;
    made_->vertices = std::move(operand.vertices);
    made_->triangles = std::move(operand.triangles);
}

}  // namespace mq::layered_depth

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/face_spacing.h"

#include <algorithm>
#include <array>
#include <string>

#include "triangulate/spacing/face_cells.h"
#include "triangulate/spacing/tuning.h"

namespace mq::triangulate {

namespace {

bool has_plain_curvature(const char* surface) {
    // Surfaces whose smallest spacing always occurs on their borders.
    constexpr std::array<const char*, 5> kPlain{"plane", "cylinder", "sphere", "cone", "torus"};
    return std::find(kPlain.begin(), kPlain.end(), std::string(surface)) != kPlain.end();
}

}  // namespace

void add_face_spacings(geometry::Session& session, const InitialTriangulation& coarse, const SinglePrecisionGrid& grid,
                       const SpacingBounds& bounds, SpacingField& field, const Progress& progress) {
    const auto spacing = [&bounds](const geometry::Answer& a) {
        return a.status == geometry::Status::Ok ? spacing_for(a.u, bounds) : bounds.most;
    };
    for (int f = 0; f < static_cast<int>(coarse.faces.size()); ++f) {
        if (coarse.faces[f].triangles.empty() || has_plain_curvature(session.topology().faces[f].surface)) {
            continue;
        }
        std::string failure;
        const FaceBoundary border = face_boundary(session, coarse.chains, grid, f, failure);
        FaceCells cells(session, f, outline_of(border), spacing);
        cells.divide(SpacingTuning::kCellOfSpacing, progress);
        for (const FaceCells::Corner& corner : cells.inner_corners()) {
            if (corner.spacing < bounds.most) {
                field.add(corner.point, corner.spacing);
            }
        }
    }
}

}  // namespace mq::triangulate

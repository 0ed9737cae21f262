// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/input/operation.h"
#include "layered_depth/samples/layered_depth_image.h"
#include "layered_depth/samples/rasterise.h"

namespace mq::layered_depth {

/// Samples of the result along the rays of one direction. On each ray they alternate between entry and exit.
struct CombinedDepth {
    std::vector<std::uint32_t> begin;  ///< first sample of each ray in the arrays below, and the end
    std::vector<double> depth;         ///< grid coordinate along the ray
    std::vector<std::int32_t> source;  ///< 2 * triangle, plus 1 if the result's surface is the triangle reversed

    /// Unit normal of the surface, of either sign, if an operand has samples on CAD faces; empty: the normals of the
    /// triangles.
    std::vector<SampleNormal> normal;

    static std::int32_t triangle(std::int32_t source) { return source >> 1; }
    static bool reversed(std::int32_t source) { return (source & 1) != 0; }
    /// Whether the grid node at `k` on the ray is inside; a sample exactly at a node counts as before it.
    bool inside(std::size_t ray, double k) const {
        std::uint32_t i = begin[ray];
        while (i < begin[ray + 1] && depth[i] <= k) {
            ++i;
        }
        return ((i - begin[ray]) & 1) != 0;
    }
};
using CombinedSet = std::array<CombinedDepth, 3>;

struct CombineOptions {
    boolean::Expression expression = boolean::Expression::chain(boolean::Operation::Union, 2);
    /// Grid units: samples of two operands that are no farther apart than this are in contact.
    double thinnest = 0.0;
    /// Whether points with a normal index of 1 or more are inside (Wang 2010, section IV-C), so that only the outer
    /// surface of an operand that intersects itself counts. Otherwise points after an odd number of samples are inside.
    bool normal_index = true;
};

/// Evaluates an expression ray by ray (Wang 2010, section II, step 2 and section IV-B), in parallel and with all
/// operands in one pass: along each ray the places are found at which it enters or leaves the result.
///
/// A gap or a slab between two operands that is as thin as a contact vanishes. If both surfaces are oriented the same
/// way in the result, the sample is that of the triangle with the lower index, whichever comes first on the ray (Remark
/// 3): a contact region keeps the triangles of one operand. Samples of a single operand are never merged.
/// @param operands images of the operands; a set that is moved in is released direction by direction
/// @throws InvalidInput if a ray does not leave an operand as often as it enters it: the operand is open or not
/// oriented
CombinedSet combine(const OperandSet& set, std::vector<LayeredDepthSet> operands, const SampleGrid& grid,
                    const CombineOptions& options, const Progress* progress);

/// Samples and combines meshes, a band of rays at a time. The samples of a band are released once they are combined, so
/// that the operands' samples take little memory. The result does not depend on the height of the bands.
/// @param counts the number of samples of each triangle, to which the samples of these operands are added
CombinedSet combine_meshes(const OperandSet& set, const SampleGrid& grid, const CombineOptions& options,
                           SampleCounts& counts, const Progress* progress, int rows_per_band = kRowsPerBand);

}  // namespace mq::layered_depth

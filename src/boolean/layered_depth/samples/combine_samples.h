// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "boolean/input/operation.h"
#include "boolean/layered_depth/samples/layered_depth_image.h"
#include "boolean/layered_depth/samples/rasterise.h"

namespace mq::boolean {

/// Samples of the result along the rays of one direction. They alternate: the first of a ray enters, the second leaves.
struct CombinedDepth {
    std::vector<std::uint32_t> begin;  ///< first sample of each ray in the arrays below, and the end
    std::vector<double> depth;         ///< grid coordinate along the ray
    std::vector<std::int32_t> source;  ///< 2 * triangle + 1 where the result's surface is the triangle reversed

    /// Unit normal of the surface, of either sign, where an operand has samples on CAD faces; empty: that of the
    /// triangle.
    std::vector<SampleNormal> normal;

    static std::int32_t triangle(std::int32_t source) { return source >> 1; }
    static bool reversed(std::int32_t source) { return (source & 1) != 0; }
    /// Whether the grid node at `k` on the ray lies inside; a sample exactly at a node lies before it.
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
    Expression expression = Expression::chain(Operation::Union, 2);
    /// Samples of two operands no farther apart than this (grid units) are in contact.
    double thinnest = 0.0;
    /// Inside is where the normal index is 1 or more (Wang 2010, section IV-C), so that only the outer surface of an
    /// operand that intersects itself counts; otherwise inside is after an odd number of samples.
    bool normal_index = true;
};

/// The operations of an expression ray by ray (Wang 2010, section II, step 2 and section IV-B), in parallel: all
/// operands in one pass, each ray telling where the point on it comes into the result.
///
/// A gap or a slab between two operands as thin as a contact vanishes. Where both are oriented the same way in the
/// result the sample is that of the lower triangle, whichever comes first (Remark 3): a contact region keeps one
/// operand's triangles whole. Samples of one operand alone are left as they are, however near to each other.
/// @param operands their images; one that is moved in is dropped direction by direction
/// @throws InvalidInput where a ray does not leave an operand as often as it enters: the operand is not closed, or not
/// oriented
CombinedSet combine(const OperandSet& set, std::vector<LayeredDepthSet> operands, const SampleGrid& grid,
                    const CombineOptions& options, const Progress* progress);

/// The same of meshes, which are sampled a band of rays at a time. The samples of a band are dropped once they are
/// combined, so that those of the operands take little memory. The same for any height of the bands.
/// @param counts the number of samples of each triangle, to which those of these operands are added
CombinedSet combine_meshes(const OperandSet& set, const SampleGrid& grid, const CombineOptions& options,
                           SampleCounts& counts, const Progress* progress, int rows_per_band = kRowsPerBand);

}  // namespace mq::boolean

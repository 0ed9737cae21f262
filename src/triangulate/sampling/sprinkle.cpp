// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/sprinkle.h"

#include <algorithm>
#include <array>
#include <random>

#include "triangulate/front/void_search.h"
#include "triangulate/sampling/tuning.h"
#include "triangulate/spacing/face_cells.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;

class Sprinkler {
  public:
    Sprinkler(const SamplingContext& context, int face, const FaceBoundary& border, std::uint64_t seed)
        : sampler_(context, face, border, SamplingTuning::kBallRadius),
          cells_(context.session, face, outline_of(border),
                 [&context](const Answer& a) { return context.spacing_at(a); }),
          random_(seed + static_cast<std::uint64_t>(face)) {}

    std::vector<FaceSampler::Candidate> run() {
        cells_.divide(SamplingTuning::kCell, sampler_.context().progress);
        std::vector<std::size_t> open = cells_.all();
        while (!open.empty() && !sampler_.full()) {
            shuffle(open);
            std::vector<std::size_t> left;
            for (std::size_t from = 0; from < open.size() && !sampler_.full(); from += SamplingTuning::kSprinkleBatch) {
                sampler_.context().progress.check();
                throw_darts(open, from, std::min(open.size(), from + SamplingTuning::kSprinkleBatch), left);
            }
            open.swap(left);
        }
        return sampler_.samples();
    }

  private:
    // Replaces std::shuffle, whose order differs from one library to the next; within blocks, so that neighbouring
    // cells remain close in memory.
    void shuffle(std::vector<std::size_t>& cells) {
        for (std::size_t begin = 0; begin < cells.size(); begin += SamplingTuning::kShuffleBlock) {
            const std::size_t size = std::min(SamplingTuning::kShuffleBlock, cells.size() - begin);
            for (std::size_t i = size; i > 1; --i) {
                std::swap(cells[begin + i - 1], cells[begin + random_() % i]);
            }
        }
    }
    void throw_darts(const std::vector<std::size_t>& cells, std::size_t from, std::size_t to,
                     std::vector<std::size_t>& left);
    std::optional<Vec2> dart(std::size_t cell);
    std::optional<Vec2> dart(std::size_t cell, int half);

    FaceSampler sampler_;
    FaceCells cells_;
    std::mt19937_64 random_;
    std::vector<VoidSearch::Ball> balls_;
};

// Returns (u, v) of a place in the cell without a sample nearby, judged without querying the surface there.
std::optional<Vec2> Sprinkler::dart(std::size_t cell) {
    const Vec3 origin = sampler_.context().grid.origin();
    double most = 0.0;
    double size = 0.0;
    const Vec3 centre = 0.5 * (cells_.corner(cell, 0).point + cells_.corner(cell, 2).point);
    for (int i = 0; i < 4; ++i) {
        most = std::max(most, cells_.corner(cell, i).spacing);
        size = std::max(size, (cells_.corner(cell, i).point - centre).norm());
    }
    sampler_.balls_around(centre - origin, size, most, balls_);
    const int first = static_cast<int>(random_() % 2);
    const auto found = dart(cell, first);
    return found ? found : dart(cell, 1 - first);
}

// Returns such a place in half 0 of the cell, with the corners 0, 1, 2, or in half 1, with 0, 2, 3.
std::optional<Vec2> Sprinkler::dart(std::size_t cell, int half) {
    const FaceCells::Corner* corners[3] = {&cells_.corner(cell, 0), &cells_.corner(cell, 1 + half),
                                           &cells_.corner(cell, 2 + half)};
    std::array<Vec3, 3> points;
    std::array<double, 3> radii{};
    for (int i = 0; i < 3; ++i) {
        points[i] = corners[i]->point - sampler_.context().grid.origin();
        radii[i] = SamplingTuning::kCovered * sampler_.closest(corners[i]->spacing);
    }
    const Vec2& origin = corners[0]->uv;
    Eigen::Matrix2d sides;
    sides << corners[1]->uv - origin, corners[2]->uv - origin;
    const Eigen::Matrix2d weights = sides.inverse();
    const auto to_place = [&](const Vec2& uv) { return Vec2(weights * (uv - origin)); };
    VoidSearch::Outline outline{{}, to_place(cells_.reference(cell)), cells_.inside(cell)};
    for (const Segment2& s : cells_.outline(cell)) {
        outline.segments.push_back({to_place(s[0]), to_place(s[1])});
    }
    const double least = SamplingTuning::kLeastGap * cells_.least_spacing(cell);
    const std::optional<Vec2> place = VoidSearch(points, radii, balls_, outline).find(least, random_);
    return place ? std::optional<Vec2>(origin + sides * *place) : std::nullopt;
}

// Throws one dart into every cell that has a gap. If the dart shows that the surface or its border deviates from the
// cell's approximation, the cell is halved. `left` receives the cells for the next round.
void Sprinkler::throw_darts(const std::vector<std::size_t>& cells, std::size_t from, std::size_t to,
                            std::vector<std::size_t>& left) {
    std::vector<std::size_t> aimed;
    std::vector<Vec2> uvs;
    for (std::size_t k = from; k < to; ++k) {
        if (const auto uv = dart(cells[k])) {
            aimed.push_back(cells[k]);
            uvs.push_back(*uv);
        }
    }
    const auto darts = sampler_.candidates(uvs);
    std::vector<std::size_t> missed;
    for (std::size_t k = 0; k < aimed.size() && !sampler_.full(); ++k) {
        const auto& c = darts[k];
        if (c && c->fits) {
            left.push_back(aimed[k]);
            if (!sampler_.crowded(c->site.point, c->spacing)) {
                sampler_.accept(*c);
            }
        } else if (cells_.longest_side(aimed[k]) > SamplingTuning::kLeastCell * cells_.least_spacing(aimed[k])) {
            missed.push_back(aimed[k]);
        }
    }
    const std::vector<std::size_t> halves = cells_.halve(missed);
    left.insert(left.end(), halves.begin(), halves.end());
}

}  // namespace

std::vector<FaceSampler::Candidate> sample_sprinkle(const SamplingContext& context, int face,
                                                    const FaceBoundary& border, std::uint64_t seed) {
    return Sprinkler(context, face, border, seed).run();
}

}  // namespace mq::triangulate

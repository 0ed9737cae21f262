// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sprinkle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "triangulate/uv_triangle.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

// At saturation the edges between balls of radius 1 are 1.3 long on average: so that they are as long as the spacing.
constexpr double kClosest = 0.75;
// A cell is covered when one ball holds its corners; by so much it must, as the surface bulges between them.
constexpr double kCovered = 0.95;
// Smaller cells, in spacings, are no room for another sample.
constexpr double kLeastCell = 0.1;
constexpr int kMostDepth = 24;
constexpr std::size_t kRound = 1024;
constexpr std::size_t kBlock = 4096;

// A part of the face with its corners in the local frame.
struct Cell {
    int depth;
    double spacing;  // where the last dart in it or around it fell
    UvTriangle triangle;
};

class Sprinkler {
  public:
    Sprinkler(const SamplingContext& context, int face, const geometry::FaceBorder& border,
              const geometry::FaceTriangulation& coarse, std::uint64_t seed)
        : sampler_(context, face, border, kClosest), random_(seed + static_cast<std::uint64_t>(face)) {
        for (const auto& t : coarse.triangles) {
            Cell cell{0, context.bounds.most, {}};
            for (int i = 0; i < 3; ++i) {
                cell.triangle.uv[i] = coarse.sites[t[i]].uv;
                cell.triangle.point[i] = coarse.sites[t[i]].point;
            }
            cells_.push_back(cell);
        }
    }

    std::vector<FaceSampler::Candidate> run() {
        while (!cells_.empty() && !sampler_.full()) {
            shuffle();
            for (std::size_t from = 0; from < cells_.size() && !sampler_.full(); from += kRound) {
                sampler_.context().progress.check();
                throw_darts(from, std::min(cells_.size(), from + kRound));
            }
            quarter();
        }
        return sampler_.samples();
    }

  private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    // As std::shuffle, whose order differs from one library to the next; within blocks, so that cells that are near
    // each other stay so in memory.
    void shuffle() {
        for (std::size_t begin = 0; begin < cells_.size(); begin += kBlock) {
            const std::size_t size = std::min(kBlock, cells_.size() - begin);
            for (std::size_t i = size; i > 1; --i) {
                std::swap(cells_[begin + i - 1], cells_[begin + random_() % i]);
            }
        }
    }
    void throw_darts(std::size_t from, std::size_t to);
    bool covered(const Cell& cell) const;
    void quarter();

    FaceSampler sampler_;
    std::mt19937_64 random_;
    std::vector<Cell> cells_;
};

void Sprinkler::throw_darts(std::size_t from, std::size_t to) {
    std::vector<Vec2> uvs;
    for (std::size_t i = from; i < to; ++i) {
        double a = uniform();
        double b = uniform();
        if (a + b > 1.0) {
            a = 1.0 - a;
            b = 1.0 - b;
        }
        const std::array<Vec2, 3>& uv = cells_[i].triangle.uv;
        uvs.emplace_back(uv[0] + a * (uv[1] - uv[0]) + b * (uv[2] - uv[0]));
    }
    const auto darts = sampler_.candidates(uvs);
    for (std::size_t i = 0; i < darts.size(); ++i) {
        const auto& c = darts[i];
        if (!c) {
            continue;
        }
        cells_[from + i].spacing = c->spacing;
        if (c->fits && !sampler_.full() && !sampler_.crowded(c->site.point, c->spacing)) {
            sampler_.accept(*c);
        }
    }
}

bool Sprinkler::covered(const Cell& cell) const {
    return cell.triangle.longest_side() < kLeastCell * cell.spacing ||
           sampler_.one_ball_covers(cell.triangle.point, kCovered * cell.spacing);
}

void Sprinkler::quarter() {
    std::vector<Cell> open;
    Engine::Batch batch;
    for (const Cell& c : cells_) {
        if (c.depth < kMostDepth && !covered(c)) {
            open.push_back(c);
            for (int i = 0; i < 3; ++i) {
                const Vec2 uv = c.triangle.middle(i);
                batch.push_back(Query::face_point(sampler_.face(), uv.x(), uv.y()));
            }
        }
    }
    const Engine::Answers answers = sampler_.context().session.ask(std::move(batch));
    const Vec3 origin = sampler_.context().grid.origin();
    cells_.clear();
    for (std::size_t k = 0; k < open.size(); ++k) {
        const Cell& c = open[k];
        std::array<Vec3, 3> middles;
        for (int i = 0; i < 3; ++i) {
            middles[i] = answers[3 * k + i].point - origin;
        }
        for (const UvTriangle& quarter : c.triangle.quarters(middles)) {
            cells_.push_back({c.depth + 1, c.spacing, quarter});
        }
    }
    cells_.erase(std::remove_if(cells_.begin(), cells_.end(), [this](const Cell& c) { return covered(c); }),
                 cells_.end());
}

}  // namespace

std::vector<FaceSampler::Candidate> sample_sprinkle(const SamplingContext& context, int face,
                                                    const geometry::FaceBorder& border,
                                                    const geometry::FaceTriangulation& coarse, std::uint64_t seed) {
    return Sprinkler(context, face, border, coarse, seed).run();
}

}  // namespace mq::triangulate

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/face_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "base/parallel.h"
#include "geometry/elementary/surface_line.h"
#include "geometry/session.h"

namespace mq::layered_depth {

namespace {

using geometry::ElementarySurface;
using geometry::Query;

/// A point may be this many times as far from the triangle's plane as the mesh is from the faces, as that deviation was
/// measured at samples only.
constexpr double kDeviations = 4.0;
/// The rounding of vertices to single precision, as a fraction of the grid's side.
constexpr double kSinglePrecision = 1e-6;
/// A depth within this distance (grid units) of a node counts as at the node: faces of boxes that lie in planes of the
/// grid stay in these planes.
constexpr double kAtNode = 1e-9;
/// Samples between two checks for cancellation: some milliseconds of Newton's method.
constexpr std::size_t kBetweenChecks = 256;
/// Least number of samples of neighbouring triangles that one thread solves at a time.
constexpr std::size_t kSamplesPerChunk = 8192;
/// Chunks in one job of the engine's thread, so that other jobs are not delayed for long.
constexpr int kChunksPerWork = 4;

/// The triangle of a sample and the line of its ray, mm, in the frame of the model.
struct LineAtTriangle {
    std::int32_t triangle;
    Vec3 point;   // the present sample, on the line
    Vec3 normal;  // the triangle's normal
    Vec3 along;
    bool enters;
    double longest;  // the longest edge of the triangle
};

class FaceSampler {
  public:
    FaceSampler(LayeredDepthSet& set, const OperandSet& pair, const SampleGrid& grid, const Vec3& origin,
                const CadShape& shape, geometry::Engine& engine, const Progress* progress)
        : set_(set),
          pair_(pair),
          grid_(grid),
          origin_(origin),
          shape_(shape),
          session_(engine, shape.model, progress),
          progress_(progress),
          deviation_(kDeviations * std::max(shape.chord_height, 0.0) +
                     kSinglePrecision * grid.spacing() * grid.cells()) {}

    void run(FaceSampleCounts& counts);

  private:
    /// Newton's method for samples of neighbouring triangles.
    class NewtonSolver;

    void read_surfaces();
    void start_normals();
    std::size_t sample_count() const;
    std::size_t solve_all();
    std::size_t solve_inserted(const std::vector<SampleRef>& refs);
    bool solve_or_leave(const SampleRef& ref, bool inserted, std::vector<SampleRef>& others);
    std::vector<std::int32_t> order_of_triangles(int operand) const;
    std::vector<SampleRef> by_triangle(const std::vector<std::vector<SampleRef>>& rows) const;
    std::vector<std::size_t> chunks_of(const std::vector<SampleRef>& refs) const;
    std::size_t solve_by_newton(const std::vector<std::vector<SampleRef>>& rows, bool inserted);
    LineAtTriangle line_at(const SampleRef& ref) const;
    bool solve_by_formula(const SampleRef& ref, bool inserted);
    bool move_sample(const SampleRef& ref, const LineAtTriangle& line, double t, const Vec3& normal, bool inserted);
    std::int32_t face_of(const SampleRef& ref) const { return pair_.face[set_[ref.axis].triangle(ref.index)]; }
    Vec3 corner(std::int32_t triangle, int i) const { return origin_ + pair_.points[pair_.triangles[triangle][i]]; }

    LayeredDepthSet& set_;
    const OperandSet& pair_;
    const SampleGrid& grid_;
    Vec3 origin_;
    const CadShape& shape_;
    geometry::Session session_;
    const Progress* progress_;
    double deviation_;
    std::vector<std::optional<ElementarySurface>> surfaces_;  // by face
};

class FaceSampler::NewtonSolver {
  public:
    NewtonSolver(FaceSampler& sampler, geometry::Answerer& answerer) : sampler_(sampler), answerer_(answerer) {}

    bool solve(const SampleRef& ref, bool inserted);

  private:
    std::optional<Vec2> parameters_of(const Vec3& vertex) const;
    std::optional<std::array<Vec2, 3>> find_corners();

    FaceSampler& sampler_;
    geometry::Answerer& answerer_;
    std::int32_t face_ = -1, triangle_ = -1;             // face and triangle of the last sample
    std::unordered_map<std::int32_t, Vec2> parameters_;  // by vertex: its parameters on that face
    std::optional<std::array<Vec2, 3>> corners_;
};

void FaceSampler::read_surfaces() {
    surfaces_.resize(session_.topology().faces.size());
    session_.run([&](geometry::Model& model) {
        for (const std::int32_t face : *shape_.faces) {
            if (face < 0) {
                continue;
            }
            auto& surface = surfaces_[static_cast<std::size_t>(face)];
            if (!surface) {
                surface = model.elementary_surface(face);
            }
        }
    });
}

void FaceSampler::start_normals() {
    for (LayeredDepthImage& image : set_) {
        image.normal.resize(image.depth.size());
        parallel_for(grid_.rays(), [&](int row) {
            const auto first = static_cast<std::size_t>(row) * grid_.rays();
            for (std::uint32_t i = image.begin[first]; i < image.begin[first + grid_.rays()]; ++i) {
                image.normal[i] = pair_.unit_normal(image.triangle(i)).cast<float>();
            }
        });
    }
}

LineAtTriangle FaceSampler::line_at(const SampleRef& ref) const {
    const LayeredDepthImage& image = set_[ref.axis];
    LineAtTriangle line;
    line.triangle = image.triangle(ref.index);
    line.enters = image.code[ref.index] >= 0;
    Vec3 g;
    g[ref.axis] = image.depth[ref.index];
    g[(ref.axis + 1) % 3] = static_cast<double>(ref.ray % grid_.rays());
    g[(ref.axis + 2) % 3] = static_cast<double>(ref.ray / grid_.rays());
    line.point = grid_.to_space(g) + origin_;
    line.along = Vec3::Unit(ref.axis);
    line.normal = pair_.unit_normal(line.triangle);
    const Vec3 a = corner(line.triangle, 0), b = corner(line.triangle, 1), c = corner(line.triangle, 2);
    line.longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    return line;
}

/// Moves a sample along its ray. Refused if the surface is crossed in the other direction than the triangle, or if the
/// point is too far from the triangle (for an inserted sample: outside of its interval).
bool FaceSampler::move_sample(const SampleRef& ref, const LineAtTriangle& line, double t, const Vec3& normal,
                              bool inserted) {
    LayeredDepthImage& image = set_[ref.axis];
    const Vec3 outward = normal.dot(line.normal) < 0.0 ? Vec3(-normal) : normal;
    const double turn = outward.dot(line.along);
    if (line.enters ? turn > 0.0 : turn < 0.0) {
        return false;
    }
    double depth = image.depth[ref.index] + t / grid_.spacing();
    if (std::abs(depth - std::round(depth)) < kAtNode) {
        depth = std::round(depth);
    }
    if (inserted ? std::ceil(depth) != std::ceil(image.depth[ref.index])
                 : std::abs(t) > line.longest + deviation_ || std::abs(t * line.normal.dot(line.along)) > deviation_) {
        return false;
    }
    image.depth[ref.index] = depth;
    image.normal[ref.index] = outward.cast<float>();
    return true;
}

bool FaceSampler::solve_by_formula(const SampleRef& ref, bool inserted) {
    const ElementarySurface& surface = *surfaces_[static_cast<std::size_t>(face_of(ref))];
    const LineAtTriangle line = line_at(ref);
    const geometry::LineRoots roots = geometry::line_roots(surface, line.point, line.along);
    std::array<double, 4> t = roots.t;
    std::sort(t.begin(), t.begin() + roots.count, [](double a, double b) { return std::abs(a) < std::abs(b); });
    for (int i = 0; i < roots.count; ++i) {
        const double root = t[static_cast<std::size_t>(i)];
        const Vec3 normal = geometry::normal_near(surface, line.point + root * line.along);
        if (normal != Vec3::Zero() && move_sample(ref, line, root, normal, inserted)) {
            return true;
        }
    }
    return false;
}

/// Solves a sample whose face has a closed form; samples of other faces are added to `others`.
bool FaceSampler::solve_or_leave(const SampleRef& ref, bool inserted, std::vector<SampleRef>& others) {
    const std::int32_t face = face_of(ref);
    if (face >= 0 && surfaces_[static_cast<std::size_t>(face)]) {
        return solve_by_formula(ref, inserted);
    }
    if (face >= 0) {
        others.push_back(ref);
    }
    return false;
}

/// The parameters of a vertex of the mesh on the face: by Newton's method from the parameters of a neighbouring vertex;
/// if that fails, by a search.
std::optional<Vec2> FaceSampler::NewtonSolver::parameters_of(const Vec3& vertex) const {
    const mesh::Triangle& triangle = sampler_.pair_.triangles[triangle_];
    const auto known = std::find_if(triangle.begin(), triangle.end(),
                                    [&](std::int32_t other) { return parameters_.count(other) != 0; });
    if (known != triangle.end()) {
        const Vec2& guess = parameters_.at(*known);
        const geometry::Answer answer = answerer_.answer(Query::face_nearest(face_, vertex, guess.x(), guess.y()));
        if (answer.found() && answer.distance <= sampler_.deviation_) {
            return Vec2(answer.u, answer.v);
        }
    }
    const geometry::Answer answer = answerer_.answer(Query::face_nearest_global(face_, vertex));
    return answer.found() ? std::optional(Vec2(answer.u, answer.v)) : std::nullopt;
}

/// The parameters of the triangle's corners on its face, on one turn of a closed surface.
std::optional<std::array<Vec2, 3>> FaceSampler::NewtonSolver::find_corners() {
    std::array<Vec2, 3> result;
    const std::array<double, 2>& period = sampler_.session_.topology().faces[static_cast<std::size_t>(face_)].period;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t vertex = sampler_.pair_.triangles[triangle_][i];
        if (parameters_.count(vertex) == 0) {
            const std::optional<Vec2> found = parameters_of(sampler_.origin_ + sampler_.pair_.points[vertex]);
            if (!found) {
                return std::nullopt;
            }
            parameters_.emplace(vertex, *found);
        }
        result[i] = parameters_.at(vertex);
        for (Eigen::Index k = 0; k < 2; ++k) {
            result[i][k] = geometry::branch_nearest(result[i][k], result[0][k], period[static_cast<std::size_t>(k)]);
        }
    }
    return result;
}

bool FaceSampler::NewtonSolver::solve(const SampleRef& ref, bool inserted) {
    const LineAtTriangle line = sampler_.line_at(ref);
    if (sampler_.face_of(ref) != face_) {
        face_ = sampler_.face_of(ref);
        parameters_.clear();
        triangle_ = -1;
    }
    if (line.triangle != triangle_) {
        triangle_ = line.triangle;
        corners_ = find_corners();
    }
    const auto solved = [&](const Vec2& guess) {
        const geometry::Answer answer =
            answerer_.answer(Query::face_on_line(face_, line.point, line.along, guess.x(), guess.y()));
        return answer.status == geometry::Status::Ok &&
               sampler_.move_sample(ref, line, answer.t, answer.normal, inserted);
    };
    if (corners_) {
        const Vec3 a = sampler_.corner(triangle_, 0);
        const Vec3 b = sampler_.corner(triangle_, 1) - a, c = sampler_.corner(triangle_, 2) - a;
        const Vec3 n = b.cross(c), p = line.point - a;
        const double square = n.squaredNorm();
        if (square > 0.0) {
            const double at_b = p.cross(c).dot(n) / square, at_c = b.cross(p).dot(n) / square;
            const auto& uv = *corners_;
            if (solved(uv[0] + at_b * (uv[1] - uv[0]) + at_c * (uv[2] - uv[0]))) {
                return true;
            }
        }
    }
    const geometry::Answer nearest = answerer_.answer(Query::face_nearest_global(face_, line.point));
    return nearest.found() && solved(Vec2(nearest.u, nearest.v));
}

/// Numbers the triangles of an operand on faces without a closed form in the order of a breadth-first search over
/// shared vertices. So the parameters of most corners are found from those of a triangle that was solved shortly
/// before.
std::vector<std::int32_t> FaceSampler::order_of_triangles(int operand) const {
    const std::int32_t first = pair_.first_triangle[operand], end = pair_.first_gap[operand];
    const auto has_formula = [&](std::int32_t t) {
        return pair_.face[t] < 0 || surfaces_[static_cast<std::size_t>(pair_.face[t])].has_value();
    };
    std::vector<std::uint32_t> begin(pair_.points.size() + 1, 0);  // start of the triangles at each point
    std::vector<std::int32_t> at;
    for (std::int32_t t = first; t < end; ++t) {
        for (const std::int32_t p : pair_.triangles[t]) {
            begin[static_cast<std::size_t>(p) + 1] += has_formula(t) ? 0 : 1;
        }
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    at.resize(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::int32_t t = first; t < end; ++t) {
        for (const std::int32_t p : pair_.triangles[t]) {
            if (!has_formula(t)) {
                at[next[p]++] = t;
            }
        }
    }
    std::vector<std::int32_t> order(pair_.triangles.size(), -1), queue;
    const auto reach = [&](std::int32_t t) {
        if (order[t] < 0) {
            order[t] = static_cast<std::int32_t>(queue.size());
            queue.push_back(t);
        }
    };
    std::size_t done = 0;
    for (std::int32_t t = first; t < end; ++t) {
        if (!has_formula(t)) {
            reach(t);
        }
        for (; done < queue.size(); ++done) {
            for (const std::int32_t p : pair_.triangles[queue[done]]) {
                for (std::uint32_t i = begin[p]; i < begin[p + 1]; ++i) {
                    if (pair_.face[at[i]] == pair_.face[queue[done]]) {
                        reach(at[i]);
                    }
                }
            }
        }
    }
    return order;
}

/// Groups the samples by triangle, so that the parameters of its corners are found once.
std::vector<SampleRef> FaceSampler::by_triangle(const std::vector<std::vector<SampleRef>>& rows) const {
    const auto some = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return !row.empty(); });
    if (some == rows.end()) {
        return {};
    }
    const auto triangle = [&](const SampleRef& ref) { return set_[ref.axis].triangle(ref.index); };
    const std::vector<std::int32_t> order = order_of_triangles(pair_.operand_of(triangle(some->front())));
    std::vector<std::uint32_t> place(pair_.triangles.size() + 1, 0);
    for (const std::vector<SampleRef>& row : rows) {
        check_cancelled(progress_);
        for (const SampleRef& ref : row) {
            ++place[static_cast<std::size_t>(order[triangle(ref)]) + 1];
        }
    }
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<SampleRef> sorted(place.back());
    for (const std::vector<SampleRef>& row : rows) {
        check_cancelled(progress_);
        for (const SampleRef& ref : row) {
            sorted[place[order[triangle(ref)]]++] = ref;
        }
    }
    return sorted;
}

/// The first sample of each chunk, and the number of all. The samples of a triangle are in one chunk.
std::vector<std::size_t> FaceSampler::chunks_of(const std::vector<SampleRef>& refs) const {
    const auto triangle = [&](std::size_t i) { return set_[refs[i].axis].triangle(refs[i].index); };
    std::vector<std::size_t> begin{0};
    for (std::size_t i = 1; i < refs.size(); ++i) {
        if (i - begin.back() >= kSamplesPerChunk && triangle(i) != triangle(i - 1)) {
            begin.push_back(i);
        }
    }
    begin.push_back(refs.size());
    return begin;
}

/// @return the number of samples that were put on their faces
std::size_t FaceSampler::solve_by_newton(const std::vector<std::vector<SampleRef>>& rows, bool inserted) {
    const std::vector<SampleRef> refs = by_triangle(rows);
    const std::vector<std::size_t> begin = chunks_of(refs);
    const int chunks = refs.empty() ? 0 : static_cast<int>(begin.size()) - 1;
    std::vector<std::size_t> solved(begin.size(), 0);
    for (int from = 0; from < chunks; from += kChunksPerWork) {
        session_.run_parallel(std::min(kChunksPerWork, chunks - from), [&](geometry::Answerer& answerer, int k) {
            const auto chunk = static_cast<std::size_t>(from + k);
            NewtonSolver solver(*this, answerer);
            std::size_t count = 0;
            for (std::size_t i = begin[chunk]; i < begin[chunk + 1]; ++i) {
                if (i % kBetweenChecks == 0) {
                    check_cancelled(progress_);
                }
                count += solver.solve(refs[i], inserted) ? 1 : 0;
            }
            solved[chunk] = count;
        });
    }
    return std::accumulate(solved.begin(), solved.end(), std::size_t{0});
}

std::size_t FaceSampler::solve_all() {
    const int rays = grid_.rays();
    std::vector<std::size_t> solved(3 * static_cast<std::size_t>(rays), 0);
    std::vector<std::vector<SampleRef>> others(solved.size());
    parallel_for(static_cast<int>(solved.size()), [&](int k) {
        check_cancelled(progress_);
        const auto row = static_cast<std::size_t>(k);
        const int axis = k / rays;
        const LayeredDepthImage& image = set_[axis];
        std::size_t count = 0;  // number of samples; each thread has its own while it works
        std::vector<SampleRef> left;
        for (int u = 0; u < rays; ++u) {
            const auto ray = static_cast<std::uint32_t>(k % rays * rays + u);
            for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
                count += solve_or_leave({axis, ray, i}, false, left) ? 1 : 0;
            }
        }
        solved[row] = count;
        others[row] = std::move(left);
    });
    return std::accumulate(solved.begin(), solved.end(), solve_by_newton(others, false));
}

std::size_t FaceSampler::solve_inserted(const std::vector<SampleRef>& refs) {
    std::size_t solved = 0;
    std::vector<std::vector<SampleRef>> others(1);
    for (const SampleRef& ref : refs) {
        solved += solve_or_leave(ref, true, others[0]) ? 1 : 0;
    }
    return solved + solve_by_newton(others, true);
}

std::size_t FaceSampler::sample_count() const {
    std::size_t count = 0;
    for (const LayeredDepthImage& image : set_) {
        count += image.depth.size();
    }
    return count;
}

void FaceSampler::run(FaceSampleCounts& counts) {
    read_surfaces();
    start_normals();
    std::size_t on_mesh = sample_count() - solve_all();
    for (LayeredDepthImage& image : set_) {
        counts.passed += restore_order(image);
    }
    const std::vector<SampleRef> inserted = make_consistent(set_, grid_, counts.nodes, progress_);
    on_mesh += inserted.size() - solve_inserted(inserted);
    counts.on_mesh += on_mesh;
    counts.on_faces += sample_count() - std::min(on_mesh, sample_count());
}

}  // namespace

void sample_faces(LayeredDepthSet& set, const OperandSet& pair, const SampleGrid& grid, const Vec3& origin,
                  const CadShape& shape, geometry::Engine& engine, FaceSampleCounts& counts, const Progress* progress) {
    FaceSampler(set, pair, grid, origin, shape, engine, progress).run(counts);
}

}  // namespace mq::layered_depth

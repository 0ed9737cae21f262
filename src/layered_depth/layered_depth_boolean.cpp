// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/layered_depth_boolean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <numeric>

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "boolean/input/operand_repair.h"
#include "boolean/input/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "layered_depth/layered_depth_operand.h"
#include "layered_depth/reconstruction/border_stitching.h"
#include "layered_depth/reconstruction/contour.h"
#include "layered_depth/reconstruction/face_projection.h"
#include "layered_depth/reconstruction/node_open.h"
#include "layered_depth/reconstruction/tuning.h"
#include "layered_depth/samples/rasterise.h"
#include "layered_depth/samples/sample_clustering.h"
#include "mesh/polygon_triangulation.h"

namespace mq::layered_depth {

using boolean::Expression;
using boolean::Operation;

namespace {

/// The paper's error bound in units of r: the diagonal of a cell (section IV-A).
const double kBound = std::sqrt(3.0);
/// Least number of rays along a side: with fewer than 2^3 cells no shape is recognisable.
constexpr int kLowestResolution = 9;
/// Largest number of rays along a side, limited by the rasteriser's levels.
constexpr int kHighestResolution = (1 << kMaxLevels) + 1;

void require_options(const LayeredDepthOptions& options) {
    if (options.resolution < kLowestResolution || options.resolution > kHighestResolution) {
        throw InvalidInput(
            phrases::kNotAllowed,
            {{"option", "resolution"},
             {"value", std::to_string(options.resolution)},
             {"range", Message(phrases::kFromTo, {{"number", kLowestResolution}, {"number2", kHighestResolution}})}});
    }
    if (!(options.thinnest >= 0.0 && options.thinnest < 0.01)) {
        throw InvalidInput(
            phrases::kNotAllowed,
            {{"option", "thinnest"}, {"value", in_digits(options.thinnest, 6)}, {"range", phrases::kShareOfSide}});
    }
}

Box box_of(const mesh::TriangleMesh& mesh) {
    Box box;
    for (const mesh::Triangle& t : mesh.triangles) {
        for (const std::int32_t p : t) {
            box.add(mesh.vertices[p]);
        }
    }
    return box;
}

/// The box in which the result can lie; empty if the result is.
Box working_box(const std::vector<UniformOperand>& operands, const Expression& expression) {
    return expression.fold<Box>([&](int operand) { return box_of(operands[static_cast<std::size_t>(operand)].mesh()); },
                                [](Operation operation, Box box, const Box& other) {
                                    if (operation == Operation::Intersection) {
                                        box.low = box.low.cwiseMax(other.low);
                                        box.high = box.high.cwiseMin(other.high);
                                    } else if (operation != Operation::Difference) {
                                        box.add(other);
                                    }
                                    return (box.low.array() > box.high.array()).any() ? Box() : box;
                                });
}

/// The memory of a sample of meshes, in bytes: 12 in the result, 4 for the octree's copies of a layer.
constexpr double kBytesPerSample = 16.0;
/// Bytes: the largest memory of a sample if rays must agree before they are combined: 24 bytes, and 16 more for copies
/// of one direction while its rays are sorted.
constexpr double kBytesPerFaceSample = 40.0;
/// Bytes of a ray: offsets into the samples of three directions, for the result and for each operand whose rays must
/// agree.
constexpr double kBytesPerRay = 3.0 * sizeof(std::uint32_t);
/// The most memory for samples, in bytes: 2 GB.
constexpr double kMostBytes = 2.0 * (1 << 30);

/// Estimates the number of samples on the rays of the grid: for each triangle in each direction its projected area, but
/// at most the area of its box within the grid.
double count_samples_about(const OperandSet& pair, const SampleGrid& grid) {
    double count = 0.0;
    for (const mesh::Triangle& t : pair.triangles) {
        const std::array<Vec3, 3> p = {grid.to_grid(pair.points[t[0]]), grid.to_grid(pair.points[t[1]]),
                                       grid.to_grid(pair.points[t[2]])};
        const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]).cwiseMax(0.0);
        const Vec3 high = p[0].cwiseMax(p[1]).cwiseMax(p[2]).cwiseMin(static_cast<double>(grid.cells()));
        const Vec3 side = (high - low).cwiseMax(0.0);
        const Vec3 area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).cwiseAbs();
        for (int a = 0; a < 3; ++a) {
            count += std::min(area[a], side[(a + 1) % 3] * side[(a + 2) % 3]);
        }
    }
    return count;
}

/// @param with_normals  each sample has a normal
double bytes_about(const OperandSet& pair, const SampleGrid& grid, bool with_normals) {
    const double rays = grid.rays();
    return (with_normals ? kBytesPerFaceSample : kBytesPerSample) * count_samples_about(pair, grid) +
           kBytesPerRay * (with_normals ? pair.size() + 1 : 1) * rays * rays;
}

/// @throws InvalidInput naming the largest resolution within the memory
void require_memory(const OperandSet& pair, const Box& box, int resolution, bool with_normals) {
    const SampleGrid asked(box, resolution);
    const double bytes = bytes_about(pair, asked, with_normals);
    if (!(bytes > kMostBytes)) {
        return;
    }
    int possible = asked.rays();
    double least = bytes;
    while (possible > kLowestResolution && least > kMostBytes) {
        possible = (possible - 1) / 2 + 1;
        least = bytes_about(pair, SampleGrid(box, possible), with_normals);
    }
    const double side = box.empty() ? 0.0 : box.largest_side();
    const auto in_gb = [](double b) { return in_digits(b / (1 << 30), 2); };
    throw InvalidInput(phrases::kMuchMemory, {{"number", in_gb(bytes)},
                                              {"count", resolution},
                                              {"number2", in_gb(kMostBytes)},
                                              {"count2", possible},
                                              {"length", in_mm(uniform_bound(side, possible))}});
}

std::vector<const mesh::TriangleMesh*> meshes_of(const std::vector<UniformOperand>& operands) {
    std::vector<const mesh::TriangleMesh*> meshes;
    for (const UniformOperand& operand : operands) {
        meshes.push_back(&operand.mesh());
    }
    return meshes;
}

std::vector<std::vector<mesh::Triangle>> borders_of(const std::vector<UniformOperand>& operands) {
    std::vector<std::vector<mesh::Triangle>> borders;
    for (const UniformOperand& operand : operands) {
        borders.push_back(operand.open() ? operand.winding().border() : std::vector<mesh::Triangle>());
    }
    return borders;
}

/// One run of the method, with its stages in their order.
class LayeredDepthBoolean {
  public:
    LayeredDepthBoolean(const std::vector<UniformOperand>& prepared, const Expression& expression,
                        const LayeredDepthOptions& options, const CadOperands& cad, Progress* progress)
        : prepared_(prepared),
          expression_(expression),
          options_(options),
          cad_(cad),
          progress_(progress),
          pair_(meshes_of(prepared), borders_of(prepared)),
          grid_(working_box(prepared, expression), options.resolution),
          operands_(prepared.size()) {
        for (std::size_t k = 0; k < prepared.size(); ++k) {
            open_ = open_ || prepared[k].open();
            add_shape(cad.shapes.empty() ? CadShape() : cad.shapes[k], prepared[k]);
            result_.repaired.push_back(prepared[k].repaired());
            result_.open.push_back(prepared[k].open() ? 1 : 0);
        }
        name_faces();
        require_memory(pair_, working_box(prepared, expression), options.resolution, has_shapes_ || open_);
        result_.mesh.origin = prepared.front().mesh().origin;
        result_.spacing = grid_.spacing();
    }

    UniformResult run();

  private:
    void stage(const char* name, double from, double to, const std::function<void()>& work);
    void add_shape(CadShape shape, const UniformOperand& operand);
    void name_faces();
    void sample_result();
    void sample();
    void count();
    void sample_cad();
    void sample_open();
    CombineOptions combine_options() const;
    void combine_closed_meshes();
    void combine_samples();
    void count_combined();
    void cluster_triangles();
    void contour_cells();
    void project();
    void make_manifold();
    void fill(const std::vector<std::int32_t>& hole, EdgeSet& edges);
    void assemble();

    const std::vector<UniformOperand>& prepared_;
    const Expression& expression_;
    LayeredDepthOptions options_;
    const CadOperands& cad_;
    Progress* progress_;
    OperandSet pair_;
    SampleGrid grid_;
    std::vector<CadShape> sampled_shapes_;         // by operand; without a model if its mesh is sampled
    std::deque<std::vector<std::int32_t>> faces_;  // the CAD faces of their triangles
    bool has_shapes_ = false, open_ = false;
    std::vector<LayeredDepthSet> operands_;
    std::vector<std::uint32_t> sample_count_;
    std::vector<std::int32_t> region_;
    CombinedSet combined_;
    std::vector<Retention> fate_;
    RetainedSurface surface_;  // contains all triangles of the result at the end
    Octree octree_;
    std::vector<std::int32_t> sheet_vertex_;
    std::vector<mesh::Triangle> reconstructed_;
    UniformResult result_;
    StageTimer clock_{result_.seconds};
};

void LayeredDepthBoolean::stage(const char* name, double from, double to, const std::function<void()>& work) {
    if (progress_ != nullptr) {
        progress_->stage(name, from, to);
        progress_->check();
    }
    work();
    clock_.end(name);
}

void LayeredDepthBoolean::add_shape(CadShape shape, const UniformOperand& operand) {
    if (shape.model) {
        faces_.push_back(operand.faces(*shape.faces));
        shape.faces = &faces_.back();
    }
    sampled_shapes_.push_back(shape.model && !shape.faces->empty() ? shape : CadShape());
    has_shapes_ = has_shapes_ || sampled_shapes_.back().model != nullptr;
}

void LayeredDepthBoolean::name_faces() {
    for (std::size_t k = 0; k < prepared_.size() && has_shapes_; ++k) {
        pair_.face.resize(static_cast<std::size_t>(pair_.first_triangle[k + 1]), -1);
        if (sampled_shapes_[k].model) {
            std::copy(sampled_shapes_[k].faces->begin(), sampled_shapes_[k].faces->end(),
                      pair_.face.begin() + pair_.first_triangle[k]);
        }
    }
}

void LayeredDepthBoolean::sample_cad() {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
        if (sampled_shapes_[k].model) {
            sample_faces(operands_[k], pair_, grid_, result_.mesh.origin, sampled_shapes_[k], *cad_.engine, result_.cad,
                         progress_);
        }
    }
}

void LayeredDepthBoolean::sample_open() {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
        if (prepared_[k].open()) {
            sample_by_winding(operands_[k], pair_, static_cast<int>(k), grid_, prepared_[k].winding(), result_.winding,
                              progress_);
        }
    }
}

void LayeredDepthBoolean::project() {
    const FaceProjection projection = project_onto_faces(surface_, reconstructed_, octree_, sheet_vertex_, pair_, grid_,
                                                         result_.mesh.origin, sampled_shapes_, *cad_.engine, progress_);
    result_.fitted = projection.moved;
    result_.unfitted = projection.left;
}

void LayeredDepthBoolean::sample() {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
        operands_[k] = rasterise(pair_, static_cast<int>(k), grid_, progress_);
    }
}

void LayeredDepthBoolean::count() {
    for (const LayeredDepthSet& operand : operands_) {
        for (const LayeredDepthImage& direction : operand) {
            result_.samples += direction.depth.size();
        }
    }
}

CombineOptions LayeredDepthBoolean::combine_options() const {
    CombineOptions options;
    options.expression = expression_;
    options.thinnest = options_.thinnest * grid_.cells();
    options.normal_index = options_.normal_index;
    return options;
}

/// Samples and combines in one pass if all operands are closed meshes.
void LayeredDepthBoolean::combine_closed_meshes() {
    SampleCounts counts(pair_.triangles.size());
    combined_ = combine_meshes(pair_, grid_, combine_options(), counts, progress_);
    sample_count_.assign(counts.begin(), counts.end());
    result_.samples = std::accumulate(sample_count_.begin(), sample_count_.end(), std::size_t{0});
}

void LayeredDepthBoolean::combine_samples() {
    combined_ = combine(pair_, std::move(operands_), grid_, combine_options(), progress_);
}

void LayeredDepthBoolean::count_combined() {
    for (const CombinedDepth& direction : combined_) {
        result_.result_samples += direction.depth.size();
        result_.guessed_samples += static_cast<std::size_t>(
            std::count_if(direction.source.begin(), direction.source.end(),
                          [&](std::int32_t source) { return pair_.is_gap(CombinedDepth::triangle(source)); }));
    }
}

void LayeredDepthBoolean::contour_cells() {
    ContouredSurface contoured = contour(pair_, octree_, grid_, combined_, fate_, sheet_vertex_, surface_, progress_);
    reconstructed_ = std::move(contoured.triangles);
    sheet_vertex_ = std::move(contoured.vertices);
    result_.refused_triangles = contoured.refused;
    result_.reconstructed = reconstructed_.size();
}

/// Fills one hole. If all triangulations of its corners would use an edge twice, with a fan around a new point.
void LayeredDepthBoolean::fill(const std::vector<std::int32_t>& hole, EdgeSet& edges) {
    std::vector<Vec3> loop;
    loop.reserve(hole.size());
    for (const std::int32_t p : hole) {
        loop.push_back(surface_.points[p]);
    }
    const auto n = static_cast<std::int32_t>(hole.size());
    const auto taken = [&](std::int32_t i, std::int32_t j) {
        const bool side = (i + 1) % n == j || (j + 1) % n == i;
        return !side && (loop[i] == loop[j] || edges.has(hole[i], hole[j]) || edges.has(hole[j], hole[i]));
    };
    const auto avoid = [&](const mesh::Triangle& t) {
        return taken(t[0], t[1]) || taken(t[1], t[2]) || taken(t[2], t[0]);
    };
    std::vector<mesh::Triangle> filling = mesh::fill_hole(loop, avoid, progress_);
    const bool reuses = std::any_of(filling.begin(), filling.end(), avoid);
    std::vector<std::int32_t> corners = hole;
    if (reuses) {
        filling.clear();
        Vec3 centre = Vec3::Zero();
        for (const Vec3& p : loop) {
            centre += p / static_cast<double>(loop.size());
        }
        corners.push_back(static_cast<std::int32_t>(surface_.points.size()));
        surface_.points.push_back(to_single(centre));
        for (std::int32_t i = 0; i < n; ++i) {
            filling.push_back({i, (i + 1) % n, n});
        }
    }
    for (const mesh::Triangle& t : filling) {
        const mesh::Triangle filled{corners[t[0]], corners[t[1]], corners[t[2]]};
        edges.add(filled);
        surface_.triangles.push_back(filled);
        surface_.source.push_back(-1);
    }
    ++result_.holes_filled;
    result_.hole_triangles += filling.size();
    result_.largest_hole = std::max(result_.largest_hole, hole.size());
}

/// Applies Node-Open, then fills the holes (section III-C). Only triangles around the border and new ones can need it.
void LayeredDepthBoolean::make_manifold() {
    std::vector<std::uint8_t> candidate = surface_.on_border;
    for (const mesh::Triangle& t : reconstructed_) {
        for (const std::int32_t p : t) {
            candidate[p] = 1;
        }
    }
    std::vector<std::int32_t> place;
    std::vector<mesh::Triangle> active;
    for (std::size_t k = 0; k < surface_.triangles.size(); ++k) {
        const mesh::Triangle& t = surface_.triangles[k];
        if (candidate[t[0]] != 0 || candidate[t[1]] != 0 || candidate[t[2]] != 0) {
            place.push_back(static_cast<std::int32_t>(k));
            active.push_back(t);
        }
    }
    active.insert(active.end(), reconstructed_.begin(), reconstructed_.end());
    const auto first_copy = static_cast<std::int32_t>(surface_.points.size());
    const std::vector<std::int32_t> originals = open_nodes(surface_.points, active, candidate);
    result_.opened_nodes = originals.size();
    candidate.resize(surface_.points.size(), 1);
    for (std::size_t k = 0; k < place.size(); ++k) {
        surface_.triangles[place[k]] = active[k];
    }
    const std::size_t first_reconstructed = surface_.triangles.size();
    surface_.triangles.insert(surface_.triangles.end(), active.begin() + static_cast<std::ptrdiff_t>(place.size()),
                              active.end());
    surface_.source.resize(surface_.triangles.size(), -1);
    const std::size_t first_filling = surface_.triangles.size();
    const std::vector<std::vector<std::int32_t>> holes = find_holes(active, candidate);
    EdgeSet edges;
    if (!holes.empty()) {
        for (const mesh::Triangle& t : active) {
            edges.add(t);
        }
    }
    for (const std::vector<std::int32_t>& hole : holes) {
        fill(hole, edges);
        check_cancelled(progress_);
    }
    candidate.resize(surface_.points.size(), 1);
    for (const std::size_t k : drop_opposite_duplicates(surface_.triangles, surface_.source, candidate)) {
        if (k >= first_filling) {  // the reverse of a triangle without neighbours, which had the hole around it
            --result_.hole_triangles;
            --result_.holes_filled;
        } else if (k >= first_reconstructed) {
            --result_.reconstructed;
        }
    }
    separate_nodes(surface_.points, surface_.triangles, surface_.source, originals, first_copy,
                   ReconstructionTuning::kParting * grid_.spacing());
}

/// Drops unused points and names the sources.
void LayeredDepthBoolean::assemble() {
    std::vector<std::int32_t> index(surface_.points.size(), -1);
    mesh::TriangleMesh& mesh = result_.mesh;
    for (const mesh::Triangle& t : surface_.triangles) {
        for (const std::int32_t p : t) {
            index[p] = 0;
        }
    }
    for (std::size_t p = 0; p < index.size(); ++p) {
        if (index[p] == 0) {
            index[p] = static_cast<std::int32_t>(mesh.vertices.size());
            mesh.vertices.push_back(surface_.points[p]);
        }
    }
    mesh.triangles.reserve(surface_.triangles.size());
    result_.triangle_source.reserve(surface_.triangles.size());
    std::size_t repaired = 0;  // number of triangles that the repair of an operand made or changed
    for (std::size_t k = 0; k < surface_.triangles.size(); ++k) {
        const mesh::Triangle& t = surface_.triangles[k];
        mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
        const std::int32_t source = surface_.source[k];
        if (source < 0) {
            result_.triangle_source.push_back({-1, -1});
        } else {
            const int operand = pair_.operand_of(source);
            const std::int32_t own = prepared_[static_cast<std::size_t>(operand)].source(
                source - pair_.first_triangle[static_cast<std::size_t>(operand)]);
            result_.triangle_source.push_back(own < 0 ? std::array<std::int32_t, 2>{-1, -1}
                                                      : std::array<std::int32_t, 2>{operand, own});
            (own < 0 ? repaired : result_.retained) += 1;
        }
    }
    const std::size_t made = mesh.triangles.size() - result_.retained;
    result_.changed = made - result_.reconstructed - result_.hole_triangles;
    result_.error_bound = made > repaired ? kBound * grid_.spacing() : 0.0;
    double moved = 0.0;
    for (const UniformOperand& operand : prepared_) {
        moved = std::max(moved, operand.largest_move());
    }
    result_.error_bound += moved;
}

void LayeredDepthBoolean::cluster_triangles() {
    const std::vector<std::uint8_t> beyond = triangles_beyond(pair_, grid_);
    region_ = cluster(pair_, sample_count_, beyond);
    for (std::size_t t = 0; t < region_.size(); ++t) {
        const bool gap = pair_.is_gap(static_cast<std::int32_t>(t));
        result_.unsampled_triangles += region_[t] < 0 && beyond[t] == 0 && !gap ? 1 : 0;
    }
}

/// Computes the samples of the result. Samples of the operands are released as soon as they are combined.
void LayeredDepthBoolean::sample_result() {
    if (!has_shapes_ && !open_) {
        stage("sampling", 0.0, 0.45, [&] { combine_closed_meshes(); });
        stage("clustering", 0.45, 0.5, [&] { cluster_triangles(); });
        return;
    }
    stage("sampling", 0.0, 0.1, [&] { sample(); });
    if (has_shapes_) {
        stage("sampling CAD faces", 0.1, open_ ? 0.2 : 0.3, [&] { sample_cad(); });
    }
    count();
    stage("clustering", 0.3, 0.35, [&] {
        sample_count_ = count_samples(pair_, operands_);
        cluster_triangles();
    });
    if (open_) {  // after the samples of triangles were counted: a triangle that loses some of them is not retained
        stage("winding numbers", 0.35, 0.4, [&] { sample_open(); });
    }
    stage("Boolean of samples", open_ ? 0.4 : 0.35, 0.5, [&] { combine_samples(); });
}

UniformResult LayeredDepthBoolean::run() {
    sample_result();
    count_combined();
    stage("membership", 0.5, 0.6, [&] {
        fate_ = options_.full ? std::vector<Retention>(pair_.triangles.size(), Retention::Removed)
                              : classify(pair_, sample_count_, region_, combined_);
        surface_ = retained_surface(pair_, fate_);
    });
    stage("octree", 0.6, 0.75, [&] { octree_ = build_octree(pair_, grid_, combined_, fate_, surface_, progress_); });
    stage("stitching", 0.75, 0.8, [&] {
        StitchCounts counts;
        sheet_vertex_ = stitch(octree_, grid_, surface_, counts);
        result_.cells = octree_.leaves.size();
        result_.boundary_cells = counts.boundary_cells;
        result_.complex_cells = counts.complex_cells;
        result_.split_edges = counts.split_edges;
        result_.collapsed_nodes = counts.collapsed_nodes;
        result_.moved_nodes = counts.moved_nodes;
        result_.left_nodes = counts.left_nodes;
    });
    stage("contouring", 0.8, 0.9, [&] { contour_cells(); });
    if (has_shapes_) {
        stage("fitting to the shapes", 0.9, 0.9, [&] { project(); });
    }
    stage("two-manifold", 0.9, 0.98, [&] { make_manifold(); });
    stage("assembly", 0.98, 1.0, [&] { assemble(); });
    return std::move(result_);
}

}  // namespace

std::vector<UniformOperand> prepare_uniform(const std::vector<const mesh::TriangleMesh*>& operands,
                                            const Expression& expression, const LayeredDepthOptions& options,
                                            const Progress* progress) {
    require_options(options);
    if (operands.empty() || expression.operands() != operands.size()) {
        throw InvalidInput(phrases::kExpressionOperands,
                           {{"count", operands.size()}, {"count2", expression.operands()}});
    }
    Box box;
    for (const mesh::TriangleMesh* operand : operands) {
        if (operand->origin != operands.front()->origin) {
            throw InvalidInput(phrases::kOrigins);
        }
        box.add(box_of(*operand));
    }
    const double reach =
        box.empty() ? 0.0 : boolean::InputTuning::kCrackShare * uniform_bound(box.largest_side(), options.resolution);
    std::vector<UniformOperand> prepared(operands.size());
    parallel_for(static_cast<int>(operands.size()), [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        prepared[i] = UniformOperand(*operands[i], boolean::operand_name(i, operands.size()), reach, progress);
    });
    return prepared;
}

UniformResult layered_depth_boolean(const std::vector<const mesh::TriangleMesh*>& operands,
                                    const Expression& expression, const LayeredDepthOptions& options,
                                    Progress* progress, const CadOperands& cad) {
    return layered_depth_boolean(prepare_uniform(operands, expression, options, progress), expression, options,
                                 progress, cad);
}

UniformResult layered_depth_boolean(const std::vector<UniformOperand>& prepared, const Expression& expression,
                                    const LayeredDepthOptions& options, Progress* progress, const CadOperands& cad) {
    return LayeredDepthBoolean(prepared, expression, options, cad, progress).run();
}

UniformResult layered_depth_boolean(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, Operation operation,
                                    const LayeredDepthOptions& options, Progress* progress) {
    return layered_depth_boolean({&a, &b}, Expression::chain(operation, 2), options, progress);
}

double uniform_bound(double size, int resolution) {
    return kBound * SampleGrid::spacing_of(size, resolution);
}

int uniform_resolution(double size, double tolerance) {
    const double least = uniform_bound(size, kHighestResolution);
    if (tolerance < least) {
        throw InvalidInput(phrases::kManyRays, {{"length", in_mm(tolerance, 6)}, {"length2", in_mm(least, 6)}});
    }
    const double wanted = SampleGrid::resolution_for(size, tolerance / kBound);
    int resolution = static_cast<int>(std::clamp<double>(wanted, kLowestResolution, kHighestResolution));
    while (uniform_bound(size, resolution) > tolerance) {
        ++resolution;  // compensates the rounding of the quotient
    }
    return resolution;
}

}  // namespace mq::layered_depth

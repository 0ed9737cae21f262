// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/layered_depth_boolean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "base/error.h"
#include "boolean/layered_depth/reconstruction/border_stitching.h"
#include "boolean/layered_depth/reconstruction/contour.h"
#include "boolean/layered_depth/reconstruction/face_projection.h"
#include "boolean/layered_depth/reconstruction/node_open.h"
#include "boolean/layered_depth/reconstruction/tuning.h"
#include "boolean/layered_depth/samples/rasterise.h"
#include "boolean/layered_depth/samples/sample_clustering.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"
#include "mesh/polygon_triangulation.h"

namespace mq::boolean {

namespace {

/// The paper's error bound in units of r: the diagonal of a cell (section IV-A).
const double kBound = std::sqrt(3.0);
/// The least rays along a side: 2^3 cells, fewer show no shape.
constexpr int kLowestResolution = 9;
/// The most rays along a side, as the rasteriser's levels allow.
constexpr int kHighestResolution = (1 << kMaxLevels) + 1;

void require_options(const UniformOptions& options) {
    if (options.resolution < kLowestResolution || options.resolution > kHighestResolution) {
        throw InvalidInput("resolution is " + std::to_string(options.resolution) + ": it must be from " +
                           std::to_string(kLowestResolution) + " to " + std::to_string(kHighestResolution) + " rays");
    }
    if (!(options.thinnest >= 0.0 && options.thinnest < 0.01)) {
        throw InvalidInput("thinnest is " + std::to_string(options.thinnest) +
                           ": it must be a fraction of the longest side, from 0 to less than 0.01");
    }
}

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

void require_valid(const mesh::TriangleMesh& mesh, const char* name) {
    try {
        mesh::require_valid(mesh);
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("operand ") + name + ": " + error.what());
    }
}

void require_closed(const mesh::TriangleMesh& mesh, const char* name) {
    if (edge_balance(mesh) == 0) {
        return;
    }
    const mesh::EdgeTable edges(mesh.triangles, mesh.vertices.size());
    edges.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
        std::ptrdiff_t up = 0;
        for (const std::uint32_t* c = first; c != last; ++c) {
            up += mesh.triangles[*c / 3][*c % 3] == low ? 1 : -1;
        }
        if (up != 0) {
            const Vec3 p = mesh.origin + 0.5 * (mesh.vertices[low] + mesh.vertices[high]);
            throw InvalidInput(std::string("operand ") + name + " is not closed or not oriented at (" +
                               std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) +
                               "), on the edge of vertices " + std::to_string(low) + " and " + std::to_string(high) +
                               "; fill its holes and turn its triangles outwards first");
        }
    });
}

/// A reversed operand would be all outside by the normal index, and vanish.
void require_outward(const mesh::TriangleMesh& mesh, const char* name) {
    double volume = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3& base = mesh.vertices[mesh.triangles.front()[0]];
        volume += (mesh.vertices[t[0]] - base).dot((mesh.vertices[t[1]] - base).cross(mesh.vertices[t[2]] - base));
    }
    if (volume < 0.0) {
        throw InvalidInput(std::string("operand ") + name + " is inside out (volume " + std::to_string(volume / 6.0) +
                           " mm3); turn its triangles outwards first");
    }
}

void require_operands(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    require_valid(a, "A");
    require_valid(b, "B");
    if (a.origin != b.origin) {
        throw InvalidInput("the operands have different origins; give both meshes in one frame");
    }
    require_closed(a, "A");
    require_closed(b, "B");
    require_outward(a, "A");
    require_outward(b, "B");
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

/// The box in which the result can lie; empty where there can be none.
Box working_box(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, Operation operation) {
    Box box = box_of(a);
    const Box other = box_of(b);
    if (operation == Operation::Intersection) {
        box.low = box.low.cwiseMax(other.low);
        box.high = box.high.cwiseMin(other.high);
    } else if (operation != Operation::Difference) {
        box.low = box.low.cwiseMin(other.low);
        box.high = box.high.cwiseMax(other.high);
    }
    return (box.low.array() > box.high.array()).any() ? Box() : box;
}

/// The largest memory of a sample, in bytes: sampling one operand, sorted samples of both, and those of the result.
constexpr double kBytesPerSample = 40.0;
/// The same with a normal for each: 24 bytes of an operand, 24 while rays are merged and 24 of the result.
constexpr double kBytesPerFaceSample = 72.0;
/// The memory of a ray, in bytes: offsets into the samples of three directions and three sets.
constexpr double kBytesPerRay = 9.0 * sizeof(std::uint32_t);
/// The most memory for samples, in bytes: 2 GB.
constexpr double kMostBytes = 2.0 * (1 << 30);

/// Estimates the number of samples on the rays of the grid: for each triangle in each direction its projected area, and
/// no more than the area of its box within the grid.
double count_samples_about(const OperandPair& pair, const SampleGrid& grid) {
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

double bytes_about(const OperandPair& pair, const SampleGrid& grid) {
    const double rays = grid.rays();
    return (pair.face.empty() ? kBytesPerSample : kBytesPerFaceSample) * count_samples_about(pair, grid) +
           kBytesPerRay * rays * rays;
}

/// @throws InvalidInput naming the largest resolution within the memory
void require_memory(const OperandPair& pair, const Box& box, int resolution) {
    const SampleGrid asked(box, resolution);
    const double bytes = bytes_about(pair, asked);
    if (!(bytes > kMostBytes)) {
        return;
    }
    int possible = asked.rays();
    double least = bytes;
    while (possible > kLowestResolution && least > kMostBytes) {
        possible = (possible - 1) / 2 + 1;
        least = bytes_about(pair, SampleGrid(box, possible));
    }
    const double side = box.empty() ? 0.0 : box.largest_side();
    const auto in_gb = [](double b) { return in_digits(b / (1 << 30), 2); };
    throw InvalidInput(
        Message::of(phrases::kMuchMemory, {{"number", in_gb(bytes)},
                                           {"count", std::to_string(resolution)},
                                           {"number2", in_gb(kMostBytes)},
                                           {"count2", std::to_string(possible)},
                                           {"length", in_digits(uniform_bound(side, possible), 4) + " mm"}}));
}

/// One run of the method; the stages in their order.
class LayeredDepthBoolean {
  public:
    LayeredDepthBoolean(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, Operation operation,
                        const UniformOptions& options, const CadOperands& cad, Progress* progress)
        : operation_(operation),
          options_(options),
          cad_(cad),
          progress_(progress),
          pair_(a, b),
          grid_(working_box(a, b, operation), options.resolution) {
        name_faces();
        require_memory(pair_, working_box(a, b, operation), options.resolution);
        result_.mesh.origin = a.origin;
        result_.spacing = grid_.spacing();
    }

    UniformResult run();

  private:
    void stage(const char* name, double from, double to, const std::function<void()>& work);
    void name_faces();
    void sample();
    void count();
    void sample_cad();
    void combine_samples();
    void contour_cells();
    void project();
    void make_manifold();
    void fill(const std::vector<std::int32_t>& hole, EdgeSet& edges);
    void assemble();

    Operation operation_;
    UniformOptions options_;
    const CadOperands& cad_;
    Progress* progress_;
    OperandPair pair_;
    SampleGrid grid_;
    std::array<LayeredDepthSet, 2> operands_;
    std::vector<std::uint32_t> sample_count_;
    std::vector<std::int32_t> region_;
    CombinedSet combined_;
    std::vector<Retention> fate_;
    RetainedSurface surface_;  // holds all triangles at the end
    Octree octree_;
    std::vector<std::int32_t> sheet_vertex_;
    std::vector<mesh::Triangle> reconstructed_;
    UniformResult result_;
    StageClock clock_{result_.seconds};
};

void LayeredDepthBoolean::stage(const char* name, double from, double to, const std::function<void()>& work) {
    if (progress_ != nullptr) {
        progress_->stage(name, from, to);
        progress_->check();
    }
    work();
    clock_.end(name);
}

void LayeredDepthBoolean::name_faces() {
    for (int k = 0; k < 2 && cad_.any(); ++k) {
        pair_.face.resize(pair_.first_triangle[k + 1], -1);
        if (cad_.shapes[k].model) {
            std::copy(cad_.shapes[k].faces->begin(), cad_.shapes[k].faces->end(),
                      pair_.face.begin() + pair_.first_triangle[k]);
        }
    }
}

void LayeredDepthBoolean::sample_cad() {
    for (int k = 0; k < 2; ++k) {
        if (cad_.shapes[k].model) {
            sample_faces(operands_[k], pair_, grid_, result_.mesh.origin, cad_.shapes[k], *cad_.engine, result_.cad,
                         progress_);
        }
    }
}

void LayeredDepthBoolean::project() {
    const FaceProjection projection = project_onto_faces(surface_, reconstructed_, octree_, sheet_vertex_, pair_, grid_,
                                                         result_.mesh.origin, cad_.shapes, *cad_.engine, progress_);
    result_.fitted = projection.moved;
    result_.unfitted = projection.left;
}

void LayeredDepthBoolean::sample() {
    for (int k = 0; k < 2; ++k) {
        operands_[k] = rasterise(pair_, k, grid_, progress_);
    }
}

void LayeredDepthBoolean::count() {
    for (int k = 0; k < 2; ++k) {
        for (const LayeredDepthImage& direction : operands_[k]) {
            result_.samples += direction.depth.size();
        }
    }
}

void LayeredDepthBoolean::combine_samples() {
    CombineOptions options;
    options.operation = operation_;
    options.thinnest = options_.thinnest * grid_.cells();
    options.normal_index = options_.normal_index;
    combined_ = combine(pair_, operands_, grid_, options, progress_);
    operands_ = {};
    for (const CombinedDepth& direction : combined_) {
        result_.result_samples += direction.depth.size();
    }
}

void LayeredDepthBoolean::contour_cells() {
    ContouredSurface contoured = contour(pair_, octree_, grid_, combined_, fate_, sheet_vertex_, surface_, progress_);
    reconstructed_ = std::move(contoured.triangles);
    sheet_vertex_ = std::move(contoured.vertices);
    result_.refused_triangles = contoured.refused;
    result_.reconstructed = reconstructed_.size();
}

/// Fills one hole; where all triangulations of its corners would reuse an edge, with a fan around a new point.
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

/// Node-Open, then the holes (section III-C). Only triangles around the border and new ones can need it.
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
    surface_.triangles.insert(surface_.triangles.end(), active.begin() + static_cast<std::ptrdiff_t>(place.size()),
                              active.end());
    surface_.source.resize(surface_.triangles.size(), -1);
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
    for (std::size_t k = 0; k < surface_.triangles.size(); ++k) {
        const mesh::Triangle& t = surface_.triangles[k];
        mesh.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
        const std::int32_t source = surface_.source[k];
        if (source < 0) {
            result_.triangle_source.push_back({-1, -1});
        } else {
            const int operand = pair_.operand_of(source);
            result_.triangle_source.push_back({operand, source - pair_.first_triangle[operand]});
            ++result_.retained;
        }
    }
    const std::size_t made = mesh.triangles.size() - result_.retained;
    result_.changed = made - result_.reconstructed - result_.hole_triangles;
    result_.error_bound = made > 0 ? kBound * grid_.spacing() : 0.0;
}

UniformResult LayeredDepthBoolean::run() {
    const bool cad = cad_.any();
    stage("sampling", 0.0, cad ? 0.1 : 0.3, [&] { sample(); });
    if (cad) {
        stage("sampling CAD faces", 0.1, 0.3, [&] { sample_cad(); });
    }
    count();
    stage("clustering", 0.3, 0.35, [&] {
        sample_count_ = count_samples(pair_, operands_);
        const std::vector<std::uint8_t> beyond = triangles_beyond(pair_, grid_);
        region_ = cluster(pair_, sample_count_, beyond);
        for (std::size_t t = 0; t < region_.size(); ++t) {
            result_.unsampled_triangles += region_[t] < 0 && beyond[t] == 0 ? 1 : 0;
        }
    });
    stage("Boolean of samples", 0.35, 0.5, [&] { combine_samples(); });
    stage("membership", 0.5, 0.6, [&] {
        fate_ = classify(pair_, sample_count_, region_, combined_);
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
    if (cad) {
        stage("fitting to the shapes", 0.9, 0.9, [&] { project(); });
    }
    stage("two-manifold", 0.9, 0.98, [&] { make_manifold(); });
    stage("assembly", 0.98, 1.0, [&] { assemble(); });
    return std::move(result_);
}

}  // namespace

UniformResult layered_depth_boolean(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b, Operation operation,
                                    const UniformOptions& options, Progress* progress, const CadOperands& cad) {
    require_options(options);
    require_operands(a, b);
    return LayeredDepthBoolean(a, b, operation, options, cad, progress).run();
}

double uniform_bound(double size, int resolution) {
    return kBound * SampleGrid::spacing_of(size, resolution);
}

int uniform_resolution(double size, double tolerance) {
    const double least = uniform_bound(size, kHighestResolution);
    if (tolerance < least) {
        throw InvalidInput(Message::of(phrases::kManyRays, {{"length", in_digits(tolerance, 6) + " mm"},
                                                            {"length2", in_digits(least, 6) + " mm"}}));
    }
    const double wanted = SampleGrid::resolution_for(size, tolerance / kBound);
    int resolution = static_cast<int>(std::clamp<double>(wanted, kLowestResolution, kHighestResolution));
    while (uniform_bound(size, resolution) > tolerance) {
        ++resolution;  // compensates the rounding of the quotient
    }
    return resolution;
}

}  // namespace mq::boolean

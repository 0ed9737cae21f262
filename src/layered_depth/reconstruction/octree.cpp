// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/octree.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "layered_depth/reconstruction/quadric_error.h"
#include "layered_depth/reconstruction/tuning.h"
#include "layered_depth/samples/cell_samples.h"

namespace mq::layered_depth {

namespace {

/// Number of levels below the root that are always split: their cells are the parallel tasks.
constexpr int kTaskLevels = 2;

/// Tasks along each side of the cube.
constexpr int kTasksPerSide = 1 << kTaskLevels;
/// Tasks in a layer: those with the same position along z.
constexpr int kTasksPerLayer = kTasksPerSide * kTasksPerSide;
/// Nodes of the levels above the tasks and of the tasks' own level.
constexpr int kTaskNodes = 1 + 8 + 64;
/// Rows of rays whose samples one thread sorts into tasks at a time.
constexpr int kRowsPerChunk = 64;

/// Clips a segment to a closed cell. False if nothing is left of it.
bool clip(const Vec3& a, const Vec3& b, const CellBox& box, double& from, double& to) {
    from = 0.0;
    to = 1.0;
    for (int k = 0; k < 3; ++k) {
        const double low = box.low[k] - a[k], high = box.low[k] + box.size - a[k], d = b[k] - a[k];
        if (d == 0.0) {
            if (low > 0.0 || high < 0.0) {
                return false;
            }
            continue;
        }
        from = std::max(from, std::min(low / d, high / d));
        to = std::min(to, std::max(low / d, high / d));
    }
    return from <= to;
}

/// The CAD faces of the samples of a sheet, each represented by a triangle.
class SheetFaces {
  public:
    explicit SheetFaces(const OperandSet& pair) : pair_(pair) {}

    void add(std::int32_t triangle) {
        if (pair_.face.empty() || pair_.face[triangle] < 0) {
            many_ = true;
            return;
        }
        for (std::size_t k = 0; k < count_; ++k) {
            if (pair_.face[found_[k]] == pair_.face[triangle] &&
                pair_.operand_of(found_[k]) == pair_.operand_of(triangle)) {
                return;
            }
        }
        if (count_ == found_.size()) {
            many_ = true;
            return;
        }
        found_[count_++] = triangle;
    }
    std::array<std::int32_t, 3> triangles() const { return many_ ? std::array<std::int32_t, 3>{-1, -1, -1} : found_; }

  private:
    const OperandSet& pair_;
    std::array<std::int32_t, 3> found_{-1, -1, -1};
    std::size_t count_ = 0;
    bool many_ = false;
};

Leaf leaf_of(const CellBox& box) {
    Leaf leaf;
    for (int k = 0; k < 3; ++k) {
        leaf.low[k] = static_cast<std::int16_t>(box.low[k]);
    }
    leaf.size = static_cast<std::int16_t>(box.size);
    return leaf;
}

}  // namespace

std::int32_t Octree::leaf_at(int x, int y, int z) const {
    std::int32_t node = 0;
    for (int level = levels_ - 1; nodes_[node] >= 0; --level) {
        node = nodes_[node] + (x >> level & 1) + 2 * (y >> level & 1) + 4 * (z >> level & 1);
    }
    return nodes_[node] == -1 ? -1 : -2 - nodes_[node];
}

/// The input that all tasks read.
class OctreeBuilder {
  public:
    OctreeBuilder(const OperandSet& pair, const SampleGrid& grid, const CombinedSet& combined,
                  const std::vector<Retention>& fate, const RetainedSurface& retained);

    Octree build(std::size_t most_at_a_time, Progress* progress);

  private:
    /// By task: the samples that lie in its cell.
    using TaskSamples = std::vector<std::vector<CellSample>>;
    /// Some consecutive layers of tasks.
    struct Layers {
        int first, end;
    };
    /// One task: the subtree below a cell.
    class Subtree;

    void build_layers(std::vector<Octree>& parts, const Layers& layers, const Progress* progress) const;
    void distribute(int axis, int first_row, const Layers& layers, TaskSamples& tasks) const;
    void append(Octree& tree, Octree& part, std::int32_t node) const;
    std::uint8_t nodes_of(const CellBox& box) const;
    std::uint8_t flipped_faces(const CellBox& box, std::uint8_t nodes) const;
    Vec3 position(const CellSample& s) const {
        Vec3 p(s.at[0], s.at[1], s.at[2]);
        p[s.axis] = combined_[s.axis].depth[s.index];
        return p;
    }
    std::int32_t triangle(const CellSample& s) const {
        return CombinedDepth::triangle(combined_[s.axis].source[s.index]);
    }
    Vec3 normal(const CellSample& s) const {
        if (!combined_[s.axis].normal.empty()) {
            return combined_[s.axis].normal[s.index].cast<double>();
        }
        return normals_[triangle(s)].cast<double>();
    }

    const OperandSet& pair_;
    const SampleGrid& grid_;
    const CombinedSet& combined_;
    const std::vector<Retention>& fate_;
    const RetainedSurface& retained_;
    std::vector<SampleNormal> normals_;        // normals of the triangles; empty if samples have their own
    std::vector<std::array<Vec3, 2>> border_;  // ends of each border edge in grid coordinates
};

class OctreeBuilder::Subtree {
  public:
    Subtree(const OctreeBuilder& shared, Octree& tree, const Progress* progress)
        : shared_(shared), tree_(tree), progress_(progress), buffers_(shared.grid_.levels() + 1) {}

    void build(const CellBox& box, const std::vector<CellSample>& samples) {
        std::vector<CellEdge> edges;
        for (std::size_t k = 0; k < shared_.border_.size(); ++k) {
            add_edge(static_cast<std::int32_t>(k), box, edges);
        }
        tree_.nodes_.push_back(-1);
        refine(0, box, samples.data(), samples.data() + samples.size(), edges, 0);
    }

  private:
    void add_edge(std::int32_t edge, const CellBox& box, std::vector<CellEdge>& edges) const {
        CellEdge found{edge, 0.0, 0.0};
        if (clip(shared_.border_[edge][0], shared_.border_[edge][1], box, found.from, found.to)) {
            edges.push_back(found);
        }
    }
    void refine(std::size_t node, const CellBox& box, const CellSample* first, const CellSample* last,
                const std::vector<CellEdge>& edges, int depth);
    void split(std::size_t node, const CellBox& box, const CellSample* first, const CellSample* last,
               const std::vector<CellEdge>& edges, int depth);
    CellKind kind_of(const CellBox& box, const CellCensus& samples, const std::vector<CellEdge>& edges) const;
    Vec3 minimiser(const CellBox& box, const Quadric& quadric) const;
    void add_sheets(Leaf& leaf, const CellBox& box, const CellSample* first, const CellSample* last);
    Vec3 vertex(const CellBox& box, CellKind kind, const std::vector<CellEdge>& edges, const Vec3& q) const;
    bool flat(const Vec3& q, const CellSample* first, const CellSample* last) const;

    const OctreeBuilder& shared_;
    Octree& tree_;
    const Progress* progress_;
    std::vector<std::vector<CellSample>> buffers_;  // by level: a buffer for the samples of the eight children
};

CellKind OctreeBuilder::Subtree::kind_of(const CellBox& box, const CellCensus& samples,
                                         const std::vector<CellEdge>& edges) const {
    if (edges.empty() || samples.retained == 0) {
        return CellKind::Interior;
    }
    const Leaf cell = leaf_of(box);
    const auto ends_within = [&](const CellEdge& e) {
        const std::array<Vec3, 2>& segment = shared_.border_[e.edge];
        return std::array<bool, 2>{cell.holds(segment[0]), cell.holds(segment[1])};
    };
    const auto first = ends_within(edges[0]);
    if (edges.size() == 1) {
        return first[0] || first[1] ? CellKind::Complex : CellKind::SingleEdge;
    }
    const auto second = ends_within(edges[1]);
    const auto& e = shared_.retained_.border[edges[0].edge];
    const auto& f = shared_.retained_.border[edges[1].edge];
    const bool meet = (e.to == f.from && first[1] && second[0] && !first[0] && !second[1]) ||
                      (e.from == f.to && first[0] && second[1] && !first[1] && !second[0]);
    return edges.size() == 2 && meet ? CellKind::SharedVertex : CellKind::Complex;
}

Vec3 OctreeBuilder::Subtree::minimiser(const CellBox& box, const Quadric& quadric) const {
    const Vec3 low(box.low[0], box.low[1], box.low[2]);
    return quadric.minimiser(low + Vec3::Constant(ReconstructionTuning::kInset),
                             low + Vec3::Constant(box.size - ReconstructionTuning::kInset));
}

/// Adds the sheets of a unit cell, with the samples on their edges.
void OctreeBuilder::Subtree::add_sheets(Leaf& leaf, const CellBox& box, const CellSample* first,
                                        const CellSample* last) {
    const std::uint8_t nodes = shared_.nodes_of(box);
    const CellSheets sheets = find_sheets(nodes, shared_.flipped_faces(box, nodes));
    struct Content {
        Quadric quadric;
        SheetFaces faces;
        bool reconstructed = false, retained = false;
    };
    const Content none{{}, SheetFaces(shared_.pair_)};
    std::array<Content, 4> contents{none, none, none, none};
    Quadric all;
    for (const CellSample* s = first; s != last; ++s) {
        const std::uint8_t sheet = sheets.of_edge[edge_of(box, *s)];
        const Vec3 position = shared_.position(*s), normal = shared_.normal(*s);
        all.add(position, normal);
        if (sheet != CellSheets::kNoSheet) {
            contents[sheet].quadric.add(position, normal);
            contents[sheet].faces.add(shared_.triangle(*s));
            (s->reconstructed != 0 ? contents[sheet].reconstructed : contents[sheet].retained) = true;
        }
    }
    leaf.sheet_of_edge = sheets.of_edge;
    for (int k = 0; k < sheets.count; ++k) {
        const Content& content = contents[k];
        tree_.sheets.push_back(
            {minimiser(box, content.quadric.count() > 0 ? content.quadric : all), content.faces.triangles()});
        if (leaf.border_sheet < 0 && content.reconstructed && content.retained) {
            leaf.border_sheet = k;
        }
    }
    if (leaf.border_sheet < 0) {
        leaf.kind = CellKind::Interior;
    }
}

/// The point that the vertex of a cell will have: in a simple boundary cell it is on the border (Remark 2).
Vec3 OctreeBuilder::Subtree::vertex(const CellBox& box, CellKind kind, const std::vector<CellEdge>& edges,
                                    const Vec3& q) const {
    if (kind == CellKind::Interior) {
        return q;
    }
    const auto& [a, b] = shared_.border_[edges[0].edge];
    if (kind == CellKind::SharedVertex) {
        return leaf_of(box).holds(a) ? a : b;
    }
    const Vec3 d = b - a;
    return a + d * std::clamp((q - a).dot(d) / d.squaredNorm(), edges[0].from, edges[0].to);
}

bool OctreeBuilder::Subtree::flat(const Vec3& q, const CellSample* first, const CellSample* last) const {
    return std::all_of(first, last, [&](const CellSample& s) {
        return std::abs((q - shared_.position(s)).dot(shared_.normal(s))) <= ReconstructionTuning::kFlatness;
    });
}

void OctreeBuilder::Subtree::refine(std::size_t node, const CellBox& box, const CellSample* first,
                                    const CellSample* last, const std::vector<CellEdge>& edges, int depth) {
    const CellCensus samples = census(box, first, last);
    if (samples.reconstructed == 0) {
        return;
    }
    if (box.size >= 8) {
        check_cancelled(progress_);
    }
    const CellKind kind = kind_of(box, samples, edges);
    const bool unit = box.size == 1;
    // Retained samples in a cell without border edges are on another sheet than the IR-samples.
    const bool two_sheets = edges.empty() && samples.retained > 0;
    if (!unit && (kind == CellKind::Complex || two_sheets || (kind == CellKind::Interior && edges.size() > 2) ||
                  !simple_topology(shared_.nodes_of(box), samples))) {
        split(node, box, first, last, edges, depth);
        return;
    }
    Quadric quadric;
    if (!unit) {
        for (const CellSample* s = first; s != last; ++s) {
            quadric.add(shared_.position(*s), shared_.normal(*s));
        }
        if (!flat(vertex(box, kind, edges, minimiser(box, quadric)), first, last)) {
            split(node, box, first, last, edges, depth);
            return;
        }
    }
    Leaf leaf = leaf_of(box);
    leaf.kind = kind;
    leaf.first_sheet = static_cast<std::int32_t>(tree_.sheets.size());
    if (unit) {
        add_sheets(leaf, box, first, last);
    } else {
        SheetFaces faces(shared_.pair_);
        std::for_each(first, last, [&](const CellSample& s) { faces.add(shared_.triangle(s)); });
        tree_.sheets.push_back({minimiser(box, quadric), faces.triangles()});
        leaf.border_sheet = kind == CellKind::Interior ? -1 : 0;
    }
    leaf.first_edge = static_cast<std::uint32_t>(tree_.edges.size());
    if (leaf.kind != CellKind::Interior) {
        tree_.edges.insert(tree_.edges.end(), edges.begin(), edges.end());
    }
    leaf.end_edge = static_cast<std::uint32_t>(tree_.edges.size());
    tree_.nodes_[node] = -2 - static_cast<std::int32_t>(tree_.leaves.size());
    tree_.leaves.push_back(leaf);
}

void OctreeBuilder::Subtree::split(std::size_t node, const CellBox& box, const CellSample* first,
                                   const CellSample* last, const std::vector<CellEdge>& edges, int depth) {
    // On its own axis a sample belongs to one half; on the other axes to both if it lies on the middle plane.
    const auto children_of = [&](const CellSample& s) {
        // For each axis the children in its lower and its upper half, as bits.
        constexpr std::array<std::array<unsigned, 2>, 3> kHalves{{{0x55, 0xaa}, {0x33, 0xcc}, {0x0f, 0xf0}}};
        unsigned mask = 0xff;
        for (int k = 0; k < 3; ++k) {
            const int offset = s.at[k] - box.low[k] - box.size / 2;
            if (offset != 0 || k == s.axis) {
                mask &= kHalves[k][offset < 0 ? 0 : 1];
            }
        }
        return mask;
    };
    std::array<std::size_t, 9> begin{};
    for (const CellSample* s = first; s != last; ++s) {
        const unsigned mask = children_of(*s);
        for (int c = 0; c < 8; ++c) {
            begin[c + 1] += mask >> c & 1U;
        }
    }
    for (int c = 0; c < 8; ++c) {
        begin[c + 1] += begin[c];
    }
    std::vector<CellSample>& buffer = buffers_[depth];
    if (buffer.size() < begin[8]) {
        buffer.resize(begin[8]);
    }
    std::array<std::size_t, 9> next = begin;
    for (const CellSample* s = first; s != last; ++s) {
        for (unsigned mask = children_of(*s), c = 0; mask != 0; mask >>= 1, ++c) {
            if ((mask & 1U) != 0) {
                buffer[next[c]++] = *s;
            }
        }
    }
    const std::size_t child = tree_.nodes_.size();
    tree_.nodes_[node] = static_cast<std::int32_t>(child);
    tree_.nodes_.resize(child + 8, -1);
    std::vector<CellEdge> below;
    for (int c = 0; c < 8; ++c) {
        const CellBox box_c = box.child(c);
        below.clear();
        for (const CellEdge& e : edges) {
            add_edge(e.edge, box_c, below);
        }
        refine(child + c, box_c, buffer.data() + begin[c], buffer.data() + begin[c + 1], below, depth + 1);
    }
}

OctreeBuilder::OctreeBuilder(const OperandSet& pair, const SampleGrid& grid, const CombinedSet& combined,
                             const std::vector<Retention>& fate, const RetainedSurface& retained)
    : pair_(pair), grid_(grid), combined_(combined), fate_(fate), retained_(retained) {
    const bool own = std::all_of(combined.begin(), combined.end(),
                                 [](const CombinedDepth& d) { return d.normal.size() == d.depth.size(); });
    for (std::size_t t = 0; t < (own ? 0 : pair.triangles.size()); ++t) {
        normals_.push_back(pair.unit_normal(static_cast<std::int32_t>(t)).cast<float>());
    }
    border_.reserve(retained.border.size());
    for (const RetainedSurface::BorderEdge& edge : retained.border) {
        border_.push_back({grid.to_grid(retained.points[edge.from]), grid.to_grid(retained.points[edge.to])});
    }
}

std::uint8_t OctreeBuilder::nodes_of(const CellBox& box) const {
    unsigned nodes = 0;
    for (int yz = 0; yz < 4; ++yz) {
        const std::size_t y = box.low[1] + (yz & 1) * box.size, z = box.low[2] + (yz >> 1) * box.size;
        const std::size_t ray = z * grid_.rays() + y;
        nodes |= (combined_[0].inside(ray, box.low[0]) ? 1U : 0U) << (2 * yz);
        nodes |= (combined_[0].inside(ray, box.low[0] + box.size) ? 1U : 0U) << (2 * yz + 1);
    }
    return static_cast<std::uint8_t>(nodes);
}

/// The faces of a unit cell that are knotted in the cells on both of their sides.
std::uint8_t OctreeBuilder::flipped_faces(const CellBox& box, std::uint8_t nodes) const {
    std::uint8_t flipped = knotted_faces(nodes);
    for (int f = 0; f < 6 && flipped != 0; ++f) {
        if ((flipped >> f & 1) != 0) {
            CellBox neighbour = box;
            neighbour.low[f / 2] += f % 2 == 0 ? -1 : 1;
            const int opposite = f % 2 == 0 ? f + 1 : f - 1;
            if ((knotted_faces(nodes_of(neighbour)) >> opposite & 1) == 0) {
                flipped = static_cast<std::uint8_t>(flipped & ~(1U << f));
            }
        }
    }
    return flipped;
}

/// Sorts the samples of some rows into the tasks; a sample on the plane between two tasks goes to both.
void OctreeBuilder::distribute(int axis, int first_row, const Layers& layers, TaskSamples& tasks) const {
    const int shift = grid_.levels() - kTaskLevels;
    const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    const CombinedDepth& direction = combined_[axis];
    const auto rays = static_cast<std::size_t>(grid_.rays());
    const std::size_t end = static_cast<std::size_t>(std::min(first_row + kRowsPerChunk, grid_.rays())) * rays;
    tasks.resize(static_cast<std::size_t>((layers.end - layers.first) * kTasksPerLayer));
    for (std::size_t ray = static_cast<std::size_t>(first_row) * rays; ray < end; ++ray) {
        for (std::uint32_t i = direction.begin[ray]; i < direction.begin[ray + 1]; ++i) {
            CellSample s;
            s.at[axis] = static_cast<std::int16_t>(std::ceil(direction.depth[i]) - 1);
            s.at[u_axis] = static_cast<std::int16_t>(ray % rays);
            s.at[v_axis] = static_cast<std::int16_t>(ray / rays);
            s.axis = static_cast<std::uint8_t>(axis);
            s.reconstructed = fate_[CombinedDepth::triangle(direction.source[i])] == Retention::Removed ? 1 : 0;
            s.index = i;
            std::array<int, 3> from{}, to{};
            for (int k = 0; k < 3; ++k) {
                to[k] = std::min(s.at[k] >> shift, kTasksPerSide - 1);
                from[k] = k == axis ? to[k] : std::max((s.at[k] - 1) >> shift, 0);
            }
            for (int z = std::max(from[2], layers.first); z <= std::min(to[2], layers.end - 1); ++z) {
                for (int y = from[1]; y <= to[1]; ++y) {
                    for (int x = from[0]; x <= to[0]; ++x) {
                        tasks[x + kTasksPerSide * (y + kTasksPerSide * (z - layers.first))].push_back(s);
                    }
                }
            }
        }
    }
}

/// Appends a task's subtree below its node.
void OctreeBuilder::append(Octree& tree, Octree& part, std::int32_t node) const {
    const auto shift = static_cast<std::int32_t>(tree.nodes_.size()) - 1;  // the root of the subtree becomes `node`
    const auto leaf_shift = static_cast<std::int32_t>(tree.leaves.size());
    const auto edge_shift = static_cast<std::uint32_t>(tree.edges.size());
    const auto moved = [&](std::int32_t value) {
        return value >= 0 ? value + shift : value == -1 ? -1 : value - leaf_shift;
    };
    tree.nodes_[node] = moved(part.nodes_[0]);
    for (std::size_t k = 1; k < part.nodes_.size(); ++k) {
        tree.nodes_.push_back(moved(part.nodes_[k]));
    }
    const auto sheet_shift = static_cast<std::int32_t>(tree.sheets.size());
    for (Leaf leaf : part.leaves) {
        leaf.first_sheet += sheet_shift;
        leaf.first_edge += edge_shift;
        leaf.end_edge += edge_shift;
        tree.leaves.push_back(leaf);
    }
    tree.sheets.insert(tree.sheets.end(), part.sheets.begin(), part.sheets.end());
    tree.edges.insert(tree.edges.end(), part.edges.begin(), part.edges.end());
}

void OctreeBuilder::build_layers(std::vector<Octree>& parts, const Layers& layers, const Progress* progress) const {
    const int per_axis = (grid_.rays() + kRowsPerChunk - 1) / kRowsPerChunk;
    std::vector<TaskSamples> chunks(3 * static_cast<std::size_t>(per_axis));
    parallel_for(static_cast<int>(chunks.size()), [&](int k) {
        check_cancelled(progress);
        distribute(k / per_axis, k % per_axis * kRowsPerChunk, layers, chunks[static_cast<std::size_t>(k)]);
    });
    const int size = grid_.cells() / kTasksPerSide;
    parallel_for((layers.end - layers.first) * kTasksPerLayer, [&](int task) {
        std::vector<CellSample> samples;
        for (TaskSamples& chunk : chunks) {
            std::vector<CellSample>& some = chunk[static_cast<std::size_t>(task)];
            samples.insert(samples.end(), some.begin(), some.end());
            some = {};
        }
        const int k = layers.first * kTasksPerLayer + task;
        const CellBox box{{k % 4 * size, k / 4 % 4 * size, k / 16 * size}, size};
        Subtree(*this, parts[static_cast<std::size_t>(k)], progress).build(box, samples);
    });
}

Octree OctreeBuilder::build(std::size_t most_at_a_time, Progress* progress) {
    std::vector<Octree> parts(kTasksPerSide * kTasksPerLayer);
    std::size_t samples = 0;
    for (const CombinedDepth& direction : combined_) {
        samples += direction.depth.size();
    }
    const int at_a_time = samples > most_at_a_time ? 1 : kTasksPerSide;
    for (int layer = 0; layer < kTasksPerSide; layer += at_a_time) {
        build_layers(parts, {layer, layer + at_a_time}, progress);
    }
    Octree tree;
    tree.levels_ = grid_.levels();
    tree.nodes_.assign(kTaskNodes, -1);
    tree.nodes_[0] = 1;
    for (int c = 0; c < 8; ++c) {
        tree.nodes_[1 + c] = 9 + 8 * c;
        for (int d = 0; d < 8; ++d) {
            const int x = 2 * (c & 1) + (d & 1), y = 2 * (c >> 1 & 1) + (d >> 1 & 1), z = 2 * (c >> 2) + (d >> 2);
            append(tree, parts[x + kTasksPerSide * (y + kTasksPerSide * z)], 9 + 8 * c + d);
        }
    }
    return tree;
}

Octree build_octree(const OperandSet& pair, const SampleGrid& grid, const CombinedSet& combined,
                    const std::vector<Retention>& fate, const RetainedSurface& retained, Progress* progress,
                    std::size_t most_at_a_time) {
    return OctreeBuilder(pair, grid, combined, fate, retained).build(most_at_a_time, progress);
}

}  // namespace mq::layered_depth

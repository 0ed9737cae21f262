// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/vec.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::workflows {

/// An operand as it is given: a mesh, a shape, or both, joined to one operand.
struct GivenOperand {
    std::string name;                                    ///< in errors and notes: "operand A", "'Box'"
    std::shared_ptr<const triangulate::Result> surface;  ///< null: a shape alone
    bool round = false;                         ///< whether coordinates of the mesh may be rounded to single precision
    std::shared_ptr<const TopoDS_Shape> shape;  ///< null: a mesh alone
    std::string bridge{};                       ///< how the shape came from FreeCAD, see MeshReport

    bool is_shape() const { return shape != nullptr && surface == nullptr; }
};

/// An operand: its mesh, and the shape from which it was meshed.
struct BooleanOperand {
    const triangulate::Result* surface = nullptr;
    bool round = false;                   ///< true: its coordinates may be rounded to single precision
    const TopoDS_Shape* shape = nullptr;  ///< null: the operand is nothing but a mesh
};

/// Stages, notes, processor time and errors of the steps before the present one.
struct WorkBefore {
    StageTimes seconds;
    std::vector<Message> notes;
    double cpu_seconds = 0.0;
    /// mm: how far these steps may have moved surfaces; the reported bound includes it.
    double error_bound = 0.0;
    double tolerance = 0.0;           ///< mm: the tolerance for all of the work, where it is not that of the last step
    std::vector<Message> repaired{};  ///< a sentence for each operand that was repaired before
};

/// Options for meshing the shapes among operands.
struct OperandMeshing {
    double tolerance = 0.0;       ///< mm, that of the operation
    double share = 0.5;           ///< fraction of the tolerance by which the meshes may deviate from the shapes
    double min_angle = 25.0;      ///< degrees
    double volume_error = 0.0;    ///< largest relative error of the volume of a shape; 0: no bound
    double most_triangles = 5e5;  ///< limit of triangles for refinement by `volume_error`
    /// Whether meshes are bound by the distance alone, and faces that we cannot mesh are allowed and noted
    /// (mesh_within).
    bool any_faces = false;
    int threads = 0;
};

/// Operands of which all are meshes.
struct MeshedOperands {
    std::vector<std::shared_ptr<const triangulate::Result>> surfaces;
    std::vector<BooleanOperand> operands;  ///< they point to these surfaces
    WorkBefore work;                       ///< reading and meshing; `error_bound` is the largest deviation
};

/// The operands of an operation in their order. The time between its construction and the last call of `add` is
/// reported as reading.
class Operands {
  public:
    explicit Operands(geometry::Engine& engine) : engine_(engine) {}
    geometry::Engine& engine() const { return engine_; }

    void add(GivenOperand operand);

    const std::vector<GivenOperand>& given() const { return given_; }
    bool any_shapes() const;
    /// How the shapes came from FreeCAD; empty where there are none.
    std::string bridge() const;
    /// Longest side of the box of all operands, mm; shapes are read for it, once.
    /// @throws GeometryError
    double size() const;
    /// mm: the length that a resolution divides, for the exact method: 8 times the mean thickness of the thinnest
    /// operand, but between a sixteenth of the size and the size. Features thinner than the tolerance may be lost where
    /// operands nearly touch.
    double divided_length() const;

    /// Meshes the shapes among the operands; the progress advances from `from` to `to`.
    /// @throws InvalidInput, TopologyError naming the operand; Cancelled
    MeshedOperands meshed(const OperandMeshing& meshing, Progress& progress, double from, double to) const;

  private:
    const Box& box_of_shape(std::size_t operand) const;

    geometry::Engine& engine_;
    std::vector<GivenOperand> given_;
    mutable std::vector<std::optional<Box>> boxes_;  ///< by operand: the box of its shape, once computed
    Stopwatch watch_;
    double read_wall_ = 0.0;
    double read_cpu_ = 0.0;
};

}  // namespace mq::workflows

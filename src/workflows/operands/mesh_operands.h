// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/vec.h"
#include "geometry/engine.h"
#include "triangulate/work_mesh/result.h"

class TopoDS_Shape;

namespace mq::workflows {

/// What an operation is given: a mesh, a shape, or both, which then are one operand.
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

/// The steps before one of several: stages, notes and processor time.
struct WorkBefore {
    StageTimes seconds;
    std::vector<std::string> notes;
    double cpu_seconds = 0.0;
    /// mm: how far that work may have moved surfaces; the reported bound includes it.
    double error_bound = 0.0;
    double tolerance = 0.0;  ///< mm: the tolerance for all of the work, where it is not that of the last step
    std::vector<std::string> repaired{};  ///< a sentence for each operand that was repaired before
};

/// How shapes among operands are meshed.
struct OperandMeshing {
    double tolerance = 0.0;       ///< mm, that of the operation
    double share = 0.5;           ///< the fraction of it by which the meshes may deviate from the shapes
    double min_angle = 25.0;      ///< degrees
    double volume_error = 0.0;    ///< relative: finer where the volume of a shape would err by more; 0: no bound
    double most_triangles = 5e5;  ///< are expected of a mesh that is finer for the sake of the volume
    /// Bound by the distance alone; also of shapes with faces that we cannot mesh, which notes tell (mesh_within).
    bool any_faces = false;
    int threads = 0;
};

/// Operands of which all are meshes.
struct MeshedOperands {
    std::vector<std::shared_ptr<const triangulate::Result>> surfaces;
    std::vector<BooleanOperand> operands;  ///< they point to these surfaces
    WorkBefore work;                       ///< reading and meshing; its error bound is the largest deviation
};

/// The operands of an operation in their order. Between its construction and the last call of `add` they are read, the
/// time of which is reported.
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
    /// mm; the length that a resolution divides, where the method is exact: the size, or 8 times the mean thickness of
    /// the thinnest operand, where that is less, and not below a sixteenth of the size. What is thinner than the
    /// tolerance may be lost where operands nearly touch, so that the tolerance goes by what is thin.
    double divided_length() const;

    /// Meshes those that are shapes, in the progress from one fraction to another.
    /// @throws InvalidInput, TopologyError naming the operand; Cancelled
    MeshedOperands meshed(const OperandMeshing& meshing, Progress& progress, double from, double to) const;

  private:
    const Box& box_of_shape(std::size_t operand) const;

    geometry::Engine& engine_;
    std::vector<GivenOperand> given_;
    mutable std::vector<std::optional<Box>> boxes_;  ///< by operand: the box of its shape, once it was asked for
    Stopwatch watch_;
    double read_wall_ = 0.0;
    double read_cpu_ = 0.0;
};

}  // namespace mq::workflows

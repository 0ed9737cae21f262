// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/evaluation.h"
#include "geometry/occt/evaluation/edge_evaluator.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// The evaluators of a shape's edges, each made when it is first asked for, and again where its edge has changed.
class EdgeCurves {
  public:
    explicit EdgeCurves(Evaluation evaluation = Evaluation::Fast) : evaluation_(evaluation) {}

    /// The result stays until the edge is asked for with other ends.
    const EdgeEvaluator& of(int index, const TopoDS_Edge& shape, const Edge& data) {
        const auto i = static_cast<std::size_t>(index);
        if (made_.size() <= i) {
            made_.resize(i + 1);
        }
        Made& made = made_[i];
        if (!made.evaluator || made.t0 != data.t0 || made.t1 != data.t1 || made.nodes != data.nodes ||
            made.degenerate != data.degenerate) {
            made = {std::make_unique<EdgeEvaluator>(shape, data, evaluation_), data.t0, data.t1, data.nodes,
                    data.degenerate};
        }
        return *made.evaluator;
    }

  private:
    struct Made {
        std::unique_ptr<EdgeEvaluator> evaluator;
        double t0 = 0.0;
        double t1 = 0.0;
        std::array<int, 2> nodes{-1, -1};
        bool degenerate = false;
    };

    Evaluation evaluation_;
    std::vector<Made> made_;
};

}  // namespace mq::geometry

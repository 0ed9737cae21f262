// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <utility>

#include "geometry/engine.h"

namespace mq::geometry {

/// One model on one engine: what an algorithm holds while it works on a part.
class Session {
  public:
    Session(Engine& engine, std::shared_ptr<Model> model) : engine_(engine), model_(std::move(model)) {}

    const Topology& topology() const { return model_->topology(); }
    Engine::Answers ask(Engine::Batch batch) { return engine_.ask(model_, std::move(batch)); }
    Answer ask(const Query& query) { return engine_.ask(model_, query); }
    std::future<Engine::Answers> submit(Engine::Batch batch) { return engine_.submit(model_, std::move(batch)); }

  private:
    Engine& engine_;
    std::shared_ptr<Model> model_;
};

}  // namespace mq::geometry

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <gtest/gtest.h>

#include <vector>

#include "view/quality_scene.h"

namespace mq::view {

inline const std::vector<float> kTwo{0, 0, 0, 2, 0, 0, 0, 3, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0};

class Scene : public testing::Test {
  protected:
    static void SetUpTestSuite() { SoDB::init(); }
    static void TearDownTestSuite() { SoDB::finish(); }

    int triangles() {
        SoGetPrimitiveCountAction action;
        action.apply(scene.root());
        return action.getTriangleCount();
    }

    int lines() {
        SoGetPrimitiveCountAction action;
        action.apply(scene.root());
        return action.getLineCount();
    }

    QualityScene scene;
};

}  // namespace mq::view

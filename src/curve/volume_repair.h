// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/progress.h"
#include "curve/volume.h"

namespace mq::curve {

struct VolumeRepairs {
    int invalid_before = 0;
    int invalid_after = 0;
    int patches = 0;  ///< whose inner edges and faces were curved
};

/// Repairs invalid and poor tetrahedra: bad ones with the layers around them form patches, whose inner edges and faces
/// are curved. The surface stays as it is.
VolumeRepairs repair_volume(Volume& volume, const Progress& progress);

}  // namespace mq::curve

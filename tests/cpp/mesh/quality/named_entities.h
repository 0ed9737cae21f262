// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/quality/exempt_reason.h"

/// Entities of a shape by the numbers in their names.
namespace mq::mesh {

inline NamedEntity vertex(int number) {
    return {0, {0, number - 1}};
}

inline NamedEntity edge(int number) {
    return {1, {1, number - 1}};
}

inline NamedEntity face(int number) {
    return {2, {2, number - 1}};
}

}  // namespace mq::mesh

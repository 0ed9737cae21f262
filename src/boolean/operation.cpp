// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/operation.h"

#include "base/error.h"

namespace mq::boolean {

namespace {

constexpr Operation kOperations[] = {Operation::Union, Operation::Intersection, Operation::Difference,
                                     Operation::SymmetricDifference};

}  // namespace

const char* name(Operation operation) {
    switch (operation) {
        case Operation::Union:
            return "union";
        case Operation::Intersection:
            return "intersection";
        case Operation::Difference:
            return "difference";
        case Operation::SymmetricDifference:
            break;
    }
    return "symmetric_difference";
}

Operation operation_from(const std::string& text) {
    std::string known;
    for (const Operation operation : kOperations) {
        if (text == name(operation)) {
            return operation;
        }
        known += (known.empty() ? "'" : ", '") + std::string(name(operation)) + "'";
    }
    throw InvalidInput("operation is '" + text + "': it must be one of " + known);
}

bool in_result(Operation operation, bool in_a, bool in_b) {
    switch (operation) {
        case Operation::Union:
            return in_a || in_b;
        case Operation::Intersection:
            return in_a && in_b;
        case Operation::Difference:
            return in_a && !in_b;
        case Operation::SymmetricDifference:
            break;
    }
    return in_a != in_b;
}

bool in_result(Operation operation, const std::int32_t* winding, int operands) {
    bool in = winding[0] > 0;
    for (int k = 1; k < operands; ++k) {
        in = in_result(operation, in, winding[k] > 0);
    }
    return in;
}

}  // namespace mq::boolean

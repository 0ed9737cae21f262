// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace mq {

/// Base of all errors that leave the core. `what()` is a sentence that names the entity at fault and the remedy.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// An option, a shape or a mesh that is not valid as given.
class InvalidInput : public Error {
    using Error::Error;
};

/// Faces, edges or triangles do not fit together.
class TopologyError : public Error {
    using Error::Error;
};

/// A surface or a curve cannot be evaluated where it is needed.
class GeometryError : public Error {
    using Error::Error;
};

/// The caller asked the operation to stop; nothing was changed.
class Cancelled : public Error {
    using Error::Error;
};

/// A file cannot be read or written.
class IoError : public Error {
    using Error::Error;
};

}  // namespace mq

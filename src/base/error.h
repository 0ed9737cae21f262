// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "base/message.h"

namespace mq {

/// Base of all errors that leave the core. `what()` is a sentence that names the entity at fault and the remedy. Errors
/// that a panel may show are made of a phrase of the catalogue.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& text) : Error(Message::value(text)) {}
    explicit Error(Message message) : std::runtime_error(message.text()), message_(std::move(message)) {}

    const Message& message() const { return message_; }

  private:
    Message message_;
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "base/message.h"

namespace mq {

/// Base of all errors that leave the core: a phrase of the catalogue and what stands in its places, or a message again.
/// `what()` is a sentence that names the entity at fault and the remedy.
class Error : public std::runtime_error {
  public:
    explicit Error(Message message) : std::runtime_error(message.text()), message_(std::move(message)) {}
    Error(Phrase phrase, std::initializer_list<Place> places) : Error(Message(phrase, places)) {}

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

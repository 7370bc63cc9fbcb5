// What the exit status says: part of the command line's contract.
#pragma once

#include "geometry/result.hpp"

namespace volute::app {

constexpr int exit_clean = 0;      ///< done, nothing found
constexpr int exit_found = 1;      ///< done, and the verifier found something
constexpr int exit_bad_input = 2;  ///< bad usage or bad input
constexpr int exit_system = 3;     ///< the machine failed us

constexpr int exit_status(geometry::ErrorKind kind) {
  return kind == geometry::ErrorKind::bad_input ? exit_bad_input : exit_system;
}

}  // namespace volute::app

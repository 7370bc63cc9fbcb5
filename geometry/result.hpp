// How Volute reports what can go wrong: a value or an Error. No exception crosses a folder.
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace volute::geometry {

/// Who can mend it; the command line turns this into the exit status.
enum class ErrorKind {
  bad_input,  ///< the user's file, key or value (exit status 2)
  system,     ///< disk, memory, permission (exit status 3)
};

/// One thing that went wrong, said in one line.
struct Error {
  ErrorKind kind = ErrorKind::bad_input;
  std::string code;     ///< stable name for programs and tests: "mesh-not-manifold"
  std::string message;  ///< one line: where (file, line, key, triangle), the value, the rule, the remedy
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> bad_input(std::string code, std::string message) {
  return tl::unexpected<Error>(Error{ErrorKind::bad_input, std::move(code), std::move(message)});
}
inline tl::unexpected<Error> system_error(std::string code, std::string message) {
  return tl::unexpected<Error>(Error{ErrorKind::system, std::move(code), std::move(message)});
}

}  // namespace volute::geometry

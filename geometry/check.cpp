#include "geometry/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace volute::geometry {

void check_failed(const char* file, int line, const char* text, const std::string& values) {
  std::fprintf(stderr, "%s:%d: check failed: %s [%s ]\n", file, line, text, values.c_str());
  std::_Exit(3);
}

}  // namespace volute::geometry

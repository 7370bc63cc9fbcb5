// Numbers of vertices, triangles and points as indices of standard containers.
#pragma once

#include <concepts>
#include <cstddef>

namespace volute::geometry {

/// The element with number `i`, which is signed in meshes and in Eigen. Requires: i >= 0.
constexpr std::size_t at(std::signed_integral auto i) { return static_cast<std::size_t>(i); }

}  // namespace volute::geometry

// Standard library and Eigen, parsed once for all modules. A build aid only: every header and source still names what
// it uses, which the header checks and a build with -DVOLUTE_PRECOMPILED=OFF prove.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include "view/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace volute::view {

namespace {

/// Eleven samples of the viridis map, evenly spaced.
constexpr std::array<Colour, 11> viridis{{{0.267F, 0.005F, 0.329F},
                                          {0.283F, 0.141F, 0.458F},
                                          {0.254F, 0.265F, 0.530F},
                                          {0.207F, 0.372F, 0.553F},
                                          {0.164F, 0.471F, 0.558F},
                                          {0.128F, 0.567F, 0.551F},
                                          {0.135F, 0.659F, 0.518F},
                                          {0.267F, 0.749F, 0.441F},
                                          {0.478F, 0.821F, 0.318F},
                                          {0.741F, 0.873F, 0.150F},
                                          {0.993F, 0.906F, 0.144F}}};
constexpr std::array<Colour, 5> blue_to_brown{{{0.10F, 0.26F, 0.58F},
                                               {0.45F, 0.62F, 0.85F},
                                               {0.90F, 0.90F, 0.88F},
                                               {0.90F, 0.60F, 0.35F},
                                               {0.60F, 0.18F, 0.05F}}};

Colour between(std::span<const Colour> samples, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(index));
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = samples[index][i] + part * (samples[index + 1][i] - samples[index][i]);
  return colour;
}

}  // namespace

Colour sequential_colour(double share) { return between(viridis, share); }
Colour diverging_colour(double share) { return between(blue_to_brown, 0.5 * (share + 1.0)); }

}  // namespace volute::view

#include "mouse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes.hpp"

namespace volute::examples {

namespace {

using geometry::Vec2;
using geometry::Vec3;

constexpr double half_length_mm = 50.0, half_width_mm = 30.0, narrowing = 0.10, power = 2.5;
/// The profile f^p + g^p = 1 is f = sin(a)^(2/p), g = cos(a)^(2/p); the shell ends at this a.
constexpr double last_angle_rad = 85.0 * std::numbers::pi / 180.0;
/// Laid flat, a wall adds about its height to the plan.
constexpr double wall_mm = 20.0;

double hump_mm(double x_mm) { return 21.0 + 14.0 * std::exp(-std::pow((x_mm + 14.0) / 36.0, 2)); }
double width_factor(double x_mm) { return 1.0 - narrowing * x_mm / half_length_mm; }

/// rho = f(a) against the share of the profile's arc length, so that triangles keep their size down the wall.
class Profile {
 public:
  Profile() {
    double last_g = 1.0;
    for (std::size_t i = 0; i <= steps; ++i) {
      const double a = last_angle_rad * static_cast<double>(i) / static_cast<double>(steps);
      rho_.push_back(std::pow(std::sin(a), 2.0 / power));
      const double g = std::pow(std::cos(a), 2.0 / power);
      const double mean_radius_mm = 40.0, mean_height_mm = 30.0;
      length_.push_back(i == 0 ? 0.0
                               : length_.back() + std::hypot(mean_radius_mm * (rho_[i] - rho_[i - 1]),
                                                             mean_height_mm * (g - last_g)));
      last_g = g;
    }
    const double whole = length_.back();
    for (double& s : length_) s /= whole;
  }
  [[nodiscard]] double rho(double share) const { return interpolated(length_, rho_, share); }
  [[nodiscard]] double share(double rho) const { return interpolated(rho_, length_, rho); }

 private:
  static constexpr std::size_t steps = 20000;
  static double interpolated(const std::vector<double>& from, const std::vector<double>& to, double value) {
    const auto upper = std::upper_bound(from.begin() + 1, from.end() - 1, value) - from.begin();
    const auto i = static_cast<std::size_t>(upper);
    return to[i - 1] + (value - from[i - 1]) / (from[i] - from[i - 1]) * (to[i] - to[i - 1]);
  }
  std::vector<double> length_, rho_;
};

/// From the flat sheet, an ellipse of half axes plan + wall, to the plan of the shell.
Vec2 plan_of_flat(const Profile& profile, const Vec2& flat) {
  const Vec2 unit(flat.x() / (half_length_mm + wall_mm), flat.y() / (half_width_mm + wall_mm));
  const double share = unit.norm();
  if (share == 0.0) return Vec2::Zero();
  const Vec2 direction = unit / share;
  const double rho = profile.rho(std::min(share, 1.0)), x = half_length_mm * rho * direction.x();
  return {x, half_width_mm * width_factor(x) * rho * direction.y()};
}

Vec2 flat_of_plan(const Profile& profile, const Vec2& plan) {
  const Vec2 unit(plan.x() / half_length_mm, plan.y() / (half_width_mm * width_factor(plan.x())));
  const Vec2 flat_unit = profile.share(unit.norm()) / unit.norm() * unit;
  return {flat_unit.x() * (half_length_mm + wall_mm), flat_unit.y() * (half_width_mm + wall_mm)};
}

}  // namespace

double mouse_height_mm(double x_mm, double y_mm) {
  const double rho = std::hypot(x_mm / half_length_mm, y_mm / (half_width_mm * width_factor(x_mm)));
  return hump_mm(x_mm) * std::pow(std::max(0.0, 1.0 - std::pow(rho, power)), 1.0 / power);
}

geometry::TriangleMesh mouse_shell(double edge_mm) {
  const Profile profile;
  PlaneRegion flat{ellipse(half_length_mm + wall_mm, half_width_mm + wall_mm),
                   {resampled(rounded_rectangle(24.0, 7.0, 3.45, {{22.0, 0.0}}), 0.2)}};
  for (Vec2& p : flat.holes.front()) p = flat_of_plan(profile, p);
  const PlaneMesh sheet = mesh_plane(flat, edge_mm);
  geometry::TriangleMesh mesh{{}, sheet.triangles};
  for (const Vec2& p : sheet.points_mm) {
    const Vec2 plan = plan_of_flat(profile, p);
    mesh.vertices_mm.emplace_back(plan.x(), plan.y(), mouse_height_mm(plan.x(), plan.y()));
  }
  return mesh;
}

}  // namespace volute::examples

#include "view/camera.hpp"

#include <algorithm>
#include <cmath>

namespace volute::view {

void grow(Box& box, const Vec3& point) {
  box.least = box.least.cwiseMin(point);
  box.greatest = box.greatest.cwiseMax(point);
}

Camera fit_camera(const Box& box, const Vec3& towards_viewer, double aspect, double margin) {
  Camera camera;
  camera.aspect = aspect;
  camera.target = 0.5 * (box.least + box.greatest);
  camera.towards_viewer = towards_viewer.normalized();
  const Vec3 upward = std::abs(camera.towards_viewer.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  camera.right = upward.cross(camera.towards_viewer).normalized();
  camera.up = camera.towards_viewer.cross(camera.right);
  double half_width = 0.0, half_height = 0.0, half_depth = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? box.greatest.x() : box.least.x(),
                     (corner & 2) != 0 ? box.greatest.y() : box.least.y(),
                     (corner & 4) != 0 ? box.greatest.z() : box.least.z());
    const Vec3 offset = point - camera.target;
    half_width = std::max(half_width, std::abs(offset.dot(camera.right)));
    half_height = std::max(half_height, std::abs(offset.dot(camera.up)));
    half_depth = std::max(half_depth, std::abs(offset.dot(camera.towards_viewer)));
  }
  camera.half_height = std::max(half_height, half_width / aspect) * (1.0 + margin) + 1e-9;
  camera.half_depth = half_depth + 0.5 * camera.half_height + 1e-9;
  return camera;
}

Vec2 project(const Camera& camera, const Vec3& point, int width, int height) {
  const Vec3 offset = point - camera.target;
  const double x = offset.dot(camera.right) / (camera.half_height * camera.aspect);
  const double y = offset.dot(camera.up) / camera.half_height;
  return {0.5 * (1.0 + x) * width, 0.5 * (1.0 - y) * height};
}

}  // namespace volute::view

// Meshes and lines as a picture, by OSMesa: no display is needed. All OpenGL stands in renderer.cpp, the context behind
// one function.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.hpp"
#include "view/camera.hpp"
#include "view/image.hpp"

namespace volute::view {

struct ShadedMesh {
  const geometry::TriangleMesh* mesh = nullptr;  ///< must outlive the call
  std::vector<Colour> vertex_colours;            ///< none: `colour` everywhere
  Colour colour{0.75F, 0.78F, 0.80F};
  float opacity = 1.0F;
};

struct ColouredLine {
  std::vector<Vec3> points;
  std::vector<Colour> colours;  ///< one a point, or none: `colour`
  Colour colour{0.1F, 0.1F, 0.1F};
  double width_px = 1.5;
  double lift_mm = 0.0;  ///< moved towards the viewer, so that a line on a surface is not hidden by it
};

struct Scene3d {
  std::vector<ShadedMesh> meshes;
  std::vector<ColouredLine> lines;
  Colour background{1.0F, 1.0F, 1.0F};
};

/// Draws at twice the size and halves it. Errors (system): picture-no-context.
geometry::Result<Image> render(const Scene3d& scene, const Camera& camera, int width, int height);

}  // namespace volute::view

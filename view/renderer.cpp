#include "view/renderer.hpp"

#include <GL/gl.h>
#include <GL/osmesa.h>

#include <memory>
#include <mutex>

#include "geometry/mesh_measure.hpp"

namespace volute::view {

namespace {

constexpr int oversampling = 2;

/// The only place that knows how a context is made without a display.
class OffscreenContext {
 public:
  OffscreenContext(int width, int height)
      : pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) {
    context_ = OSMesaCreateContextExt(OSMESA_BGRA, 24, 0, 0, nullptr);
    ready_ =
        context_ != nullptr && OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE;
    if (ready_) OSMesaPixelStore(OSMESA_Y_UP, 0);
  }
  ~OffscreenContext() {
    if (context_ != nullptr) OSMesaDestroyContext(context_);
  }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  [[nodiscard]] bool ready() const { return ready_; }
  [[nodiscard]] std::vector<std::uint8_t>& pixels() { return pixels_; }

 private:
  std::vector<std::uint8_t> pixels_;
  OSMesaContext context_ = nullptr;
  bool ready_ = false;
};

void set_camera(const Camera& camera) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  const double half_width = camera.half_height * camera.aspect;
  glOrtho(-half_width, half_width, -camera.half_height, camera.half_height, -camera.half_depth, camera.half_depth);
  Eigen::Matrix4d look = Eigen::Matrix4d::Identity();
  look.block<1, 3>(0, 0) = camera.right.transpose();
  look.block<1, 3>(1, 0) = camera.up.transpose();
  look.block<1, 3>(2, 0) = camera.towards_viewer.transpose();
  look.block<3, 1>(0, 3) = -look.block<3, 3>(0, 0) * camera.target;
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixd(look.data());
}

/// A key light over the viewer's left shoulder, a weak one from the right, both fixed to the camera; both faces are
/// lit.
void set_lights() {
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();
  const GLfloat key[] = {-0.5F, 0.7F, 1.0F, 0.0F}, fill[] = {0.9F, 0.1F, 0.5F, 0.0F};
  const GLfloat strong[] = {0.62F, 0.62F, 0.60F, 1.0F}, weak[] = {0.22F, 0.22F, 0.25F, 1.0F},
                ambient[] = {0.30F, 0.30F, 0.30F, 1.0F};
  glLightfv(GL_LIGHT0, GL_POSITION, key);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, strong);
  glLightfv(GL_LIGHT1, GL_POSITION, fill);
  glLightfv(GL_LIGHT1, GL_DIFFUSE, weak);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glPopMatrix();
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_NORMALIZE);
}

void draw_mesh(const ShadedMesh& shaded) {
  const geometry::TriangleMesh& mesh = *shaded.mesh;
  if (mesh.triangles.empty()) return;
  const std::vector<Vec3> normals = geometry::vertex_normals(mesh);
  const bool see_through = shaded.opacity < 1.0F;
  if (see_through) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
  }
  glEnable(GL_LIGHTING);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_DOUBLE, sizeof(Vec3), mesh.vertices_mm.data());
  glNormalPointer(GL_DOUBLE, sizeof(Vec3), normals.data());
  if (!shaded.vertex_colours.empty()) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, sizeof(Colour), shaded.vertex_colours.data());
  } else {
    glColor4f(shaded.colour[0], shaded.colour[1], shaded.colour[2], shaded.opacity);
  }
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size() * 3), GL_UNSIGNED_INT, mesh.triangles.data());
  glDisableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisable(GL_LIGHTING);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void draw_line(const ColouredLine& line, const Camera& camera) {
  glLineWidth(static_cast<GLfloat>(line.width_px * oversampling));
  const Vec3 lift = line.lift_mm * camera.towards_viewer;
  glColor3fv(line.colour.data());
  glBegin(GL_LINE_STRIP);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (!line.colours.empty()) glColor3fv(line.colours[i].data());
    const Vec3 point = line.points[i] + lift;
    glVertex3d(point.x(), point.y(), point.z());
  }
  glEnd();
}

/// Pictures may be made by many threads; the drawing itself is one at a time, as Mesa shares its own threads anyway.
geometry::Result<Image> drawn(const Scene3d& scene, const Camera& camera, int large_width, int large_height) {
  static std::mutex drawing;
  const std::scoped_lock one_at_a_time(drawing);
  OffscreenContext context(large_width, large_height);
  if (!context.ready())
    return geometry::system_error("picture-no-context",
                                  "OSMesa gave no drawing context of this size; install libosmesa6");
  glViewport(0, 0, large_width, large_height);
  glClearColor(scene.background[0], scene.background[1], scene.background[2], 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  set_camera(camera);
  set_lights();
  for (const ShadedMesh& mesh : scene.meshes)
    if (mesh.opacity >= 1.0F) draw_mesh(mesh);
  for (const ColouredLine& line : scene.lines) draw_line(line, camera);
  for (const ShadedMesh& mesh : scene.meshes)
    if (mesh.opacity < 1.0F) draw_mesh(mesh);
  glFinish();
  return Image{large_width, large_height, std::move(context.pixels())};
}

}  // namespace

geometry::Result<Image> render(const Scene3d& scene, const Camera& camera, int width, int height) {
  const auto large = drawn(scene, camera, width * oversampling, height * oversampling);
  if (!large) return large;
  return reduced(*large, oversampling);
}

}  // namespace volute::view

#include "sample_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "geometry/number_text.hpp"
#include "tests/cases.hpp"

namespace volute::planner::samples {

using geometry::Index;

namespace {

constexpr double pi = std::numbers::pi;

/// Where the surface touches itself at a vertex only the largest fan of triangles stays.
void keep_one_fan(TriangleMesh& mesh) {
  std::vector<std::vector<std::size_t>> around(mesh.vertices_mm.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (Index v : mesh.triangles[t]) around[static_cast<std::size_t>(v)].push_back(t);
  std::vector<char> gone(mesh.triangles.size(), 0);
  for (std::size_t v = 0; v < around.size(); ++v) {
    std::vector<std::vector<std::size_t>> fans;
    for (std::size_t t : around[v]) {
      std::vector<std::size_t> fan{t};
      const auto joins = [&](const std::vector<std::size_t>& other) {
        return std::any_of(other.begin(), other.end(), [&](std::size_t u) {
          int shared = 0;
          for (Index p : mesh.triangles[t])
            shared += std::count(mesh.triangles[u].begin(), mesh.triangles[u].end(), p) > 0 ? 1 : 0;
          return shared == 2;
        });
      };
      for (auto& other : fans)
        if (joins(other)) {
          fan.insert(fan.end(), other.begin(), other.end());
          other.clear();
        }
      fans.push_back(fan);
    }
    const auto largest =
        std::max_element(fans.begin(), fans.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto fan = fans.begin(); fan != fans.end(); ++fan)
      for (std::size_t t : *fan) gone[t] = gone[t] || fan != largest;
  }
  std::vector<geometry::Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!gone[t]) kept.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(kept);
}

/// Drops unused vertices.
TriangleMesh compact(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::vector<Index> number(mesh.vertices_mm.size(), geometry::no_index);
  for (geometry::Triangle t : mesh.triangles) {
    for (Index& v : t) {
      Index& n = number[static_cast<std::size_t>(v)];
      if (n == geometry::no_index) {
        n = static_cast<Index>(result.vertices_mm.size());
        result.vertices_mm.push_back(mesh.vertices_mm[static_cast<std::size_t>(v)]);
      }
      v = n;
    }
    result.triangles.push_back(t);
  }
  return result;
}

/// Returns whether the vertex was moved onto a rim.
bool snap_to_rim(Vec3& v, const std::vector<Hole>& holes, double reach_mm) {
  for (const Hole& h : holes) {
    const double dx = v.x() - h.x_mm, dy = v.y() - h.y_mm, distance = std::hypot(dx, dy);
    if (std::abs(distance - h.radius_mm) > reach_mm) continue;
    v.x() = h.x_mm + dx / distance * h.radius_mm;
    v.y() = h.y_mm + dy / distance * h.radius_mm;
    return true;
  }
  return false;
}

/// The same where cells are not square: along one axis by less than half a cell.
bool snap_along_axes(Vec3& v, const std::vector<Hole>& holes, double cell_x, double cell_y) {
  for (const Hole& h : holes) {
    const double dx = v.x() - h.x_mm, dy = v.y() - h.y_mm;
    const double rim_y = std::copysign(std::sqrt(std::max(0.0, h.radius_mm * h.radius_mm - dx * dx)), dy);
    const double rim_x = std::copysign(std::sqrt(std::max(0.0, h.radius_mm * h.radius_mm - dy * dy)), dx);
    if (std::abs(dx) < h.radius_mm && std::abs(dy - rim_y) < 0.5 * cell_y) {
      v.y() = h.y_mm + rim_y;
      return true;
    }
    if (std::abs(dy) < h.radius_mm && std::abs(dx - rim_x) < 0.5 * cell_x) {
      v.x() = h.x_mm + rim_x;
      return true;
    }
  }
  return false;
}

bool in_hole(const Vec3& v, const std::vector<Hole>& holes) {
  return std::any_of(holes.begin(), holes.end(), [&](const Hole& h) {
    return std::hypot(v.x() - h.x_mm, v.y() - h.y_mm) < h.radius_mm * (1.0 - 1e-9);
  });
}

}  // namespace

namespace {

/// 0 to 1 in `cells` steps that grow evenly until the last is `density` times the first.
double graded(int i, int cells, double density) {
  const double share = static_cast<double>(i) / cells;
  return density > 1.0 ? (std::pow(density, share) - 1.0) / (density - 1.0) : share;
}

/// Moves an inner vertex onto a near rim, as the kind of cells asks for.
bool snapped(Vec3& v, const PlateOptions& o, int i, int j) {
  const double cell_x = o.width_mm / o.columns, cell_y = o.depth_mm / o.rows;
  if (!o.bricks && o.density <= 1.0) return snap_to_rim(v, o.holes, 0.5 * std::min(cell_x, cell_y));
  return snap_along_axes(v, o.holes,
                         o.width_mm * (graded(i + 1, o.columns, o.density) - graded(i, o.columns, o.density)),
                         o.depth_mm * (graded(j + 1, o.rows, o.density) - graded(j, o.rows, o.density)));
}

}  // namespace

TriangleMesh plate(const PlateOptions& o) {
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  TriangleMesh grid;
  const double cell_x = o.width_mm / o.columns, cell_y = o.depth_mm / o.rows;
  for (int j = 0; j <= o.rows; ++j)
    for (int i = 0; i <= o.columns; ++i) {
      Vec3 v((graded(i, o.columns, o.density) - 0.5) * o.width_mm, (graded(j, o.rows, o.density) - 0.5) * o.depth_mm,
             0.0);
      const bool inner = i > 0 && j > 0 && i < o.columns && j < o.rows;
      if (inner && o.bricks && j % 2 == 1) v.x() += 0.5 * cell_x;
      const bool on_rim = inner && snapped(v, o, i, j);
      if (inner && !on_rim && o.jitter > 0.0) v += o.jitter * Vec3(cell_x * unit(random), cell_y * unit(random), 0.0);
      grid.vertices_mm.push_back(v);
    }
  const auto add = [&](Index a, Index b, Index c) {
    const Vec3 &p = grid.vertices_mm[static_cast<std::size_t>(a)], &q = grid.vertices_mm[static_cast<std::size_t>(b)],
               &r = grid.vertices_mm[static_cast<std::size_t>(c)];
    const bool has_area = (q - p).cross(r - p).z() > 1e-6 * cell_x * cell_y;
    if (has_area && !in_hole((p + q + r) / 3.0, o.holes)) grid.triangles.push_back({a, b, c});
  };
  for (int j = 0; j < o.rows; ++j)
    for (int i = 0; i < o.columns; ++i) {
      const Index a = j * (o.columns + 1) + i, b = a + 1, d = a + o.columns + 1, c = d + 1;
      const bool up = o.bricks ? j % 2 == 1 : o.random_diagonals ? unit(random) > 0.0 : (i + j) % 2 == 0;
      if (up) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  for (Vec3& v : grid.vertices_mm) {
    if (o.height) v.z() = o.height(v.x(), v.y());
    if (o.noise_mm > 0.0) v.z() += o.noise_mm * unit(random);
  }
  keep_one_fan(grid);
  return compact(grid);
}

TriangleMesh ring(double inner_mm, double outer_mm, int around, int across) {
  TriangleMesh mesh;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i < around; ++i) {
      const double radius = inner_mm + (outer_mm - inner_mm) * j / across, angle = 2.0 * pi * i / around;
      mesh.vertices_mm.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around, c = b + around, d = a + around;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

TriangleMesh dome(double radius_mm, double opening_rad, int around, int across) {
  TriangleMesh mesh = ring(1.0, 2.0, around, across);
  for (Vec3& v : mesh.vertices_mm) {
    const double share = v.norm() - 1.0, polar = opening_rad + share * (0.5 * pi - opening_rad);
    const Vec3 around_z = v.normalized();
    v = radius_mm * Vec3(std::sin(polar) * around_z.x(), std::sin(polar) * around_z.y(), std::cos(polar));
  }
  return mesh;
}

TriangleMesh random_plate(std::uint32_t seed, int holes) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlateOptions o;
  o.seed = seed;
  o.columns = o.rows = 44 + static_cast<int>(random() % 20);
  o.width_mm = o.depth_mm = o.columns;  // cells of 1 mm, stretched at the end
  o.jitter = unit(random) < 0.3 ? 0.0 : 0.25 * unit(random);
  o.random_diagonals = unit(random) < 0.5;
  const bool graded_cells = unit(random) < 0.5, noisy = unit(random) < 0.5;
  const double noise_mm = noisy ? 0.05 * unit(random) : 0.0, stretch = 1.0 + 3.0 * unit(random),
               strength = graded_cells ? 0.9 * unit(random) : 0.0;
  const double bump_mm = 6.0 * unit(random), length_mm = 15.0 + 20.0 * unit(random);
  for (int tries = 0; tries < 20000 && static_cast<int>(o.holes.size()) < holes; ++tries) {
    const Hole h{(unit(random) - 0.5) * o.width_mm, (unit(random) - 0.5) * o.depth_mm, 3.0 + 2.0 * unit(random)};
    const double margin = h.radius_mm + 3.0;
    bool free = std::abs(h.x_mm) + margin < 0.5 * o.width_mm && std::abs(h.y_mm) + margin < 0.5 * o.depth_mm;
    for (const Hole& other : o.holes)
      free = free && std::hypot(h.x_mm - other.x_mm, h.y_mm - other.y_mm) > h.radius_mm + other.radius_mm + 3.0;
    if (free) o.holes.push_back(h);
  }
  TriangleMesh mesh = plate(o);
  for (Vec3& v : mesh.vertices_mm) {
    const double share = v.x() / o.width_mm + 0.5;
    v.x() = stretch * o.width_mm * (share - 0.5 * strength * share * (1.0 - share) - 0.5);
    v.z() = bump_mm * std::sin(v.x() / length_mm) * std::cos(v.y() / length_mm) + noise_mm * (2.0 * unit(random) - 1.0);
  }
  return mesh;
}

TriangleMesh stretched_plate(std::uint32_t seed, int holes) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlateOptions o;
  o.seed = seed;
  o.bricks = random() % 2 == 0;
  o.columns = o.bricks ? 16 + static_cast<int>(random() % 6) : 50;
  o.rows = o.bricks ? o.columns * (8 + static_cast<int>(random() % 18)) : 50;
  o.density = o.bricks ? 1.0 : 2.0 + 10.0 * unit(random);
  const std::vector<Hole> places{{10.0, 9.0, 4.5}, {-9.0, 10.0, 4.0}, {9.0, -9.0, 3.5}, {-10.0, -10.0, 4.0}};
  o.holes.assign(places.begin(), places.begin() + holes);
  for (Hole& h : o.holes) {
    h.x_mm += 2.0 * unit(random);
    h.y_mm += 2.0 * unit(random);
  }
  return plate(o);
}

}  // namespace volute::planner::samples

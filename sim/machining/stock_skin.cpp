// The skin of a tri-dexel solid by surface nets: one vertex in each cell of nodes that the skin passes, at the mean of
// the places where the skin crosses the cell's edges; one quad for each edge between a node inside and a node outside.
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/machining/stock.hpp"

namespace volute::sim {

/// Works in layers of constant z, so memory grows with the skin and with two layers, not with the volume.
class StockSkin {
 public:
  explicit StockSkin(const Stock& stock)
      : stock_(stock), nx_(stock.nodes_[0]), ny_(stock.nodes_[1]), nz_(stock.nodes_[2]) {}

  geometry::TriangleMesh build() {
    layers_ = {layer(-1), layer(0)};
    std::vector<int> below_cells = std::vector<int>(cell_count(), -1);
    for (int k = -1; k < nz_; ++k) {
      std::vector<int> cells(cell_count(), -1);
      add_vertices(k, cells);
      add_quads(k, below_cells, cells);
      below_cells = std::move(cells);
      layers_ = {std::move(layers_[1]), layer(k + 2)};
    }
    return std::move(mesh_);
  }

 private:
  using Layer = std::vector<char>;  // inside or not, nodes -1 .. n of x and y
  [[nodiscard]] std::size_t cell_count() const {
    return static_cast<std::size_t>(nx_ + 2) * static_cast<std::size_t>(ny_ + 2);
  }
  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(nx_ + 2) + static_cast<std::size_t>(i + 1);
  }
  [[nodiscard]] Vec3 node(int i, int j, int k) const {
    return stock_.low_mm_ + stock_.grid_mm_ * Vec3(i + 0.5, j + 0.5, k + 0.5);
  }

  /// Inside is what the rays along z say; the other families tell where along x and y the skin crosses.
  [[nodiscard]] Layer layer(int k) const {
    Layer out(cell_count(), 0);
    if (k < 0 || k >= nz_) return out;
    const double z = node(0, 0, k).z();
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        stock_.grids_[2].visit(i, j, [&](const Span& s) {
          if (s.low_mm <= z && z <= s.high_mm) out[at(i, j)] = 1;
        });
      }
    }
    return out;
  }

  /// Where the skin crosses the edge from node (i, j, k) along `axis`: an end of a span there, or the middle.
  [[nodiscard]] Vec3 crossing(int i, int j, int k, int axis) const {
    const Vec3 from = node(i, j, k);
    Vec3 out = from;
    out[axis] += 0.5 * stock_.grid_mm_;
    const std::array<int, 3> n{i, j, k};
    const DexelGrid& grid = stock_.grids_[static_cast<std::size_t>(axis)];
    const int column = n[static_cast<std::size_t>((axis + 1) % 3)], row = n[static_cast<std::size_t>((axis + 2) % 3)];
    if (column < 0 || row < 0 || column >= grid.columns() || row >= grid.rows()) return out;
    const auto take = [&](double end) {
      if (end >= from[axis] && end <= from[axis] + stock_.grid_mm_) out[axis] = end;
    };
    grid.visit(column, row, [&](const Span& s) {
      take(s.low_mm);
      take(s.high_mm);
    });
    return out;
  }

  [[nodiscard]] bool inside(int i, int j, int up) const { return layers_[static_cast<std::size_t>(up)][at(i, j)] != 0; }

  /// Vertices of the cells between layers k and k + 1; cell (i, j) spans nodes i, i + 1 and j, j + 1.
  void add_vertices(int k, std::vector<int>& cells) {
    for (int j = -1; j < ny_; ++j) {
      for (int i = -1; i < nx_; ++i) {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        const auto edge = [&](int di, int dj, int dk, int axis) {
          const int ei = di + (axis == 0), ej = dj + (axis == 1), ek = dk + (axis == 2);
          if (inside(i + di, j + dj, dk) == inside(i + ei, j + ej, ek)) return;
          sum += crossing(i + di, j + dj, k + dk, axis);
          ++count;
        };
        for (int a = 0; a < 2; ++a) {
          for (int b = 0; b < 2; ++b) {
            edge(0, a, b, 0);
            edge(a, 0, b, 1);
            edge(a, b, 0, 2);
          }
        }
        if (count == 0) continue;
        cells[at(i, j)] = static_cast<int>(mesh_.vertices_mm.size());
        mesh_.vertices_mm.push_back(sum / count);
      }
    }
  }

  void quad(int a, int b, int c, int d, bool turned) {
    if (turned) std::swap(b, d);
    mesh_.triangles.push_back({a, b, c});
    mesh_.triangles.push_back({a, c, d});
  }

  /// Quads about the edges whose four cells are known now: those along x and y in layer k, those along z between k and
  /// k + 1.
  void add_quads(int k, const std::vector<int>& below, const std::vector<int>& cells) {
    for (int j = -1; j <= ny_; ++j) {
      for (int i = -1; i <= nx_; ++i) {
        const bool here = inside(i, j, 0);
        if (i < nx_ && j > -1 && j < ny_ && here != inside(i + 1, j, 0)) {
          quad(below[at(i, j - 1)], below[at(i, j)], cells[at(i, j)], cells[at(i, j - 1)], !here);
        }
        if (j < ny_ && i > -1 && i < nx_ && here != inside(i, j + 1, 0)) {
          quad(below[at(i - 1, j)], cells[at(i - 1, j)], cells[at(i, j)], below[at(i, j)], !here);
        }
        if (k >= -1 && i > -1 && j > -1 && i < nx_ && j < ny_ && here != inside(i, j, 1)) {
          quad(cells[at(i - 1, j - 1)], cells[at(i - 1, j)], cells[at(i, j)], cells[at(i, j - 1)], here);
        }
      }
    }
  }

  const Stock& stock_;
  int nx_, ny_, nz_;
  std::array<Layer, 2> layers_;
  geometry::TriangleMesh mesh_;
};

geometry::TriangleMesh Stock::skin() const { return StockSkin(*this).build(); }

}  // namespace volute::sim

// The skin of a tri-dexel solid by surface nets: one vertex for each sheet of the skin in a cell of nodes, at the mean
// of the places where the sheet crosses the cell's edges; one polygon for each edge between a node inside and a node
// outside. A cell may hold several sheets: on a face whose inside corners lie across from each other the skin passes
// each of them by itself, which both cells of the face see alike, so the mesh is closed and every edge has two
// triangles.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "sim/machining/stock.hpp"

namespace volute::sim {

/// What a cell of eight nodes looks like.
namespace stock_skin {

/// Corner (x, y, z) of a cell, each 0 or 1, is bit x + 2 y + 4 z of its code; set: inside.
int corner_bit(const std::array<int, 3>& offset) { return offset[0] + 2 * offset[1] + 4 * offset[2]; }

constexpr int cell_edges = 12;
/// The edge of a cell along `axis` that stands off by a and b along the next two axes.
int edge_index(int axis, int a, int b) { return axis * 4 + a + 2 * b; }

struct CellEdge {
  std::array<int, 3> from{}, to{};
};
CellEdge cell_edge(int axis, int a, int b) {
  CellEdge edge;
  edge.from[static_cast<std::size_t>((axis + 1) % 3)] = a;
  edge.from[static_cast<std::size_t>((axis + 2) % 3)] = b;
  edge.to = edge.from;
  edge.to[static_cast<std::size_t>(axis)] = 1;
  return edge;
}

/// Which sheet of the skin crosses each edge of a cell; -1: none.
struct Sheets {
  std::array<std::int8_t, cell_edges> of_edge{};
  int count = 0;
};

Sheets sheets_of(int code) {
  std::array<int, cell_edges> group{}, inside_corner{};
  std::iota(group.begin(), group.end(), 0);
  const auto join = [&](int a, int b) {
    const int from = group[static_cast<std::size_t>(a)], to = group[static_cast<std::size_t>(b)];
    std::replace(group.begin(), group.end(), std::max(from, to), std::min(from, to));
  };
  std::array<std::array<int, 3>, cell_edges> stands{};
  for (int e = 0; e < cell_edges; ++e) {
    const CellEdge edge = cell_edge(e / 4, e % 2, e % 4 / 2);
    const int from = corner_bit(edge.from), to = corner_bit(edge.to);
    const bool first = (code >> from & 1) != 0, second = (code >> to & 1) != 0;
    inside_corner[static_cast<std::size_t>(e)] = first == second ? -1 : first ? from : to;
    stands[static_cast<std::size_t>(e)] = edge.from;
  }
  for (int face = 0; face < 6; ++face) {
    const int normal = face / 2, side = face % 2;
    std::vector<int> crossing;
    for (int e = 0; e < cell_edges; ++e)
      if (e / 4 != normal && stands[static_cast<std::size_t>(e)][static_cast<std::size_t>(normal)] == side &&
          inside_corner[static_cast<std::size_t>(e)] >= 0)
        crossing.push_back(e);
    for (const int a : crossing)
      for (const int b : crossing)
        if (crossing.size() == 2 ||
            inside_corner[static_cast<std::size_t>(a)] == inside_corner[static_cast<std::size_t>(b)])
          join(a, b);
  }
  Sheets out;
  out.of_edge.fill(-1);
  for (int e = 0; e < cell_edges; ++e) {
    const auto i = static_cast<std::size_t>(e);
    if (inside_corner[i] < 0) continue;
    out.of_edge[i] =
        group[i] == e ? static_cast<std::int8_t>(out.count++) : out.of_edge[static_cast<std::size_t>(group[i])];
  }
  return out;
}

const Sheets& sheets(int code) {
  static const std::vector<Sheets> table = [] {
    std::vector<Sheets> all;
    for (int c = 0; c < 256; ++c) all.push_back(sheets_of(c));
    return all;
  }();
  return table[static_cast<std::size_t>(code)];
}

/// A cell with its vertices: one a sheet, in a row.
struct Cell {
  int first_vertex = -1;
  std::uint8_t code = 0;
  [[nodiscard]] bool inside(const std::array<int, 3>& corner) const { return (code >> corner_bit(corner) & 1) != 0; }
  [[nodiscard]] int vertex(int axis, int a, int b) const {
    return first_vertex + sheets(code).of_edge[static_cast<std::size_t>(edge_index(axis, a, b))];
  }
};

}  // namespace stock_skin

/// Works in layers of constant z, so memory grows with the skin and with two layers, not with the volume.
class StockSkin {
 public:
  explicit StockSkin(const Stock& stock)
      : stock_(stock), nx_(stock.nodes_[0]), ny_(stock.nodes_[1]), nz_(stock.nodes_[2]) {}

  geometry::TriangleMesh build() {
    layers_ = {layer(-1), layer(0)};
    std::vector<Cell> below_cells(cell_count());
    for (int k = -1; k < nz_; ++k) {
      std::vector<Cell> cells(cell_count());
      add_vertices(k, cells);
      add_quads(k, below_cells, cells);
      below_cells = std::move(cells);
      layers_ = {std::move(layers_[1]), layer(k + 2)};
    }
    return std::move(mesh_);
  }

 private:
  using Cell = stock_skin::Cell;
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
  void add_vertices(int k, std::vector<Cell>& cells) {
    for (int j = -1; j < ny_; ++j) {
      for (int i = -1; i < nx_; ++i) {
        int code = 0;
        for (int bit = 0; bit < 8; ++bit) code |= inside(i + (bit & 1), j + (bit >> 1 & 1), bit >> 2) ? 1 << bit : 0;
        if (code == 0 || code == 255) continue;
        cells[at(i, j)] = {static_cast<int>(mesh_.vertices_mm.size()), static_cast<std::uint8_t>(code)};
        add_vertices_of(i, j, k, stock_skin::sheets(code));
      }
    }
  }

  void add_vertices_of(int i, int j, int k, const stock_skin::Sheets& found) {
    std::array<Vec3, 4> sum;
    std::array<int, 4> count{};
    sum.fill(Vec3::Zero());
    for (int e = 0; e < stock_skin::cell_edges; ++e) {
      const int sheet = found.of_edge[static_cast<std::size_t>(e)];
      if (sheet < 0) continue;
      const auto from = stock_skin::cell_edge(e / 4, e % 2, e % 4 / 2).from;
      sum[static_cast<std::size_t>(sheet)] += crossing(i + from[0], j + from[1], k + from[2], e / 4);
      ++count[static_cast<std::size_t>(sheet)];
    }
    for (std::size_t sheet = 0; sheet < static_cast<std::size_t>(found.count); ++sheet)
      mesh_.vertices_mm.emplace_back(sum[sheet] / count[sheet]);
  }

  /// An edge of the node grid that the skin crosses, with the four cells about it: cell [a][b] lies a and b steps back
  /// along the next two axes.
  struct Crossed {
    std::array<int, 3> node;
    int axis;
    bool from_inside;
    std::array<std::array<const Cell*, 2>, 2> cells;
  };

  /// Two sheets may pass a face whose inside corners lie across from each other, and both be the same sheet in both
  /// cells: their common edge would have four triangles. Then each gets a vertex of its own on the face. The side leads
  /// from a cell to its neighbour along axis + 1 (`along` 0) or axis + 2 (1) at offset `other` along the other.
  std::optional<int> vertex_on_face(const Crossed& edge, int along, int other) {
    const auto cell = [&](int step) -> const Cell& {
      const auto s = static_cast<std::size_t>(step), o = static_cast<std::size_t>(other);
      return along == 0 ? *edge.cells[s][o] : *edge.cells[o][s];
    };
    const auto vertex = [&](int step, int offset) {
      return along == 0 ? cell(step).vertex(edge.axis, step, offset) : cell(step).vertex(edge.axis, offset, step);
    };
    const stock_skin::CellEdge across =
        along == 0 ? stock_skin::cell_edge(edge.axis, 0, 1 - other) : stock_skin::cell_edge(edge.axis, 1 - other, 0);
    const Cell& first = cell(0);
    const bool both = first.inside(across.from) == !edge.from_inside && first.inside(across.to) == edge.from_inside;
    if (!both || vertex(0, other) != vertex(0, 1 - other) || vertex(1, other) != vertex(1, 1 - other))
      return std::nullopt;
    std::array<int, 3> corner = edge.node;  // the inside one of this sheet
    if (!edge.from_inside) ++corner[static_cast<std::size_t>(edge.axis)];
    const std::int64_t number =
        corner[0] + 1 + (nx_ + 2) * (corner[1] + 1 + static_cast<std::int64_t>(ny_ + 2) * (corner[2] + 1));
    const auto [known, added] = face_vertices_.try_emplace({vertex(0, other), vertex(1, other), number},
                                                           static_cast<int>(mesh_.vertices_mm.size()));
    if (added) {
      const int side_axis = (edge.axis + (along == 0 ? 2 : 1)) % 3;
      if (other == 1) --corner[static_cast<std::size_t>(side_axis)];
      mesh_.vertices_mm.emplace_back(0.5 * (crossing(edge.node[0], edge.node[1], edge.node[2], edge.axis) +
                                            crossing(corner[0], corner[1], corner[2], side_axis)));
    }
    return known->second;
  }

  /// The polygon about a crossed edge; a fan from a vertex on a face, where there is one.
  void add_polygon(const Crossed& edge) {
    std::vector<int>& ring = ring_;
    ring.clear();
    std::size_t start = 0;
    const auto corner = [&](int a, int b) {
      ring.push_back(edge.cells[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]->vertex(edge.axis, a, b));
    };
    const auto side = [&](int along, int other) {
      if (const auto vertex = vertex_on_face(edge, along, other)) {
        start = ring.size();
        ring.push_back(*vertex);
      }
    };
    corner(1, 1);
    side(0, 1);
    corner(0, 1);
    side(1, 0);
    corner(0, 0);
    side(0, 0);
    corner(1, 0);
    side(1, 1);
    const std::size_t size = ring.size();
    for (std::size_t k = 1; k + 1 < size; ++k) {
      geometry::Triangle t{ring[start], ring[(start + k) % size], ring[(start + k + 1) % size]};
      if (!edge.from_inside) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
  }

  /// Polygons about the edges whose four cells are known now: those along x and y in layer k, those along z between k
  /// and k + 1.
  void add_quads(int k, const std::vector<Cell>& below, const std::vector<Cell>& cells) {
    for (int j = -1; j <= ny_; ++j) {
      for (int i = -1; i <= nx_; ++i) {
        const bool here = inside(i, j, 0);
        if (i < nx_ && j > -1 && j < ny_ && here != inside(i + 1, j, 0))
          add_polygon({{i, j, k},
                       0,
                       here,
                       {{{&cells[at(i, j)], &below[at(i, j)]}, {&cells[at(i, j - 1)], &below[at(i, j - 1)]}}}});
        if (j < ny_ && i > -1 && i < nx_ && here != inside(i, j + 1, 0))
          add_polygon({{i, j, k},
                       1,
                       here,
                       {{{&cells[at(i, j)], &cells[at(i - 1, j)]}, {&below[at(i, j)], &below[at(i - 1, j)]}}}});
        if (i > -1 && j > -1 && i < nx_ && j < ny_ && here != inside(i, j, 1))
          add_polygon({{i, j, k},
                       2,
                       here,
                       {{{&cells[at(i, j)], &cells[at(i, j - 1)]}, {&cells[at(i - 1, j)], &cells[at(i - 1, j - 1)]}}}});
      }
    }
  }

  const Stock& stock_;
  int nx_, ny_, nz_;
  std::array<Layer, 2> layers_;
  std::map<std::tuple<int, int, std::int64_t>, int> face_vertices_;
  std::vector<int> ring_;
  geometry::TriangleMesh mesh_;
};

geometry::TriangleMesh Stock::skin() const { return StockSkin(*this).build(); }

}  // namespace volute::sim

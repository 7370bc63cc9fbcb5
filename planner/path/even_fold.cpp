#include "planner/path/even_fold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "planner/path/even_collar.hpp"
#include "planner/path/point_grid.hpp"
#include "planner/surface/slice_path.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

using geometry::at;
using geometry::no_index;
namespace {

constexpr double passes_more = 2.0;

using CornerJumps = std::vector<std::array<double, 3>>;

/// Vertices at which phi is given: there theta stays.
std::vector<char> given_vertices(const EvenDomain& domain, const IntervalRule& rule) {
  std::vector<char> given(domain.mesh.vertices_mm.size(), 0);
  for (const auto& loop : domain.topology.boundary_loops()) {
    for (Index v : loop.vertices) given[at(v)] = 1;
  }
  for (const CollarVertex& c : slit_collar(domain, rule)) given[at(c.vertex)] = 1;
  return given;
}

/// Cost of edges for a cut that keeps to the direction of the passes and off the vertices given.
EdgeCost along_passes(const EvenDomain& domain, const std::vector<char>& given) {
  constexpr double crossing = 4.0;  // costs so much as going along
  std::vector<double> slope(given.size(), 0.0), area(given.size(), 0.0);
  const auto gradients = gradient(domain.mesh, domain.operators, domain.harmonic);
  for (std::size_t t = 0; t < gradients.size(); ++t) {
    for (Index v : domain.mesh.triangles[t]) {
      slope[at(v)] += domain.operators[t].area_mm2 * gradients[t].norm();
      area[at(v)] += domain.operators[t].area_mm2;
    }
  }
  for (std::size_t v = 0; v < slope.size(); ++v) slope[v] = std::max(slope[v] / area[v], 1e-12);
  return [&domain, &given, slope = std::move(slope)](Index from, Index to) {
    if (given[at(to)] != 0) return std::numeric_limits<double>::infinity();
    const double length_mm = (domain.mesh.vertices_mm[at(to)] - domain.mesh.vertices_mm[at(from)]).norm();
    const double across_mm = std::abs(domain.harmonic[at(to)] - domain.harmonic[at(from)]) / slope[at(from)];
    return length_mm + crossing * std::min(across_mm, length_mm);
  };
}

/// The halfedge from one vertex to another. Requires: an inner edge joins them.
Index halfedge_between(const EvenDomain& domain, Index from, Index to) {
  for (Index h : domain.topology.outgoing(from)) {
    if (domain.mesh.triangles[at(h / 3)][at(geometry::next_halfedge(h) % 3)] == to) return h;
  }
  VOLUTE_CHECK(false, from, to);
  return no_index;
}

/// One end of an open line.
struct LineEnd {
  std::size_t line = 0;
  bool back = false;  ///< its last point, else its first
  long level = 0;     ///< in the frame of the fold's end
};

Index halfedge_of(const LevelLine& line, bool back) { return back ? line.to_halfedge : line.from_halfedge; }

/// Errors (bad_input): fold-near, where two folds end within `least_mm` of each other.
Result<void> ends_apart(const EvenDomain& domain, std::span<const Fold> folds, double least_mm) {
  std::vector<Index> ends;
  for (const Fold& fold : folds) {
    for (Index end : {fold.from, fold.to}) {
      for (Index other : ends) {
        if ((domain.mesh.vertices_mm[at(end)] - domain.mesh.vertices_mm[at(other)]).norm() < least_mm)
          return geometry::bad_input("fold-near", "two folds end within two intervals of each other");
      }
    }
    ends.push_back(fold.from);
    ends.push_back(fold.to);
  }
  return {};
}

/// The chain of edges from one end of a fold to the other.
Result<std::vector<Index>> fold_cut(const EvenDomain& domain, const std::vector<char>& given, const EdgeCost& cost,
                                    const Fold& fold) {
  constexpr std::size_t vertices_min = 5;  // both ends' edges, and one between
  if (given[at(fold.from)] != 0 || given[at(fold.to)] != 0)
    return geometry::bad_input("fold-given", "a fold ends where the field is given");
  const auto way =
      shortest_edge_path(domain.mesh, domain.topology, std::span(&fold.from, 1), std::span(&fold.to, 1), cost);
  if (!way) return tl::unexpected(way.error());
  std::vector<Index> out;
  for (const SurfacePoint& p : *way) out.push_back(p.a);
  if (out.size() < vertices_min) return geometry::bad_input("fold-short", "the ends of a fold are too near each other");
  return out;
}

/// The harmonic function with these jumps, 0 where given: what the folds add to theta.
Result<Eigen::VectorXd> growth_with(const EvenDomain& domain, const std::vector<char>& given, const CornerJumps& jump) {
  std::vector<Vec2> jump_gradient(jump.size());
  for (std::size_t t = 0; t < jump.size(); ++t)
    jump_gradient[t] = domain.operators[t].gradient(jump[t][0], jump[t][1], jump[t][2]);
  const auto load = divergence(domain.mesh, domain.operators, jump_gradient);
  const Eigen::VectorXd right = -Eigen::Map<const Eigen::VectorXd>(load.data(), static_cast<Eigen::Index>(load.size()));
  std::vector<int> fixed;
  for (std::size_t v = 0; v < given.size(); ++v) {
    if (given[v] != 0) fixed.push_back(static_cast<int>(v));
  }
  const auto solved = solve_with_fixed(cotan_laplacian(domain.mesh), fixed,
                                       Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(fixed.size()), 1), right);
  if (!solved) return tl::unexpected(solved.error());
  return Eigen::VectorXd(solved->col(0));
}

}  // namespace

std::vector<Index> torn_edges(const EvenDomain& domain) {
  std::vector<Index> out;
  for (const auto& fold : domain.folds) {
    out.push_back(domain.topology.edge(halfedge_between(domain, fold[0], fold[1])));
    out.push_back(domain.topology.edge(halfedge_between(domain, fold.back(), fold[fold.size() - 2])));
  }
  return out;
}

Result<void> lay_folds(EvenDomain& domain, const IntervalRule& rule, std::span<const Fold> folds) {
  if (folds.empty()) return {};
  if (auto apart = ends_apart(domain, folds, 2.0 * rule.interval_mm(0.0)); !apart) return apart;
  const auto given = given_vertices(domain, rule);
  const EdgeCost cost = along_passes(domain, given);
  CornerJumps jump(domain.mesh.triangles.size(), std::array<double, 3>{});
  for (const Fold& fold : folds) {
    auto cut = fold_cut(domain, given, cost, fold);
    if (!cut) return tl::unexpected(cut.error());
    const auto one = seam_jump(domain.topology, *cut);
    for (std::size_t t = 0; t < jump.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) jump[t][k] += passes_more * one[t][k];
    }
    domain.folds.push_back(std::move(*cut));
  }
  const auto growth = growth_with(domain, given, jump);
  if (!growth) return tl::unexpected(growth.error());
  for (std::size_t v = 0; v < given.size(); ++v) domain.theta.vertex[v] += (*growth)[static_cast<Eigen::Index>(v)];
  for (std::size_t t = 0; t < jump.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) domain.theta.jump[t][k] += jump[t][k];
  }
  return {};
}

namespace {

/// Which end every end of an open line goes on with: lines through the fold by their level, the two left over with each
/// other.
class Joints {
 public:
  Joints(const EvenDomain& domain, const std::vector<LevelLine>& lines) : next_(2 * lines.size(), none) {
    std::map<Index, std::pair<Index, std::vector<LineEnd>>> ends;  // by edge: the fold's end, and what arrives
    const auto torn = torn_edges(domain);
    for (std::size_t f = 0; f < domain.folds.size(); ++f) {
      ends[torn[2 * f]].first = domain.folds[f].front();
      ends[torn[2 * f + 1]].first = domain.folds[f].back();
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].closed) continue;
      for (const bool back : {false, true}) {
        const Index h = halfedge_of(lines[i], back);
        const auto found = ends.find(domain.topology.edge(h));
        if (found == ends.end()) continue;
        const long level = back ? lines[i].to_level : lines[i].from_level;
        found->second.second.push_back({i, back, level + frame_of(domain, h, found->second.first)});
      }
    }
    for (auto& [edge, arrived] : ends) join(lines, arrived.second);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// Number of an end: twice the line's, one more for its last point.
  [[nodiscard]] std::size_t next(std::size_t line, bool back) const { return next_[2 * line + (back ? 1 : 0)]; }

 private:
  static long frame_of(const EvenDomain& domain, Index h, Index core) {
    const auto& corners = domain.mesh.triangles[at(h / 3)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] == core) return std::lround(domain.theta.jump[at(h / 3)][k]);
    }
    VOLUTE_CHECK(false, h, core);
    return 0;
  }
  void join(const std::vector<LevelLine>& lines, std::vector<LineEnd>& ends) {
    const auto side = [&](const LineEnd& e) { return halfedge_of(lines[e.line], e.back); };
    std::sort(ends.begin(), ends.end(), [&](const LineEnd& a, const LineEnd& b) {
      return a.level != b.level ? a.level < b.level : side(a) < side(b);
    });
    std::vector<LineEnd> left;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (i + 1 < ends.size() && ends[i].level == ends[i + 1].level && side(ends[i]) != side(ends[i + 1])) {
        link(ends[i], ends[i + 1]);
        ++i;
      } else {
        left.push_back(ends[i]);
      }
    }
    for (std::size_t i = 0; i + 1 < left.size(); i += 2) link(left[i], left[i + 1]);
  }
  void link(const LineEnd& a, const LineEnd& b) {
    next_[2 * a.line + (a.back ? 1 : 0)] = 2 * b.line + (b.back ? 1 : 0);
    next_[2 * b.line + (b.back ? 1 : 0)] = 2 * a.line + (a.back ? 1 : 0);
  }
  std::vector<std::size_t> next_;
};

void append(LevelLine& chain, const LevelLine& line, bool backwards) {
  if (!chain.points.empty()) chain.triangles.push_back(backwards ? line.triangles.back() : line.triangles.front());
  if (backwards) {
    chain.points.insert(chain.points.end(), line.points.rbegin(), line.points.rend());
    chain.triangles.insert(chain.triangles.end(), line.triangles.rbegin(), line.triangles.rend());
  } else {
    chain.points.insert(chain.points.end(), line.points.begin(), line.points.end());
    chain.triangles.insert(chain.triangles.end(), line.triangles.begin(), line.triangles.end());
  }
  chain.length_mm += line.length_mm;
}

}  // namespace

std::vector<LevelLine> joined_at_folds(const EvenDomain& domain, std::vector<LevelLine> lines) {
  if (domain.folds.empty()) return lines;
  const Joints joints(domain, lines);
  std::vector<char> used(lines.size(), 0);
  std::vector<LevelLine> out;
  const auto follow = [&](std::size_t line, bool backwards) {
    LevelLine chain;
    while (used[line] == 0) {
      used[line] = 1;
      append(chain, lines[line], backwards);
      const std::size_t next = joints.next(line, !backwards);
      if (next == Joints::none) return chain;
      line = next / 2;
      backwards = next % 2 == 1;
    }
    chain.closed = true;
    chain.triangles.push_back(chain.triangles.front());  // along the torn edge, back to the first point
    return chain;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i] != 0) continue;
    if (lines[i].closed) {
      used[i] = 1;
      out.push_back(std::move(lines[i]));
    } else if (joints.next(i, false) == Joints::none) {
      out.push_back(follow(i, false));
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i] == 0) out.push_back(follow(i, joints.next(i, true) == Joints::none));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const LevelLine& a, const LevelLine& b) { return a.length_mm > b.length_mm; });
  return out;
}

namespace {

/// Whether there are more passes across a fold than beside it: phi grows to its left.
bool adds_passes(const EvenDomain& domain, const std::vector<Index>& fold) {
  double left = 0.0;
  for (std::size_t i = 0; i + 1 < fold.size(); ++i) {
    for (Index h : domain.topology.outgoing(fold[i])) {
      const auto& c = domain.mesh.triangles[at(h / 3)];
      if (c[at(geometry::next_halfedge(h) % 3)] == fold[i + 1])
        left += domain.harmonic[at(c[at(geometry::previous_halfedge(h) % 3)])] -
                0.5 * (domain.harmonic[at(fold[i])] + domain.harmonic[at(fold[i + 1])]);
    }
  }
  return left > 0.0;
}

std::array<double, 2> levels_at_ends(const EvenDomain& domain, const std::vector<Index>& fold, const EvenField& field) {
  const auto level = [&](Index v) { return field.phi[at(v)] - domain.theta.vertex[at(v)]; };
  return {level(fold.front()), level(fold.back())};
}

/// Levels for one fold, and how far off the field's own they are.
struct LevelChoice {
  std::array<double, 2> levels{};
  double off_squared = 0.0;
};

/// Where the passes that turn back at one end are next to those of the other: the piece between runs backwards and
/// nothing else changes. Seen across the fold that is one level apart where it adds passes; where it takes them away
/// the passes are added on the way round the other side, on which levels fall by one.
std::vector<LevelChoice> level_choices(const EvenDomain& domain, const std::vector<Index>& fold,
                                       const EvenField& field) {
  const auto [from, to] = levels_at_ends(domain, fold, field);
  const bool adds = adds_passes(domain, fold);
  std::vector<LevelChoice> out;
  for (double a = std::floor(std::min(from, to)) - 1.0; a <= std::max(from, to) + 2.0; a += 1.0) {
    for (const double b : {adds ? a - 1.0 : a, adds ? a + 1.0 : a + 2.0})
      out.push_back({{a, b}, (a - from) * (a - from) + (b - to) * (b - to)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const LevelChoice& a, const LevelChoice& b) { return a.off_squared < b.off_squared; });
  return out;
}

}  // namespace

double fold_misfit(const EvenDomain& domain, const EvenField& field) {
  double sum = 0.0;
  for (const auto& fold : domain.folds) sum += level_choices(domain, fold, field).front().off_squared;
  return sum;
}

std::vector<std::vector<std::array<double, 2>>> fold_choices(const EvenDomain& domain, const EvenField& field) {
  constexpr std::size_t kept = 3;  // of each fold
  std::vector<std::vector<LevelChoice>> each;
  for (const auto& fold : domain.folds) {
    each.push_back(level_choices(domain, fold, field));
    each.back().resize(std::min(each.back().size(), kept));
  }
  struct Combination {
    std::vector<std::array<double, 2>> levels;
    double off_squared = 0.0;
  };
  std::vector<Combination> all;
  const auto add = [&](std::span<const std::size_t> chosen) {
    Combination one;
    for (std::size_t f = 0; f < each.size(); ++f) {
      one.levels.push_back(each[f][chosen[f]].levels);
      one.off_squared += each[f][chosen[f]].off_squared;
    }
    all.push_back(std::move(one));
  };
  std::vector<std::size_t> chosen(each.size(), 0);
  add(chosen);
  for (std::size_t f = 0; f < each.size(); ++f) {
    for (chosen[f] = 1; chosen[f] < each[f].size(); ++chosen[f]) {
      add(chosen);
      for (std::size_t g = f + 1; g < each.size(); ++g) {
        for (chosen[g] = 1; chosen[g] < each[g].size(); ++chosen[g]) add(chosen);
        chosen[g] = 0;
      }
    }
    chosen[f] = 0;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Combination& a, const Combination& b) { return a.off_squared < b.off_squared; });
  std::vector<std::vector<std::array<double, 2>>> out;
  for (Combination& one : all) out.push_back(std::move(one.levels));
  return out;
}

bool splice(const TriangleMesh& mesh, const LevelLine& ring, double reach_mm, LevelLine& line) {
  VOLUTE_CHECK(ring.closed && line.points.size() > 1, ring.points.size(), line.points.size());
  std::vector<Vec3> places;
  for (const SurfacePoint& p : line.points) places.push_back(position_mm(mesh, p));
  const PointGrid grid(places, reach_mm);
  std::size_t leave = 0, enter = 0;
  double least = reach_mm * reach_mm;
  for (std::size_t j = 0; j < ring.points.size(); ++j) {
    const Vec3 place = position_mm(mesh, ring.points[j]);
    grid.near(place, reach_mm, [&](Index i) {
      const double off = (places[at(i)] - place).squaredNorm();
      if (at(i) + 1 >= places.size() || !(off < least)) return;
      least = off;
      leave = at(i);
      enter = j;
    });
  }
  if (!(least < reach_mm * reach_mm)) return false;
  std::vector<SurfacePoint> points;
  std::vector<Index> triangles;
  const std::size_t n = ring.points.size();
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t j = (enter + n - step) % n;
    points.push_back(ring.points[j]);
    triangles.push_back(ring.triangles[(j + n - 1) % n]);
  }
  const auto after = static_cast<std::ptrdiff_t>(leave) + 1;
  line.points.insert(line.points.begin() + after, points.begin(), points.end());
  line.triangles.insert(line.triangles.begin() + after, triangles.begin(), triangles.end());
  line.length_mm += ring.length_mm;
  return true;
}

}  // namespace volute::planner

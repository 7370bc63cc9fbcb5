#include "planner/path/spiral.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/check.hpp"
#include "geometry/index.hpp"
#include "geometry/number_text.hpp"
#include "planner/path/level_trace.hpp"
#include "planner/surface/edge_curve.hpp"

namespace volute::planner {

using geometry::at;
using geometry::bad_input;
using geometry::MeshTopology;

namespace {

/// Edges whose end normals differ more are creases, not chords of a smooth surface: the edge stands for itself.
const double crease_cosine = std::cos(0.35);

/// Turns places on the ring's mesh into raw points on the nominal surface.
class Placer {
 public:
  Placer(const Annulus& annulus, const GuideField& field, double bulge_max_mm)
      : annulus_(annulus), field_(field), bulge_max_mm_(bulge_max_mm) {}

  /// Eq. 15-17 on the edge's curve.
  [[nodiscard]] RawPoint operator()(const SurfacePoint& place) const {
    const Vec3 &p = annulus_.ring.vertices_mm[at(place.a)], &n = annulus_.ring_normals[at(place.a)];
    if (place.is_vertex()) return {p, n, field_.turns[at(place.a)], Vec3::Zero()};
    const Vec3 &q = annulus_.ring.vertices_mm[at(place.b)], &m = annulus_.ring_normals[at(place.b)];
    RawPoint raw;
    raw.normal = ((1.0 - place.t) * n + place.t * m).normalized();
    raw.turn = (1.0 - place.t) * field_.turns[at(place.a)] + place.t * field_.turns[at(place.b)];
    const EdgeCurve curve(p, q, n, m);
    if (n.dot(m) < crease_cosine || (curve.point_mm(0.5) - 0.5 * (p + q)).norm() > bulge_max_mm_) {
      raw.point_mm = p + place.t * (q - p);
      return raw;
    }
    raw.point_mm = curve.point_mm(place.t);
    raw.edge_tangent = curve.derivative_mm(place.t).normalized();
    return raw;
  }

 private:
  const Annulus& annulus_;
  const GuideField& field_;
  double bulge_max_mm_;
};

/// Level lines of turns -+ around with the path's direction along them.
std::vector<LevelLine> guide_lines(const Annulus& annulus, const MeshTopology& topology, const GuideField& field,
                                   Sense sense, double offset) {
  const double sign = sense == Sense::counter_clockwise ? 1.0 : -1.0;
  std::vector<double> value = field.turns;
  for (std::size_t v = 0; v < value.size(); ++v) value[v] -= sign * field.around.vertex[v];
  std::vector<std::array<double, 3>> jump = field.around.jump;
  for (auto& corners : jump)
    for (double& j : corners) j *= sign;
  auto lines = trace_levels(annulus.ring, topology, {value, jump}, offset);
  if (sense == Sense::clockwise)
    for (LevelLine& line : lines) {
      std::reverse(line.points.begin(), line.points.end());
      std::reverse(line.triangles.begin(), line.triangles.end());
    }
  return lines;
}

/// A boundary of the ring by its coordinate around, which rises from its first vertex by one turn.
class BoundaryArc {
 public:
  BoundaryArc(const std::vector<Index>& loop, const std::vector<double>& around)
      : loop_(loop), share_(turns_along(loop, around)) {
    double reached = 0.0;
    for (double& share : share_) share = reached = std::clamp(share, reached, 1.0);
  }

  /// Where on the loop a place inside one of its edges lies, 0 to 1; nothing when it is on another boundary.
  [[nodiscard]] std::optional<double> share_of(const SurfacePoint& place) const {
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const std::size_t j = (i + 1) % loop_.size();
      const double end = j == 0 ? 1.0 : share_[j];
      if (loop_[i] == place.a && loop_[j] == place.b) return share_[i] + place.t * (end - share_[i]);
      if (loop_[i] == place.b && loop_[j] == place.a) return end + place.t * (share_[i] - end);
    }
    return std::nullopt;
  }

  /// The vertices strictly between two shares, from `from` on, upwards or downwards, less than a turn.
  [[nodiscard]] std::vector<Index> between(double from, double to) const {
    std::vector<Index> result;
    const bool up = to > from;
    const double low = std::min(from, to), high = std::max(from, to);
    for (int turn = -1; turn <= 1; ++turn)
      for (std::size_t i = 0; i < loop_.size(); ++i) {
        const double share = share_[i] + turn;
        if (share > low + 1e-9 && share < high - 1e-9) result.push_back(loop_[i]);
      }
    if (!up) std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  const std::vector<Index>& loop_;
  std::vector<double> share_;
};

double fraction(double x) { return x - std::floor(x); }

/// The boundary that the path begins on, and how far around it the wanted start lies, 0 to 1.
struct Start {
  const std::vector<Index>& loop;
  double share = 0.0, turns = 0.0;  ///< turns: of the field on this boundary
};
std::optional<Start> start_of(const Annulus& annulus, const GuideField& field, const GuideOptions& options) {
  if (!options.start_P_mm) return std::nullopt;
  const bool inward = options.direction == Direction::inward;
  const std::vector<Index>& loop = inward ? annulus.outer : annulus.inner;
  const auto off_sq = [&](Index v) { return (annulus.ring.vertices_mm[at(v)] - *options.start_P_mm).squaredNorm(); };
  const auto nearest =
      std::min_element(loop.begin(), loop.end(), [&](Index a, Index b) { return off_sq(a) < off_sq(b); });
  const std::vector<double> share = turns_along(loop, field.around.vertex);
  return Start{loop, share[static_cast<std::size_t>(nearest - loop.begin())], inward ? 0.0 : field.turn_count};
}

/// The level lines, modulo 1, of which one starts half a turn behind the wanted start (eq. 11 with another phase).
double spiral_offset(const Annulus& annulus, const GuideField& field, const GuideOptions& options) {
  const auto start = start_of(annulus, field, options);
  if (!start) return 0.5;
  const double sign = options.sense == Sense::counter_clockwise ? 1.0 : -1.0;
  // The guide line leaves the outer boundary half a turn on, and meets the inner one half a turn before.
  const double half_turn = options.direction == Direction::inward ? 0.5 * sign : -0.5 * sign;
  return fraction(start->turns - sign * (field.around.vertex[at(start->loop.front())] + start->share + half_turn));
}

/// The coordinate around of the line on which contour-parallel passes begin.
double link_offset(const Annulus& annulus, const GuideField& field, const GuideOptions& options) {
  const auto start = start_of(annulus, field, options);
  return start ? fraction(field.around.vertex[at(start->loop.front())] + start->share) : 0.5;
}

/// Middles of the edges at which the path crosses the seam.
std::vector<Vec3> seam_crossings(const Annulus& annulus, const LevelLine& line) {
  std::set<std::array<Index, 2>> seam;
  for (std::size_t i = 0; i + 1 < annulus.seam.size(); ++i)
    seam.insert({std::min(annulus.seam[i], annulus.seam[i + 1]), std::max(annulus.seam[i], annulus.seam[i + 1])});
  std::vector<Vec3> result;
  for (const SurfacePoint& p : line.points)
    if (seam.contains({std::min(p.a, p.b), std::max(p.a, p.b)})) result.push_back(position_mm(annulus.ring, p));
  return result;
}

/// The line in the map; a new stretch where it crosses the seam.
void draw_in_map(const Annulus& annulus, const GuideField& field, const LevelLine& line,
                 std::vector<std::vector<geometry::Vec2>>& drawing) {
  const auto in_map = [&](Index triangle, const SurfacePoint& p) {
    geometry::Vec2 sum = geometry::Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = annulus.ring.triangles[at(triangle)][k];
      const double share = v == p.a ? 1.0 - p.t : v == p.b ? p.t : 0.0;
      sum += share * field.map[at(annulus.sheet.triangles[at(triangle)][k])];
    }
    return sum;
  };
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const geometry::Vec2 from = in_map(line.triangles[i], line.points[i]),
                         to = in_map(line.triangles[i], line.points[i + 1]);
    if (i == 0 || (drawing.back().back() - from).norm() > 1e-6 * (1.0 + from.norm())) drawing.push_back({from});
    drawing.back().push_back(to);
  }
}

tl::unexpected<geometry::Error> broken(const std::string& what, const Vec3& where) {
  return bad_input("path-broken", what + " near (" + geometry::short_text(where.x()) + ", " +
                                      geometry::short_text(where.y()) + ", " + geometry::short_text(where.z()) +
                                      "); refine the mesh there or choose another method");
}

/// The passes' place on the link from boundary to boundary: the first point of the link at or behind each level.
std::size_t first_at_level(const std::vector<RawPoint>& link, double level) {
  std::size_t i = 0;
  while (i + 1 < link.size() && link[i].turn < level) ++i;
  return i;
}

/// Rotates a closed chain so that it starts nearest to a point, and closes it.
std::vector<RawPoint> closed_from(std::vector<RawPoint> loop, const Vec3& near_mm) {
  const auto nearest = std::min_element(loop.begin(), loop.end(), [&](const RawPoint& a, const RawPoint& b) {
    return (a.point_mm - near_mm).squaredNorm() < (b.point_mm - near_mm).squaredNorm();
  });
  std::rotate(loop.begin(), nearest, loop.end());
  loop.push_back(loop.front());
  return loop;
}

std::vector<RawPoint> place_all(const Placer& place, const std::vector<Index>& vertices) {
  std::vector<RawPoint> result;
  for (Index v : vertices) result.push_back(place(SurfacePoint::vertex(v)));
  return result;
}

/// The line at a constant coordinate around from the outer boundary to the inner one: where links run.
Result<std::vector<RawPoint>> link_line(const Annulus& annulus, const MeshTopology& topology, const GuideField& field,
                                        const GuideOptions& options) {
  std::vector<double> value = field.around.vertex;
  std::vector<std::array<double, 3>> jump = field.around.jump;
  for (auto& corners : jump)
    for (double& j : corners) j = -j;
  const auto lines = trace_levels(annulus.ring, topology, {value, jump}, link_offset(annulus, field, options));
  if (lines.empty() || lines.front().closed)
    return broken("no line runs from the outer boundary to the inner one", annulus.ring.vertices_mm[0]);
  const Placer place(annulus, field, options.bulge_max_mm);
  std::vector<RawPoint> link;
  for (const SurfacePoint& p : lines.front().points) link.push_back(place(p));
  if (link.front().turn > link.back().turn) std::reverse(link.begin(), link.end());
  return link;
}

/// All passes from outside in.
std::vector<std::vector<RawPoint>> passes_of(const Annulus& annulus, const MeshTopology& topology,
                                             const GuideField& field, const GuideOptions& options) {
  const Placer place(annulus, field, options.bulge_max_mm);
  std::vector<std::vector<RawPoint>> passes{place_all(place, annulus.outer)};
  auto lines = trace_levels(annulus.ring, topology, {field.turns, {}}, 0.0);
  std::erase_if(lines, [](const LevelLine& line) { return !line.closed; });
  const auto level = [&](const LevelLine& line) { return std::lround(place(line.points.front()).turn); };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const LevelLine& a, const LevelLine& b) { return level(a) < level(b); });
  long last = 0;
  for (const LevelLine& line : lines) {
    // Lines come by falling length: of several on one level the first is the pass. The last 5 % of a pass belong to the
    // boundary.
    if (level(line) <= last || static_cast<double>(level(line)) > field.turn_count - 0.05) continue;
    last = level(line);
    passes.emplace_back();  // greater values on the left: counter-clockwise
    for (const SurfacePoint& p : line.points) passes.back().push_back(place(p));
  }
  passes.push_back(place_all(place, annulus.inner));
  if (options.sense == Sense::clockwise)
    for (auto& pass : passes) std::reverse(pass.begin(), pass.end());
  return passes;
}

}  // namespace

Result<GuidePath> spiral_of(const Annulus& annulus, const GuideField& field, const GuideOptions& options) {
  const auto topology = MeshTopology::build(annulus.ring);
  if (!topology) return tl::unexpected(topology.error());
  const auto lines = guide_lines(annulus, *topology, field, options.sense, spiral_offset(annulus, field, options));
  if (lines.empty())
    return broken("no guide line starts on the outer boundary", annulus.ring.vertices_mm[at(annulus.outer[0])]);
  const LevelLine& spiral = lines.front();
  const BoundaryArc outer(annulus.outer, field.around.vertex), inner(annulus.inner, field.around.vertex);
  const auto start = outer.share_of(spiral.points.front()), end = inner.share_of(spiral.points.back());
  if (spiral.closed || !start || !end)
    return broken("the spiral does not run from the outer boundary to the inner one: it ends",
                  position_mm(annulus.ring, spiral.points.back()));
  GuidePath path;
  path.lines_dropped = static_cast<int>(lines.size()) - 1;
  path.seam_crossings_mm = seam_crossings(annulus, spiral);
  draw_in_map(annulus, field, spiral, path.map_lines);
  const Placer place(annulus, field, options.bulge_max_mm);
  const double half_turn = options.sense == Sense::counter_clockwise ? 0.5 : -0.5;
  RawStretch whole;
  whole.points = place_all(place, outer.between(*start - half_turn, *start));
  for (const SurfacePoint& p : spiral.points) whole.points.push_back(place(p));
  for (const RawPoint& p : place_all(place, inner.between(*end, *end + half_turn))) whole.points.push_back(p);
  path.stretches.push_back(std::move(whole));
  return path;
}

Result<GuidePath> contours_of(const Annulus& annulus, const GuideField& field, const GuideOptions& options) {
  const auto topology = MeshTopology::build(annulus.ring);
  if (!topology) return tl::unexpected(topology.error());
  const auto link = link_line(annulus, *topology, field, options);
  if (!link) return tl::unexpected(link.error());
  const auto passes = passes_of(annulus, *topology, field, options);
  GuidePath path;
  std::size_t link_at = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const std::size_t next = i + 1 == passes.size() ? link->size() - 1 : first_at_level(*link, static_cast<double>(i));
    RawStretch pass{closed_from(passes[i], (*link)[next].point_mm), false};
    if (i > 0) {
      RawStretch across{{path.stretches.back().points.back()}, true};
      for (std::size_t k = link_at + 1; k < next; ++k) across.points.push_back((*link)[k]);
      across.points.push_back(pass.points.front());
      path.stretches.push_back(std::move(across));
    }
    path.stretches.push_back(std::move(pass));
    link_at = next;
  }
  return path;
}

}  // namespace volute::planner

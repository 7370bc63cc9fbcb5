#include "sim/collision.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"
#include "sim/collision_scene.hpp"

namespace volute::sim {
namespace {

using geometry::short_text;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Where the moving things stand.
struct Stand {
  std::vector<Transform> X_M;
};  // one a body

/// A state between two, or one of them; `index` is that of the state at the end of the move.
struct Moment {
  AxisVector q;
  std::int64_t line;
  double time_s;
  std::size_t index;
};

struct Contact {
  std::size_t pair;
  double distance_mm;
  Moment at;
};

/// What a piece of the run gives; pieces are joined in order.
struct PieceReport {
  std::int64_t pairs = 0;
  double closest_mm = infinite;
  std::size_t closest_pair = 0;
  std::int64_t at_line = 0;
  std::vector<Contact> contacts;
};

class RunCheck {
 public:
  RunCheck(const CollisionPairs& pairs, const std::vector<MachineState>& states, double clearance_mm, double step_mm)
      : pairs_(pairs), states_(states), clearance_mm_(clearance_mm), step_mm_(step_mm) {}

  /// Checks the states [first, last] and what lies between them.
  [[nodiscard]] PieceReport check(std::size_t first, std::size_t last) const {
    PieceReport report;
    std::vector<double> free_mm(pairs_.pairs.size());  // how far a pair may still move before it must be looked at
    Stand here = stand(states_[first].q);
    for (std::size_t p = 0; p < free_mm.size(); ++p) free_mm[p] = look(p, moment(first, first, 1.0), report);
    for (std::size_t i = first + 1; i <= last; ++i) {
      Stand next = stand(states_[i].q);
      const std::vector<double> moved = motion(here, next);
      for (std::size_t p = 0; p < moved.size(); ++p) {
        if (moved[p] < free_mm[p])
          free_mm[p] -= moved[p];
        else
          follow(p, i, moved[p], free_mm[p], report);
      }
      here = std::move(next);
    }
    return report;
  }

 private:
  /// One pair on its way from state i - 1 to state i.
  void follow(std::size_t p, std::size_t i, double moved_mm, double& free_mm, PieceReport& report) const {
    const double part_mm = pairs_.pairs[p].cutter_and_part ? step_mm_ : least_free_mm();
    const int parts = std::max(1, static_cast<int>(std::ceil(moved_mm / part_mm)));
    for (int k = 1; k <= parts; ++k) {
      free_mm -= moved_mm / parts;
      if (free_mm <= 0.0) free_mm = look(p, moment(i - 1, i, static_cast<double>(k) / parts), report);
    }
  }

  [[nodiscard]] Moment moment(std::size_t from, std::size_t to, double share) const {
    const MachineState &a = states_[from], &b = states_[to];
    return {a.q + share * (b.q - a.q), b.line, a.time_s + share * (b.time_s - a.time_s), to};
  }

  [[nodiscard]] Stand stand(const AxisVector& q) const {
    Stand out;
    out.X_M.reserve(pairs_.bodies.size());
    for (const auto& body : pairs_.bodies) out.X_M.push_back(body.X_M(q));
    return out;
  }

  /// How far the two bodies of each pair can have come closer on the way.
  [[nodiscard]] std::vector<double> motion(const Stand& a, const Stand& b) const {
    std::vector<double> body_mm;
    for (std::size_t i = 0; i < pairs_.bodies.size(); ++i) {
      const CollisionBody& body = *pairs_.bodies[i].body;
      const Vec3 shift = b.X_M[i] * body.centre_mm() - a.X_M[i] * body.centre_mm();
      // Two rotations that differ by the angle t are 2 sqrt(2) sin(t / 2) apart in the Frobenius norm.
      const double apart = (b.X_M[i].linear() - a.X_M[i].linear()).norm();
      const double turn = 2.0 * std::asin(std::min(1.0, apart / (2.0 * std::numbers::sqrt2)));
      body_mm.push_back(shift.norm() + body.radius_mm() * turn);
    }
    std::vector<double> out;
    for (const auto& pair : pairs_.pairs) out.push_back(body_mm[pair.a] + body_mm[pair.b]);
    return out;
  }

  [[nodiscard]] double distance(const BodyPair& pair, const AxisVector& q, double bound_mm, PieceReport& report,
                                double any_below_mm = 0.0) const {
    const MovingBody &a = pairs_.bodies[pair.a], &b = pairs_.bodies[pair.b];
    return body_distance_mm(*a.body, *b.body, b.X_M(q).inverse() * a.X_M(q), bound_mm, report.pairs, exact_below_mm(),
                            any_below_mm);
  }

  /// Looks at one pair and says how far it may move before the next look.
  double look(std::size_t p, const Moment& at, PieceReport& report) const {
    const BodyPair& pair = pairs_.pairs[p];
    const double far = look_beyond_steps * step_mm_;
    if (pair.cutter_and_part) {
      // Most of the time they touch: a short look first, a long one only where there is air.
      double found = distance(pair, at.q, least_free_mm(), report, least_free_mm());
      if (found >= least_free_mm()) found = distance(pair, at.q, far, report);
      if (found <= 0.0) report.contacts.push_back({p, found, at});
      return std::max(least_free_mm(), (1.0 - far_distance_error) * found);
    }
    const double bound = std::isfinite(report.closest_mm) ? std::max(clearance_mm_, report.closest_mm) + far : infinite;
    const double found = distance(pair, at.q, bound, report);
    if (found < report.closest_mm) {
      report.closest_mm = found;
      report.closest_pair = p;
      report.at_line = at.line;
    }
    if (found <= 0.0 || found < clearance_mm_) report.contacts.push_back({p, found, at});
    // Nothing to see before the pair can be within the clearance, or clearly nearer than anything seen.
    const double seen =
        std::max(clearance_mm_, report.closest_mm - std::max(step_mm_, closest_share * report.closest_mm));
    const double surely =
        found <= exact_below_mm() ? found : std::max(exact_below_mm(), (1.0 - far_distance_error) * found);
    return std::max(least_free_mm(), surely - seen);
  }

  [[nodiscard]] double least_free_mm() const { return 0.5 * step_mm_; }
  [[nodiscard]] double exact_below_mm() const { return std::max(1.0, 2.0 * clearance_mm_); }

  static constexpr double look_beyond_steps = 8.0;
  static constexpr double closest_share = 0.25;
  const CollisionPairs& pairs_;
  const std::vector<MachineState>& states_;
  double clearance_mm_, step_mm_;
};

/// One finding for each stretch of a pair: contacts of the same pair in neighbouring states are one.
class FindingList {
 public:
  FindingList(const CollisionPairs& pairs, double clearance_mm, CollisionReport& report)
      : pairs_(pairs), clearance_mm_(clearance_mm), report_(report), open_(pairs.pairs.size()) {}

  void add(const Contact& contact) {
    const bool hit = contact.distance_mm <= 0.0;
    auto& stretch = open_[contact.pair];
    if (!stretch || contact.at.index > stretch->last_index + 1 || (hit && !stretch->hit)) stretch = begin(contact, hit);
    stretch->last_index = contact.at.index;
    if (!stretch->finding) return;
    if (hit)
      meetings_[*stretch->finding].push_back(contact);
    else if (!stretch->hit)
      report_.findings[*stretch->finding].value =
          std::min(report_.findings[*stretch->finding].value, contact.distance_mm);
  }

  /// The contacts of each finding; empty for those that only come close.
  [[nodiscard]] const std::vector<std::vector<Contact>>& meetings() const { return meetings_; }

 private:
  struct Stretch {
    std::size_t last_index;
    bool hit;
    std::optional<std::size_t> finding;
  };

  Stretch begin(const Contact& contact, bool hit) {
    constexpr std::size_t findings_max = 200;
    report_.sim_hits += hit ? 1 : 0;
    if (report_.findings.size() >= findings_max) return {contact.at.index, hit, std::nullopt};
    Finding finding{hit ? "collision" : "clearance",
                    contact.at.line,
                    contact.at.time_s,
                    pairs_.pair_name(contact.pair),
                    contact.distance_mm,
                    hit ? 0.0 : clearance_mm_,
                    ""};
    finding.axes = contact.at.q;
    report_.findings.push_back(std::move(finding));
    meetings_.emplace_back();
    return {contact.at.index, hit, report_.findings.size() - 1};
  }

  const CollisionPairs& pairs_;
  double clearance_mm_;
  CollisionReport& report_;
  std::vector<std::optional<Stretch>> open_;
  std::vector<std::vector<Contact>> meetings_;
};

/// The greatest depth over a stretch, from at most so many of its moments, evenly spread, the last one included.
double depth_of(const CollisionPairs& pairs, const std::vector<Contact>& contacts) {
  constexpr std::size_t moments_max = 32;
  const std::size_t step = (contacts.size() + moments_max - 1) / moments_max;
  double depth = 0.0;
  for (std::size_t i = (contacts.size() - 1) % step; i < contacts.size(); i += step) {
    const BodyPair& pair = pairs.pairs[contacts[i].pair];
    const MovingBody &a = pairs.bodies[pair.a], &b = pairs.bodies[pair.b];
    const AxisVector& q = contacts[i].at.q;
    const double found = body_depth_mm(*a.body, *b.body, b.X_M(q).inverse() * a.X_M(q));
    if (found > 0.0) depth = std::max(depth, found + pair.forgiven_mm);
  }
  return depth;
}

std::string pose_text(const Finding& finding, const kinematics::Machine& machine) {
  std::string text;
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const bool rotary = machine.axes[i].kind == kinematics::AxisKind::rotary;
    const double value = (*finding.axes)[static_cast<Eigen::Index>(i)];
    text += (i > 0 ? " " : "") + std::string(1, machine.axes[i].letter) +
            geometry::fixed_text(rotary ? geometry::Angle::radians(value).degrees() : value, 3);
  }
  return text;
}

void tell(Finding& finding, const kinematics::Machine& machine) {
  const std::string where = "line " + std::to_string(finding.line) + ": ";
  if (finding.kind == "collision") {
    finding.text = where + finding.axis_or_pair + " meet from " + short_text(finding.time_s, 6) + " s on, up to " +
                   short_text(finding.value, 3) + " mm deep, with the axes at " + pose_text(finding, machine);
  } else {
    finding.text = where + finding.axis_or_pair + " come as close as " + short_text(finding.value, 4) + " mm; " +
                   short_text(finding.limit, 4) + " mm is asked for";
  }
}

}  // namespace

CollisionReport check_collisions(const CollisionScene& scene, const kinematics::Machine& machine,
                                 const kinematics::Setup& setup, const std::vector<MachineState>& states,
                                 double step_mm) {
  VOLUTE_CHECK(step_mm > 0.0, step_mm);
  CollisionReport report;
  if (states.empty()) return report;
  const CollisionPairs pairs = collision_pairs(scene, machine, setup);
  if (pairs.pairs.empty()) return report;
  // Pieces of a fixed size, so that the result is the same however many threads share them.
  constexpr std::size_t piece_states = 512;
  const std::size_t moves = std::max<std::size_t>(1, states.size() - 1),
                    count = (moves + piece_states - 1) / piece_states;
  std::vector<PieceReport> pieces(count);
  const RunCheck run(pairs, states, scene.clearance_mm, step_mm);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    pieces[i] = run.check(i * piece_states, std::min((i + 1) * piece_states, states.size() - 1));
  });
  double closest = infinite;
  for (const auto& piece : pieces) {
    report.pairs_checked += piece.pairs;
    if (piece.closest_mm >= closest) continue;
    closest = report.closest_mm = piece.closest_mm;
    report.closest_pair = pairs.pair_name(piece.closest_pair);
    report.at_line = piece.at_line;
  }
  FindingList findings(pairs, scene.clearance_mm, report);
  for (const auto& piece : pieces) {
    for (const Contact& contact : piece.contacts) findings.add(contact);
  }
  tbb::parallel_for(std::size_t{0}, report.findings.size(), [&](std::size_t i) {
    Finding& finding = report.findings[i];
    finding.pose_P = kinematics::tool_pose(machine, setup, scene.tool.gauge_length_mm, *finding.axes);
    if (!findings.meetings()[i].empty()) finding.value = depth_of(pairs, findings.meetings()[i]);
    tell(finding, machine);
  });
  return report;
}

}  // namespace volute::sim

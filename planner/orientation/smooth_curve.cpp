#include "planner/orientation/smooth_curve.hpp"

#include <cmath>

#include "geometry/check.hpp"

// Notation. L[i] = s[i+1] - s[i]. d[i] = (Phi[i+1] - Phi[i]) / L[i] - (Phi[i] - Phi[i-1]) / L[i-1], the jump of the
// slope at i. Eq. 33 is sum d^2 / c with c[i] = Q^2 / 4 (printed) or Q / 2 (arc length), Q = L[i] + L[i-1]. With mu[i]
// = d[i] / c[i], the derivative with respect to a free Phi[i] vanishes when mu is linear in s there: mu has its kinks
// at the pins. Hence d[i] = c[i] mu[i] with mu given by its values m[k] at the pins, and mu = 0 at and beyond the outer
// pins.
namespace volute::planner {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void check_pins(std::span<const double> s_mm, std::span<const Pin> pins) {
  VOLUTE_CHECK(!pins.empty() && pins.front().index >= 0 && at(pins.back().index) < s_mm.size(), pins.size(),
               s_mm.size());
  for (std::size_t k = 0; k + 1 < pins.size(); ++k) VOLUTE_CHECK(pins[k].index < pins[k + 1].index, pins[k].index);
}

double inverse_weight(std::span<const double> s_mm, int i, Weights weights) {
  const double q = s_mm[at(i + 1)] - s_mm[at(i - 1)];
  return weights == Weights::arc_length ? 0.5 * q : 0.25 * q * q;
}

/// What the jumps between two pins do to the slopes at the pins, for mu rising from 0 to 1 (`up`) and falling from 1 to
/// 0 (`down`).
struct Span {
  double length = 0.0;
  // The chord's slope minus the slope at the left pin, and the slope at the right pin minus the chord's, per unit of m
  // left and right.
  double left_by_left = 0.0, left_by_right = 0.0, right_by_left = 0.0, right_by_right = 0.0;
};

Span measure_span(std::span<const double> s_mm, int from, int to, Weights weights) {
  Span span;
  const double s0 = s_mm[at(from)], length = s_mm[at(to)] - s0;
  span.length = length;
  for (int i = from + 1; i < to; ++i) {
    const double t = (s_mm[at(i)] - s0) / length, c = inverse_weight(s_mm, i, weights);
    // A slope jump d at t bends the curve: the left slope falls short of the chord by d (1 - t), the right exceeds it
    // by d t.
    span.left_by_left += c * (1.0 - t) * (1.0 - t);
    span.left_by_right += c * t * (1.0 - t);
    span.right_by_right += c * t * t;
  }
  span.right_by_left = span.left_by_right;
  return span;
}

/// Solves the tridiagonal system in place (no pivoting: it is diagonally dominant). lower[k] couples k and k - 1.
std::vector<double> solve_tridiagonal(std::vector<double> diagonal, const std::vector<double>& off,
                                      std::vector<double> right) {
  const std::size_t n = diagonal.size();
  for (std::size_t k = 1; k < n; ++k) {
    const double f = off[k] / diagonal[k - 1];
    diagonal[k] -= f * off[k];
    right[k] -= f * right[k - 1];
  }
  for (std::size_t k = n; k-- > 0;) {
    if (k + 1 < n) right[k] -= off[k + 1] * right[k + 1];
    right[k] /= diagonal[k];
  }
  return right;
}

/// mu at the pins: 0 at the outer ones, and at each inner pin the slopes of both sides differ by c m.
std::vector<double> pin_multipliers(std::span<const double> s_mm, std::span<const Pin> pins,
                                    const std::vector<Span>& spans, Weights weights) {
  const std::size_t inner = pins.size() < 3 ? 0 : pins.size() - 2;
  std::vector<double> diagonal(inner), off(inner), right(inner), m(pins.size(), 0.0);
  for (std::size_t k = 0; k < inner; ++k) {
    const Span& a = spans[k];
    const Span& b = spans[k + 1];
    diagonal[k] = inverse_weight(s_mm, pins[k + 1].index, weights) + a.right_by_right + b.left_by_left;
    off[k] = a.right_by_left;
    right[k] = (pins[k + 2].value - pins[k + 1].value) / b.length - (pins[k + 1].value - pins[k].value) / a.length;
  }
  const std::vector<double> solved = solve_tridiagonal(std::move(diagonal), off, std::move(right));
  for (std::size_t k = 0; k < inner; ++k) m[k + 1] = solved[k];
  return m;
}

/// Fills between two pins by summing slopes; the rounding that gathers on the way is taken out linearly.
void fill_span(std::span<const double> s_mm, const Pin& a, const Pin& b, double slope, double m_a, double m_b,
               Weights weights, std::vector<double>& phi) {
  const double s0 = s_mm[at(a.index)], length = s_mm[at(b.index)] - s0;
  double value = a.value;
  phi[at(a.index)] = a.value;
  for (int i = a.index; i < b.index; ++i) {
    if (i > a.index) {
      const double t = (s_mm[at(i)] - s0) / length;
      slope += inverse_weight(s_mm, i, weights) * (m_a + t * (m_b - m_a));
    }
    value += slope * (s_mm[at(i + 1)] - s_mm[at(i)]);
    phi[at(i + 1)] = value;
  }
  const double gathered = value - b.value;
  for (int i = a.index + 1; i <= b.index; ++i) phi[at(i)] -= gathered * (s_mm[at(i)] - s0) / length;
  phi[at(b.index)] = b.value;
}

void extend_straight(std::span<const double> s_mm, std::span<const Pin> pins, double first_slope, double last_slope,
                     std::vector<double>& phi) {
  const Pin& first = pins.front();
  const Pin& last = pins.back();
  for (int i = 0; i < first.index; ++i) phi[at(i)] = first.value + first_slope * (s_mm[at(i)] - s_mm[at(first.index)]);
  for (int i = last.index + 1; at(i) < s_mm.size(); ++i)
    phi[at(i)] = last.value + last_slope * (s_mm[at(i)] - s_mm[at(last.index)]);
}

}  // namespace

std::vector<double> least_velocity(std::span<const double> s_mm, std::span<const Pin> pins, Weights weights) {
  check_pins(s_mm, pins);
  std::vector<double> phi(s_mm.size());
  extend_straight(s_mm, pins, 0.0, 0.0, phi);
  phi[at(pins.front().index)] = pins.front().value;
  const auto share = [&](int i) {
    const double step = s_mm[at(i + 1)] - s_mm[at(i)];
    return weights == Weights::arc_length ? step : step * step;
  };
  for (std::size_t k = 0; k + 1 < pins.size(); ++k) {
    double whole = 0.0, part = 0.0;
    for (int i = pins[k].index; i < pins[k + 1].index; ++i) whole += share(i);
    for (int i = pins[k].index; i < pins[k + 1].index; ++i) {
      part += share(i);
      phi[at(i + 1)] = pins[k].value + (pins[k + 1].value - pins[k].value) * (part / whole);
    }
    phi[at(pins[k + 1].index)] = pins[k + 1].value;
  }
  return phi;
}

std::vector<double> least_acceleration(std::span<const double> s_mm, std::span<const Pin> pins, Weights weights) {
  check_pins(s_mm, pins);
  std::vector<double> phi(s_mm.size(), pins.front().value);
  if (pins.size() == 1) return phi;
  std::vector<Span> spans;
  for (std::size_t k = 0; k + 1 < pins.size(); ++k)
    spans.push_back(measure_span(s_mm, pins[k].index, pins[k + 1].index, weights));
  const std::vector<double> m = pin_multipliers(s_mm, pins, spans, weights);
  double first_slope = 0.0, last_slope = 0.0;
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const double chord = (pins[k + 1].value - pins[k].value) / spans[k].length;
    const double left = chord - spans[k].left_by_left * m[k] - spans[k].left_by_right * m[k + 1];
    if (k == 0) first_slope = left;
    last_slope = chord + spans[k].right_by_left * m[k] + spans[k].right_by_right * m[k + 1];
    fill_span(s_mm, pins[k], pins[k + 1], left, m[k], m[k + 1], weights, phi);
  }
  extend_straight(s_mm, pins, first_slope, last_slope, phi);
  return phi;
}

}  // namespace volute::planner

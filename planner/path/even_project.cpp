#include "planner/path/even_project.hpp"

namespace volute::planner {

/// Free: the length of z shrinks. On the constraint q = g d + b e, b solves b / sqrt(g^2 + b^2) + (mu / g)(b) + weight
/// (b - z . e) = 0 by Newton; the left side grows with b and is convex on each side of 0, four steps reach 1e-6 and
/// more is not needed.
[[gnu::flatten]] LaneVectors nearest_allowed(const LaneVectors& z, const Allowed& allowed) {
  const auto& [d, needed, mu, weight] = allowed;
  const Lanes total = mu / needed + weight;
  const Lanes share = weight / total;
  const LaneVectors pulled{z.x * share, z.y * share};
  const Lanes length = (pulled.x * pulled.x + pulled.y * pulled.y).sqrt().max(1e-12);
  const Lanes kept = (1.0 - 1.0 / (total * length)).max(0.0);
  LaneVectors q{pulled.x * kept, pulled.y * kept};
  const auto free = (q.x * d.x + q.y * d.y >= needed).eval();
  if (free.all()) return q;
  const Lanes aim = pulled.y * d.x - pulled.x * d.y, needed_sq = needed * needed;
  Lanes b = aim;
  for (int step = 0; step < 4; ++step) {
    const Lanes norm = (needed_sq + b * b).sqrt();
    b -= (b / norm + total * (b - aim)) / (needed_sq / (norm * norm * norm) + total);
  }
  q.x = free.select(q.x, needed * d.x - b * d.y);
  q.y = free.select(q.y, needed * d.y + b * d.x);
  return q;
}

}  // namespace volute::planner

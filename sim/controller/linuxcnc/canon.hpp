// Motion blocks as the moves that LinuxCNC's interpreter hands to its planner: speeds, accelerations, joined lines.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/controller/linuxcnc/corner.hpp"
#include "sim/interpreter/program.hpp"

namespace volute::sim::linuxcnc {

/// One move with its limits; everything else of the segment is the planner's.
struct Move {
  Shape shape = Shape::line;
  Position end;
  Vec3 centre = Vec3::Zero(), normal = Vec3::UnitZ();
  int turns = 0;  ///< as Arc::through counts them
  double speed = 0.0, speed_max = 0.0, acceleration = 0.0;
  EndMode end_mode = EndMode::parabolic;
  double tolerance = 0.0;
  bool rapid = false;
  bool waits_for_spindle = false;
  BlockInfo* block = nullptr;
};

/// Limits of X Y Z (mm) and the rotaries (deg).
struct AxisBounds {
  std::array<double, 5> velocity{}, acceleration{};
};

/// Speed: F counts along X Y Z where these move, else along the rotaries; the slowest axis caps it. Lines of X Y Z
/// alone that lie within the naive-CAM tolerance of one straight line become one move.
class Canon {
 public:
  Canon(const AxisBounds& bounds, const Position& start) : bounds_(bounds), at_(start) {}
  using Sink = std::function<void(const Move&)>;

  /// `end` and `centre` in the planner's coordinates. Requires: kind rapid, line or arc.
  void add(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info, const Sink& sink);
  /// Sends what is still held back.
  void flush(const Sink& sink);
  void stand_at(const Position& position) { at_ = position; }
  [[nodiscard]] const Position& seen() const { return chain_.empty() ? at_ : chain_.back().end; }

 private:
  struct Reach {
    double distance = 0.0, time_s = 0.0;
  };
  struct Chained {
    Position end;
    BlockInfo* block = nullptr;
  };
  [[nodiscard]] Reach slowest(const Position& end, const std::array<double, 5>& most) const;
  void set_modes(const MotionBlock& block, const Sink& sink);
  void set_feed(const MotionBlock& block, const Position& end, const Sink& sink);
  void see_line(const Position& end, BlockInfo* info, const Sink& sink);
  [[nodiscard]] bool joins(const Position& end) const;
  void add_arc(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info, const Sink& sink);
  void send_arc(const MotionBlock& block, const Position& end, const Vec3& centre, BlockInfo* info, const Sink& sink);
  void send(Move move, const Sink& sink);

  AxisBounds bounds_;
  Position at_;
  std::vector<Chained> chain_;
  EndMode mode_ = EndMode::parabolic;
  double tolerance_ = 0.0, naive_tolerance_ = 0.0;
  double linear_feed_ = 0.0, rotary_feed_ = 0.0;
  double spindle_ = 0.0;
  bool spindle_changed_ = false;
};

}  // namespace volute::sim::linuxcnc

// Traces as files: CSV for people, a compact binary for programs.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/result.hpp"
#include "sim/trace.hpp"

namespace volute::sim {

/// How a trace is written. CSV: a header line, then time_s, the axes' positions (mm, deg) named by their letters,
/// velocities (v_X ...), accelerations (a_X ...), jerks (j_X ...), positions behind the servo (actual_X ...),
/// tip_speed_mm_s, line, limit, limiting_axis, rapid, cutting.
///
/// Binary, all little-endian: 64 bytes of header, then records of 96 bytes.
///   header: 0 "VOLTRACE" | 8 u32 version 1 | 12 u32 record bytes 96 | 16 f64 period s | 24 u64 records | 32 5 letters
///   | 37 u8[5] 1 if rotary | zeros record: 0 f64[5] commanded position mm, rad | 40 f32[5] velocity | 60 f32[5]
///   command - actual | 80 i64 line | 88 f32 tip speed mm/s
///           | 92 u8 limit | 93 i8 limiting axis | 94 u8 bit 0 rapid, bit 1 cutting | 95 0. Record k is at time k *
///           period.
enum class TraceFormat { csv, binary };

/// Writes beside `file` and renames into place at close: nobody sees half a trace. The destructor without close()
/// removes what was written.
class TraceWriter {
 public:
  /// Errors (system): file-not-written.
  static geometry::Result<TraceWriter> open(const std::filesystem::path& file, TraceFormat format,
                                            const kinematics::Machine& machine, double period_s);
  TraceWriter(TraceWriter&&) noexcept;
  TraceWriter& operator=(TraceWriter&&) noexcept;
  ~TraceWriter();

  /// Keeps every `stride`-th sample in CSV; binary traces keep all. Requires: stride >= 1, before the first write.
  void set_stride(int stride);
  void write(std::span<const AxisSample> samples);
  /// Errors (system): file-not-written, also for what failed before.
  geometry::Result<void> close();

 private:
  struct State;
  explicit TraceWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

struct Trace {
  double period_s = 0.0;
  std::array<char, kinematics::axis_count> letters{};
  std::vector<AxisSample> samples;  ///< acceleration and jerk are zero: the file does not hold them
};
/// Reads a binary trace. Errors: file-missing, trace-format (bad_input).
geometry::Result<Trace> read_trace(const std::filesystem::path& file);

}  // namespace volute::sim

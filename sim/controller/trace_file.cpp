#include "sim/controller/trace_file.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

#include "geometry/check.hpp"
#include "geometry/file.hpp"
#include "geometry/number_text.hpp"

namespace volute::sim {

namespace {

using geometry::bad_input;
using geometry::Result;
using geometry::system_error;

using kinematics::axis_count;
constexpr std::size_t header_bytes = 64, record_bytes = 96;
constexpr std::size_t count_at = 24;
static_assert(std::endian::native == std::endian::little, "traces are written in the machine's own order");

template <class T>
void put(char* at, T value) {
  std::memcpy(at, &value, sizeof value);
}
template <class T>
T take(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

constexpr std::array<const char*, 10> limit_names = {
    "programmed_feed", "axis_velocity", "axis_acceleration", "axis_jerk", "corner", "block_time", "look_ahead", "rapid",
    "dwell",           "stop"};

std::string csv_header(const kinematics::Machine& machine) {
  std::string text = "time_s";
  for (const char* prefix : {"", "v_", "a_", "j_", "actual_"})
    for (const kinematics::Axis& axis : machine.axes) text += std::string(",") + prefix + axis.letter;
  return text + ",tip_speed_mm_s,line,limit,limiting_axis,rapid,cutting\n";
}

}  // namespace

struct TraceWriter::State {
  std::filesystem::path file, beside;
  std::ofstream out;
  TraceFormat format = TraceFormat::csv;
  const kinematics::Machine* machine = nullptr;
  std::array<char, axis_count> letters{};
  std::array<double, axis_count> unit{};  ///< factor from mm, rad to mm, deg
  std::uint64_t seen = 0;
  int stride = 1;
  std::string buffer;

  void csv(const AxisSample& sample);
  void binary(const AxisSample& sample);
};

TraceWriter::TraceWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
TraceWriter::TraceWriter(TraceWriter&&) noexcept = default;
TraceWriter& TraceWriter::operator=(TraceWriter&&) noexcept = default;

TraceWriter::~TraceWriter() {
  if (!state_) return;
  state_->out.close();
  std::error_code ignored;
  std::filesystem::remove(state_->beside, ignored);
}

Result<TraceWriter> TraceWriter::open(const std::filesystem::path& file, TraceFormat format,
                                      const kinematics::Machine& machine, double period_s) {
  auto state = std::make_unique<State>();
  state->file = file;
  state->beside = file.string() + ".part";
  state->format = format;
  state->out.open(state->beside, std::ios::binary | std::ios::trunc);
  if (!state->out)
    return system_error("file-not-written",
                        file.string() + ": cannot be written; check the folder and its permissions");
  char header[header_bytes] = "VOLTRACE";
  put(header + 8, std::uint32_t{1});
  put(header + 12, static_cast<std::uint32_t>(record_bytes));
  put(header + 16, period_s);
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const bool rotary = machine.axes[i].kind == kinematics::AxisKind::rotary;
    state->letters[i] = machine.axes[i].letter;
    state->unit[i] = rotary ? 180.0 / std::numbers::pi : 1.0;
    header[32 + i] = machine.axes[i].letter;
    header[37 + i] = rotary ? 1 : 0;
  }
  state->buffer = format == TraceFormat::csv ? csv_header(machine) : std::string(header, header_bytes);
  return TraceWriter(std::move(state));
}

void TraceWriter::set_stride(int stride) {
  VOLUTE_CHECK(stride >= 1 && state_->seen == 0, stride);
  state_->stride = stride;
}

void TraceWriter::State::csv(const AxisSample& sample) {
  geometry::append_fixed(buffer, sample.time_s, 6);
  for (const AxisVector* v : {&sample.position, &sample.velocity, &sample.acceleration, &sample.jerk, &sample.actual})
    for (int i = 0; i < axis_count; ++i) {
      buffer += ',';
      geometry::append_fixed(buffer, (*v)[i] * unit[static_cast<std::size_t>(i)], 6);
    }
  buffer += ',';
  geometry::append_fixed(buffer, sample.tip_speed_mm_s, 4);
  buffer += ',' + std::to_string(sample.line) + ',' + limit_names[static_cast<std::size_t>(sample.limit)] + ',';
  if (sample.limiting_axis >= 0) buffer += letters[static_cast<std::size_t>(sample.limiting_axis)];
  buffer += sample.rapid ? ",1" : ",0";
  buffer += sample.cutting ? ",1\n" : ",0\n";
}

void TraceWriter::State::binary(const AxisSample& sample) {
  char record[record_bytes] = {};
  for (int i = 0; i < axis_count; ++i) {
    put(record + 8 * i, sample.position[i]);
    put(record + 40 + 4 * i, static_cast<float>(sample.velocity[i]));
    put(record + 60 + 4 * i, static_cast<float>(sample.position[i] - sample.actual[i]));
  }
  put(record + 80, sample.line);
  put(record + 88, static_cast<float>(sample.tip_speed_mm_s));
  put(record + 92, static_cast<std::uint8_t>(sample.limit));
  put(record + 93, sample.limiting_axis);
  put(record + 94, static_cast<std::uint8_t>((sample.rapid ? 1 : 0) | (sample.cutting ? 2 : 0)));
  buffer.append(record, record_bytes);
}

void TraceWriter::write(std::span<const AxisSample> samples) {
  for (const AxisSample& sample : samples) {
    const bool kept = state_->seen++ % static_cast<std::uint64_t>(state_->stride) == 0;
    if (state_->format == TraceFormat::binary)
      state_->binary(sample);
    else if (kept)
      state_->csv(sample);
  }
  if (state_->buffer.size() < (std::size_t{1} << 20)) return;
  state_->out.write(state_->buffer.data(), static_cast<std::streamsize>(state_->buffer.size()));
  state_->buffer.clear();
}

Result<void> TraceWriter::close() {
  const std::unique_ptr<State> state = std::move(state_);
  state->out.write(state->buffer.data(), static_cast<std::streamsize>(state->buffer.size()));
  if (state->format == TraceFormat::binary) {
    char count[8];
    put(count, state->seen);
    state->out.seekp(count_at);
    state->out.write(count, sizeof count);
  }
  state->out.close();
  std::error_code failed;
  if (state->out) std::filesystem::rename(state->beside, state->file, failed);
  if (state->out && !failed) return {};
  std::error_code ignored;
  std::filesystem::remove(state->beside, ignored);
  return system_error("file-not-written", state->file.string() + ": the trace could not be written; is the disk full?");
}

Result<Trace> read_trace(const std::filesystem::path& file) {
  const auto bytes = geometry::read_file(file);
  if (!bytes) return tl::unexpected(bytes.error());
  const char* at = bytes->data();
  const auto refuse = [&](const std::string& what) {
    return bad_input("trace-format", file.string() + ": " + what + "; write the trace again");
  };
  if (bytes->size() < header_bytes || std::memcmp(at, "VOLTRACE", 8) != 0) return refuse("not a trace file");
  if (take<std::uint32_t>(at + 8) != 1 || take<std::uint32_t>(at + 12) != record_bytes)
    return refuse("a version of trace that is not known");
  const auto count = take<std::uint64_t>(at + count_at);
  if ((bytes->size() - header_bytes) / record_bytes != count || (bytes->size() - header_bytes) % record_bytes != 0)
    return refuse("its length does not fit the " + std::to_string(count) + " records it announces");
  Trace trace;
  trace.period_s = take<double>(at + 16);
  std::memcpy(trace.letters.data(), at + 32, axis_count);
  trace.samples.resize(count);
  at += header_bytes;
  for (std::uint64_t k = 0; k < count; ++k, at += record_bytes) {
    AxisSample& sample = trace.samples[k];
    sample.time_s = static_cast<double>(k) * trace.period_s;
    sample.acceleration.setZero();
    sample.jerk.setZero();
    for (int i = 0; i < axis_count; ++i) {
      sample.position[i] = take<double>(at + 8 * i);
      sample.velocity[i] = static_cast<double>(take<float>(at + 40 + 4 * i));
      sample.actual[i] = sample.position[i] - static_cast<double>(take<float>(at + 60 + 4 * i));
    }
    sample.line = take<std::int64_t>(at + 80);
    sample.tip_speed_mm_s = static_cast<double>(take<float>(at + 88));
    sample.limit = static_cast<Limit>(take<std::uint8_t>(at + 92));
    sample.limiting_axis = take<std::int8_t>(at + 93);
    sample.rapid = (at[94] & 1) != 0;
    sample.cutting = (at[94] & 2) != 0;
  }
  return trace;
}

}  // namespace volute::sim

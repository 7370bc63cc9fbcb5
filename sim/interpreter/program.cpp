#include "sim/interpreter/program.hpp"

#include "sim/interpreter/dialect.hpp"

namespace volute::sim {

namespace {

std::unique_ptr<Dialect> make_dialect(Reading& reading) {
  switch (reading.control.family) {
    case kinematics::DialectFamily::siemens:
      return make_siemens_dialect(reading);
    case kinematics::DialectFamily::heidenhain:
      return make_heidenhain_dialect(reading);
    default:
      return make_word_dialect(reading);
  }
}

}  // namespace

struct ProgramReader::State {
  State(std::string_view text, std::string file_name, const kinematics::Machine& machine,
        const kinematics::Control& control_, const ReaderOptions& options)
      : control(control_),
        reading(text, std::move(file_name), machine, control, options),
        dialect(make_dialect(reading)) {}

  const kinematics::Control control;  ///< a copy: the caller's need not live as long as the reader
  Reading reading;
  std::unique_ptr<Dialect> dialect;
  std::size_t handed_out = 0;
};

ProgramReader::ProgramReader(std::string_view text, std::string file_name, const kinematics::Machine& machine,
                             const kinematics::Control& control, const ReaderOptions& options)
    : state_(std::make_unique<State>(text, std::move(file_name), machine, control, options)) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;

Result<std::optional<MotionBlock>> ProgramReader::next() {
  Reading& reading = state_->reading;
  while (state_->handed_out == reading.queue.size()) {
    reading.queue.clear();
    state_->handed_out = 0;
    if (!reading.diagnosis.ok()) return tl::unexpected(reading.diagnosis.error());
    if (reading.finished) return std::optional<MotionBlock>();
    // Motions that a faulty block gave before its fault are not handed out.
    if (!state_->dialect->advance()) reading.queue.clear();
  }
  return std::optional<MotionBlock>(reading.queue[state_->handed_out++]);
}

const std::vector<std::string>& ProgramReader::warnings() const { return state_->reading.diagnosis.warnings(); }
std::int64_t ProgramReader::lines_read() const { return state_->reading.source.after().line - 1; }

}  // namespace volute::sim

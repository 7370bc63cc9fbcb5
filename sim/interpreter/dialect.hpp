// What every dialect's reader is given, and what it gives back.
#pragma once

#include <memory>
#include <vector>

#include "kinematics/model/control.hpp"
#include "sim/interpreter/motion_state.hpp"
#include "sim/interpreter/program.hpp"
#include "sim/interpreter/source.hpp"

namespace volute::sim {

/// The program being read: text, faults, modal state.
struct Reading {
  Reading(std::string_view text, std::string file_name, const kinematics::Machine& machine_,
          const kinematics::Control& control_, const ReaderOptions& options_)
      : source(text, std::move(file_name)),
        diagnosis(source),
        state(machine_, control_, diagnosis),
        control(control_),
        options(options_) {
    state.work_zero_machine_mm = options.work_zero_machine_mm;
    if (options.start) state.begin_at(*options.start);
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  Source source;
  Diagnosis diagnosis;
  MotionState state;
  const kinematics::Control& control;
  ReaderOptions options;
  std::vector<MotionBlock> queue;  ///< motions of the block read last, in order
  bool finished = false;           ///< the program has ended
};

class Dialect {
 public:
  virtual ~Dialect() = default;
  /// Reads one block; its motions are appended to the queue. False: a fault, in the diagnosis.
  virtual bool advance() = 0;
};

/// LinuxCNC, Fanuc, Haas, Mazak.
std::unique_ptr<Dialect> make_word_dialect(Reading& reading);
std::unique_ptr<Dialect> make_siemens_dialect(Reading& reading);
std::unique_ptr<Dialect> make_heidenhain_dialect(Reading& reading);

}  // namespace volute::sim

#include "sim/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "geometry/number_text.hpp"
#include "kinematics/model/control.hpp"
#include "sim/controller/control_run.hpp"

namespace volute::sim {
namespace {

using geometry::Transform;
using geometry::Vec3;
using kinematics::AxisKind;
using kinematics::Machine;

constexpr double g = 9.80665;

/// A gantry with a C fork and an A head in round numbers, without friction.
Machine plain_head() {
  Machine m;
  m.name = "plain";
  m.kind = "head-head";
  m.table_axes = 0;
  m.chain = {0, 1, 2, 4, 3};  // X Y Z C A
  const char letters[] = {'X', 'Y', 'Z', 'A', 'C'};
  const double masses[] = {800, 500, 300, 60, 90};
  for (std::size_t i = 0; i < 5; ++i) {
    m.axes[i].letter = letters[i];
    m.axes[i].kind = i < 3 ? AxisKind::linear : AxisKind::rotary;
    m.axes[i].moved_mass_kg = masses[i];
    m.axes[i].direction_M =
        i < 3 ? Vec3(Vec3::Unit(static_cast<Eigen::Index>(i))) : (i == 3 ? Vec3::UnitX() : Vec3::UnitZ());
  }
  m.axes[3].inertia_kg_m2 = Vec3(1.2, 1.1, 0.4).asDiagonal();
  m.axes[4].inertia_kg_m2 = Vec3(3.0, 2.5, 2.0).asDiagonal();
  m.axes[3].centre_of_mass_M_mm = Vec3(0, 0, -200);  // below the pivot at the origin
  m.axes[4].centre_of_mass_M_mm = Vec3(0, 0, 150);
  return m;
}

AxisVector only(int axis, double value) {
  AxisVector v = AxisVector::Zero();
  v[axis] = value;
  return v;
}

TEST(DriveForces, StandingStillOnlyTheWeightIsHeld) {
  const AxisVector load = drive_forces(plain_head(), AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero());
  EXPECT_NEAR(load[0], 0.0, 1e-9);
  EXPECT_NEAR(load[1], 0.0, 1e-9);
  EXPECT_NEAR(load[2], (300 + 60 + 90) * g, 1e-9);
  EXPECT_NEAR(load[3], 0.0, 1e-9);
  EXPECT_NEAR(load[4], 0.0, 1e-9);
}

TEST(DriveForces, EachLinearAxisMovesEverythingBehindIt) {
  const Machine m = plain_head();
  const double moved[] = {1750, 950, 450};
  for (int axis = 0; axis < 3; ++axis) {
    const AxisVector load = drive_forces(m, AxisVector::Zero(), AxisVector::Zero(), only(axis, 3000.0));  // 3 m/s^2
    EXPECT_NEAR(load[axis], moved[axis] * 3.0 + (axis == 2 ? 450 * g : 0.0), 1e-9);
  }
  // Y acceleration swings the head about A: the pivot pulls a mass that hangs 0.2 m below, so A must hold m a l.
  const AxisVector load = drive_forces(m, AxisVector::Zero(), AxisVector::Zero(), only(1, 3000.0));
  EXPECT_NEAR(load[3], 60 * 3.0 * 0.2, 1e-9);
}

TEST(DriveForces, TiltedHeadIsAPendulum) {
  const Machine m = plain_head();
  const double tilt = 0.5;
  const AxisVector still = drive_forces(m, only(3, tilt), AxisVector::Zero(), AxisVector::Zero());
  EXPECT_NEAR(still[3], 60 * g * 0.2 * std::sin(tilt), 1e-9);
  const AxisVector turning = drive_forces(m, only(3, tilt), AxisVector::Zero(), only(3, 2.0));
  EXPECT_NEAR(turning[3] - still[3], (1.2 + 60 * 0.04) * 2.0, 1e-9);
}

TEST(DriveForces, ATurningForkThrowsTheTiltedHeadOutward) {
  const Machine m = plain_head();
  const double tilt = std::numbers::pi / 6, rate = 2.0;
  const AxisVector load = drive_forces(m, only(3, tilt), only(4, rate), AxisVector::Zero());
  // Centrifugal: w^2 sin cos ((Iz - Iy) - m l^2) about A, plus the pendulum's weight.
  const double expected =
      60 * g * 0.2 * std::sin(tilt) + rate * rate * std::sin(tilt) * std::cos(tilt) * ((0.4 - 1.1) - 60 * 0.04);
  EXPECT_NEAR(load[3], expected, 1e-9);
}

TEST(DriveForces, FrictionOpposesMotion) {
  Machine m = plain_head();
  m.axes[0].viscous_friction = 2.0;
  m.axes[0].coulomb_friction = 150.0;
  EXPECT_NEAR(drive_forces(m, AxisVector::Zero(), only(0, 10.0), AxisVector::Zero())[0], 170.0, 1e-9);
  EXPECT_NEAR(drive_forces(m, AxisVector::Zero(), only(0, -10.0), AxisVector::Zero())[0], -170.0, 1e-9);
  EXPECT_NEAR(drive_forces(m, AxisVector::Zero(), AxisVector::Zero(), AxisVector::Zero())[0], 0.0, 1e-9);
}

std::vector<Machine> all_machines() {
  std::vector<Machine> out;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    auto machine = kinematics::load_machine(file);
    EXPECT_TRUE(machine) << machine.error().message;
    if (machine) out.push_back(*machine);
  }
  return out;
}

/// Where a link's mass stands seen from the base, by the chain of the model alone.
Transform link_in_base(const Machine& m, int link, const AxisVector& q) {
  return kinematics::link_motion(m, -1, q).inverse() * kinematics::link_motion(m, link, q);
}

/// Kinetic and potential energy in J: velocities by central differences of the links' places.
double energy(const Machine& m, const AxisVector& q, const AxisVector& velocity) {
  constexpr double h = 1e-5;
  double sum = 0.0;
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const auto& axis = m.axes[static_cast<std::size_t>(i)];
    const Transform here = link_in_base(m, i, q), before = link_in_base(m, i, q - h * velocity),
                    after = link_in_base(m, i, q + h * velocity);
    const Vec3 v = (after * axis.centre_of_mass_M_mm - before * axis.centre_of_mass_M_mm) / (2 * h) / 1000.0;
    const Eigen::AngleAxisd turn(here.linear().transpose() * after.linear() *
                                 (here.linear().transpose() * before.linear()).transpose());
    const Vec3 w = turn.angle() / (2 * h) * turn.axis();  // in the link's axes
    sum += 0.5 * axis.moved_mass_kg * v.squaredNorm() + 0.5 * w.dot(axis.inertia_kg_m2 * w);
    sum += axis.moved_mass_kg * g * (here * axis.centre_of_mass_M_mm).z() / 1000.0;
  }
  return sum;
}

/// A run of sines on every axis.
struct Sines {
  std::array<double, 5> reach, rate, phase;
  explicit Sines(std::mt19937_64& random) {
    std::uniform_real_distribution<> uniform(0.5, 1.5);
    for (std::size_t i = 0; i < 5; ++i) {
      reach[i] = (i < 3 ? 100.0 : 0.8) * uniform(random);
      rate[i] = 2.0 * uniform(random);
      phase[i] = 4.0 * uniform(random);
    }
  }
  [[nodiscard]] AxisVector at(double t, int derivative) const {
    AxisVector out;
    for (int i = 0; i < 5; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double angle = rate[k] * t + phase[k];
      out[i] = reach[k] * (derivative == 0   ? std::sin(angle)
                           : derivative == 1 ? rate[k] * std::cos(angle)
                                             : -rate[k] * rate[k] * std::sin(angle));
    }
    return out;
  }
};

TEST(DriveForces, WorkOfTheDrivesIsTheChangeOfEnergyOnEveryMachine) {
  std::mt19937_64 random(41);
  for (const Machine& m : all_machines()) {
    const Sines run(random);
    constexpr double dt = 0.001;
    const double start = energy(m, run.at(0, 0), run.at(0, 1));
    double work = 0.0, largest = 0.0, worst = 0.0;
    const auto power = [&](double t) {
      const AxisVector v = run.at(t, 1);
      AxisVector force = drive_forces(m, run.at(t, 0), v, run.at(t, 2));
      double sum = 0.0;
      for (int i = 0; i < 5; ++i) {
        const auto& axis = m.axes[static_cast<std::size_t>(i)];
        const double lost = axis.viscous_friction * v[i] + (v[i] > 0 ? 1 : -1) * axis.coulomb_friction;
        sum += (force[i] - lost) * v[i] * (axis.kind == AxisKind::linear ? 1e-3 : 1.0);
      }
      return sum;
    };
    for (int k = 0; k < 4000; ++k) {
      const double t = k * dt;
      work += dt / 6.0 * (power(t) + 4.0 * power(t + dt / 2) + power(t + dt));  // Simpson
      if (k % 100 != 99) continue;
      const double change = energy(m, run.at(t + dt, 0), run.at(t + dt, 1)) - start;
      largest = std::max(largest, std::abs(change));
      worst = std::max(worst, std::abs(work - change));
    }
    EXPECT_GT(largest, 1.0) << m.name;
    EXPECT_LT(worst, 1e-3 * largest) << m.name << " seed 41";
  }
}

/// A five-axis program under TCP, from rest to rest: head and table swing while the tip goes round.
std::string swinging_program() {
  std::string text = "G21 G90 G17\nT1 M6\nS5000 M3\nG43.4 H1\nG0 X0 Y0 Z30 A0 C0\nG1 Z5 F3000\n";
  for (int k = 1; k <= 120; ++k) {
    const double t = 0.05 * k;
    text += "X" + geometry::fixed_text(40 * std::sin(t), 3) + " Y" + geometry::fixed_text(30 - 30 * std::cos(t), 3) +
            " Z" + geometry::fixed_text(5 + 3 * std::sin(2 * t), 3) + " A" +
            geometry::fixed_text(20 * std::sin(1.3 * t), 3) + " C" + geometry::fixed_text(50 * std::sin(0.7 * t), 3) +
            "\n";
  }
  return text + "G0 Z60\nG49\nM30\n";
}

/// What the drives give over a whole program, sample by sample, is the change of energy and what friction took: the
/// energy is counted from the links' places alone.
TEST(DriveForces, WorkOverAWholeProgramIsTheChangeOfEnergy) {
  const auto profile = kinematics::load_profile(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines", "ac-head-fanuc");
  ASSERT_TRUE(profile) << profile.error().message;
  const Machine& m = profile->machine;
  const std::string text = swinging_program();
  ProgramReader program(text, "swing.nc", m, profile->control);
  ControlSetup setup;
  setup.machine = &m;
  setup.control = &profile->control;
  setup.tool_length_mm = 120.0;
  std::vector<AxisSample> samples;
  const auto run = run_program(program, setup, [&](std::span<const AxisSample> chunk) {
    samples.insert(samples.end(), chunk.begin(), chunk.end());
  });
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_GT(samples.size(), 1000u);
  const auto power = [&](const AxisSample& s) {
    const AxisVector force = drive_forces(m, s.position, s.velocity, s.acceleration);
    double sum = 0.0;
    for (int i = 0; i < 5; ++i) {
      const auto& axis = m.axes[static_cast<std::size_t>(i)];
      const double v = s.velocity[i], lost = axis.viscous_friction * v + (v > 0 ? 1 : -1) * axis.coulomb_friction;
      if (v != 0.0) sum += (force[i] - lost) * v * (axis.kind == AxisKind::linear ? 1e-3 : 1.0);
    }
    return sum;
  };
  const double start = energy(m, samples[0].position, samples[0].velocity);
  double work = 0.0, exchanged = 0.0, worst = 0.0, before = power(samples[0]);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double now = power(samples[k]), step = 0.5 * (now + before) * (samples[k].time_s - samples[k - 1].time_s);
    work += step;
    exchanged += std::abs(step);
    before = now;
    if (k % 50 != 0 && k + 1 != samples.size()) continue;
    const double change = energy(m, samples[k].position, samples[k].velocity) - start;
    worst = std::max(worst, std::abs(work - change));
  }
  RecordProperty("worst_share_ppm", static_cast<int>(1e6 * worst / exchanged));
  EXPECT_GT(exchanged, 50.0);
  EXPECT_LT(worst, 1e-3 * exchanged) << "of " << exchanged << " J that passed through the drives";
}

TEST(LoadsMeter, PeaksAndMeanSquaresOfARun) {
  Machine m = plain_head();
  for (auto& axis : m.axes) axis.assumed = false;
  m.axes[0].force_max = 3000.0;
  LoadsMeter meter(m);
  std::vector<AxisSample> samples(4);
  for (std::size_t i = 0; i < 4; ++i) {
    samples[i].position = samples[i].velocity = samples[i].acceleration = AxisVector::Zero();
    samples[i].line = static_cast<std::int64_t>(10 + i);
  }
  samples[1].acceleration[0] = 1000.0;
  samples[2].acceleration[0] = -2000.0;
  meter.add(std::span(samples).first(2));
  meter.add(std::span(samples).last(2));
  const LoadsReport report = meter.report();
  EXPECT_TRUE(report.known);
  EXPECT_NEAR(report.axes[0].peak, 3500.0, 1e-9);
  EXPECT_NEAR(report.axes[0].rms, std::sqrt((1750.0 * 1750.0 + 3500.0 * 3500.0) / 4), 1e-9);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].line, 12);
  EXPECT_EQ(report.findings[0].axis_or_pair, "X");
}

/// A load over a limit is a fault of the program only where the numbers are the machine's own.
TEST(LoadsMeter, ALoadThatRestsOnAssumedNumbersIsAWarningThatSaysSo) {
  Machine m = plain_head();
  for (auto& axis : m.axes) axis.assumed = false;
  m.axes[0].force_max = 3000.0;
  m.axes[4].assumed = true;  // X carries C, so X's load rests on C's mass
  std::vector<AxisSample> samples(1);
  samples[0].position = samples[0].velocity = samples[0].acceleration = AxisVector::Zero();
  samples[0].acceleration[0] = 2000.0;
  LoadsMeter meter(m);
  meter.add(samples);
  const LoadsReport report = meter.report();
  EXPECT_TRUE(report.findings.empty());
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_NE(report.warnings[0].text.find("assumes"), std::string::npos) << report.warnings[0].text;
  EXPECT_FALSE(rests_on_assumptions(m, 3));  // A carries nothing
  EXPECT_TRUE(rests_on_assumptions(m, 4));
  m.table_axes = 2;  // X Y carry the part: X what stands before it, Y X
  EXPECT_FALSE(rests_on_assumptions(m, 0));
  m.axes[0].assumed = true;
  EXPECT_TRUE(rests_on_assumptions(m, 1));
  EXPECT_FALSE(rests_on_assumptions(m, 3));
}

TEST(LoadsMeter, AMachineWithoutMassesIsNotKnown) {
  Machine m = plain_head();
  for (auto& axis : m.axes) {
    axis.moved_mass_kg = 0.0;
    axis.inertia_kg_m2.setZero();
  }
  EXPECT_FALSE(LoadsMeter(m).report().known);
}

}  // namespace
}  // namespace volute::sim

// Good programs with letters changed at random: whatever comes, the reader ends with motions or with one line that says
// where and why.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "geometry/number_text.hpp"
#include "tests/cases.hpp"
#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

using kinematics::DialectFamily;

struct Sample {
  DialectFamily family;
  const char* text;
};

constexpr Sample samples[] = {
    {DialectFamily::linuxcnc,
     "%\nG21 G90 G17\n#<r>=5\no1 sub\nG0 X#1 Y[#2*cos[30]]\no1 endsub\no1 call [1] [2]\no2 while [#<r> gt "
     "0]\n#<r>=[#<r>-1]\nG1 X#<r> F100\n"
     "o2 endwhile\no3 repeat [3]\nG91 G0 X1\no3 endrepeat\nG90\nM428\nG93 G1 X1 Y2 Z3 A4 C5 F20\nM429\nG94 F100\nG0 X1 "
     "Y2 Z3\nG2 X5 "
     "Y2 R4\nG64 P0.01 Q0\n"
     "G81 X1 Y1 Z-1 R2\nG83 X1 Z-2 R2 Q0.5\nG80\nG92 X0\nG10 L20 P1 Y5\nG53 G0 Z0\nM30\n%\n"},
    {DialectFamily::fanuc,
     "%\nO0001 (PART)\nN10 G21 G90 G94 G17 G40 G49 G80\nN20 G53 G0 Z0.\nN30 T1 M6\nN50 S12000 M3\nN60 G0 A-12.345 "
     "C45.678\nN70 G05.1 Q1\n"
     "N80 G43.4 H1 X10. Y20. Z150.\nN100 G1 Z5. F3000.\nN110 X10.123 Y20.456 Z3.789 A-12.345 C45.678 F2500.\nM98 P2 "
     "L2\nG49\nG28 G91 Z0.\nM30\n"
     "O2\nG91 G1 X1. F100.\nM99\n%\n"},
    {DialectFamily::haas,
     "%\nO1\nG187 P3 E0.05\nG0 G234 H1 X1. Y2. Z3.\nG1 Z0. F100.\nG4 P100\nG49\nG53 G0 Z0.\nM30\n%\n"},
    {DialectFamily::mazak, "G5 P2\nG0 G43.5 H1 X0. Y0. Z9.\nG1 X1. I0. J0.6 K0.8 F100.\nG49\nG5 P0\nM30\n"},
    {DialectFamily::siemens,
     "%_N_P_MPF\nN1 G17 G90 G94 G71\nN2 G0 SUPA Z0 D0\nN3 T=\"BALL\" M6\nN4 CYCLE832(0.01,_ORI_FINISH,0.5)\nN5 G0 A-12 "
     "C=DC(45.678)\nN6 TRAORI\n"
     "N7 ORIWKS ORIAXES\nN8 R1=2 X=R1*(3+1) Y=IC(5)\nN9 G1 X1 Y2 Z3 A3=0.6 B3=0 C3=0.8 F2500\nN10 G3 X0 Y0 CR=9\nN11 "
     "TRANS X5\nN12 TRAFOOF\nN13 M30\n"},
    {DialectFamily::heidenhain,
     "0 BEGIN PGM P MM\n1 BLK FORM 0.1 Z X-50 Y-50 Z-20\n2 TOOL CALL 1 Z S5000\n3 CYCL DEF 32.0 TOLERANCE\n4 CYCL DEF "
     "32.1 T0.02\n"
     "5 CYCL DEF 32.2 HSC-MODE:0 TA0.5\n6 M126\n7 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n8 L X+1 Y+2 Z+3 A-12.3 "
     "C+45.6 R0 F2500 M3\n"
     "9 LN X+1 Y+2 Z+3 TX+0.6 TY+0 TZ+0.8\n10 LBL 1\n11 L IX+1 FMAX\n12 CALL LBL 1 REP 3\n13 Q1 = 2 * (3 + 4)\n14 FN "
     "1: Q2 = +Q1 + +1\n"
     "15 L X+0 Y+0\n15 CC X+5 Y+0\n16 C X+10 Y+0 DR-\n17 FUNCTION RESET TCPM\n18 L C+0 FMAX M94\n19 M30\n20 END PGM P "
     "MM\n"}};

std::string mutated(std::string text, std::mt19937& random) {
  static constexpr std::string_view letters = "GMXYZABCIJKRFSTHDNOPQLU0123456789.+-*/=#<>[]()%;\"\n \t,:o\x01\xff";
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::size_t changes = 1 + pick(6);
  for (std::size_t i = 0; i < changes && text.size() > 2; ++i) {
    const std::size_t at = pick(text.size());
    switch (pick(5)) {
      case 0:
        text[at] = letters[pick(letters.size())];
        break;
      case 1:
        text.insert(at, 1, letters[pick(letters.size())]);
        break;
      case 2:
        text.erase(at, 1 + pick(4));
        break;
      case 3:
        text.insert(at, text.substr(pick(text.size()), pick(40)));
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

void expect_sound(const Reading& program) {
  for (const MotionBlock& block : program.blocks) {
    EXPECT_TRUE(block.xyz_mm.allFinite() && block.centre_mm.allFinite());
    EXPECT_TRUE(std::isfinite(block.rotary_rad[0]) && std::isfinite(block.rotary_rad[1]));
    EXPECT_TRUE(std::isfinite(block.feed) && block.feed >= 0.0);
    EXPECT_TRUE(std::isfinite(block.sweep_rad) && std::isfinite(block.dwell_s) && block.dwell_s >= 0.0);
    EXPECT_TRUE(block.kind != MotionKind::line || block.feed > 0.0);
  }
  if (!program.error) return;
  EXPECT_EQ(program.error->kind, geometry::ErrorKind::bad_input);
  EXPECT_TRUE(program.error->code.starts_with("program-")) << program.error->code;
  EXPECT_TRUE(program.error->message.starts_with("p.nc:")) << program.error->message;
  EXPECT_EQ(program.error->message.find('\n'), std::string::npos);
  for (const char c : program.error->message) EXPECT_TRUE(c >= ' ' && c <= '~');
}

TEST(Mutation, EveryProgramEndsWithMotionsOrOneLine) {
  const int programs = cases(3000);
  int refused = 0;
  for (int i = 0; i < programs; ++i) {
    const auto seed = static_cast<unsigned>(i);
    std::mt19937 random(seed);
    const Sample& sample = samples[static_cast<std::size_t>(i) % std::size(samples)];
    const std::string text = mutated(sample.text, random);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const auto program = read(text, machine_with('A', 'C'), control_of(sample.family), {}, 5000);
    expect_sound(program);
    refused += program.error ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(refused, programs / 2);
  EXPECT_LT(refused, programs);
}

TEST(Mutation, TheSamplesThemselvesAreRead) {
  for (const Sample& sample : samples) {
    const auto program = read(sample.text, machine_with('A', 'C'), control_of(sample.family));
    EXPECT_FALSE(program.error) << program.message();
  }
}

}  // namespace
}  // namespace volute::sim::test

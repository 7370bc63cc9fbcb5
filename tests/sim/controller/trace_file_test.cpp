#include "sim/controller/trace_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/file.hpp"
#include "tests/sim/controller/test_machines.hpp"

namespace volute::sim {
namespace {

using namespace test;

class TraceFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("trace-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    run_ = run_blocks(machine_, plain_control(), {line_to({10, 5, 0}, 50), line_to({10, 5, -3}, 20, 0.2, 0.4, true)});
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  geometry::Result<void> write(const std::filesystem::path& file, TraceFormat format, int stride = 1) {
    auto writer = TraceWriter::open(file, format, machine_, 0.001);
    if (!writer) return tl::unexpected(writer.error());
    writer->set_stride(stride);
    writer->write(run_.samples);
    return writer->close();
  }

  kinematics::Machine machine_ = head_machine();
  std::filesystem::path folder_;
  Ran run_;
};

TEST_F(TraceFile, BinaryReadsBackWhatWasWritten) {
  ASSERT_TRUE(write(folder_ / "a.trace", TraceFormat::binary));
  const auto trace = read_trace(folder_ / "a.trace");
  ASSERT_TRUE(trace) << trace.error().message;
  ASSERT_EQ(trace->samples.size(), run_.samples.size());
  EXPECT_EQ(trace->period_s, 0.001);
  EXPECT_EQ(trace->letters[4], 'C');
  for (std::size_t k = 0; k < run_.samples.size(); ++k) {
    EXPECT_EQ(trace->samples[k].position, run_.samples[k].position);
    EXPECT_NEAR((trace->samples[k].velocity - run_.samples[k].velocity).norm(), 0.0, 1e-4);
    EXPECT_EQ(trace->samples[k].line, run_.samples[k].line);
    EXPECT_EQ(trace->samples[k].limit, run_.samples[k].limit);
    EXPECT_EQ(trace->samples[k].cutting, run_.samples[k].cutting);
    EXPECT_NEAR(trace->samples[k].time_s, run_.samples[k].time_s, 1e-9);
  }
  EXPECT_EQ(std::filesystem::file_size(folder_ / "a.trace"), 64 + 96 * run_.samples.size());
}

TEST_F(TraceFile, CsvHasOneLineASample) {
  ASSERT_TRUE(write(folder_ / "a.csv", TraceFormat::csv, 10));
  const auto text = geometry::read_file(folder_ / "a.csv");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->rfind("time_s,X,Y,Z,A,C,v_X", 0), 0U);
  const auto lines = static_cast<std::size_t>(std::count(text->begin(), text->end(), '\n'));
  EXPECT_EQ(lines, 1 + (run_.samples.size() + 9) / 10);
}

TEST_F(TraceFile, LeavesNothingWhenItIsNotClosed) {
  {
    auto writer = TraceWriter::open(folder_ / "b.trace", TraceFormat::binary, machine_, 0.001);
    ASSERT_TRUE(writer);
    writer->write(run_.samples);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(TraceFile, RefusesWhatIsNotATrace) {
  ASSERT_TRUE(write(folder_ / "a.trace", TraceFormat::binary));
  const auto bytes = geometry::read_file(folder_ / "a.trace");
  ASSERT_TRUE(geometry::write_file(folder_ / "short.trace", std::string_view(*bytes).substr(0, bytes->size() - 7)));
  ASSERT_TRUE(geometry::write_file(folder_ / "text.trace", "hello"));
  for (const char* name : {"short.trace", "text.trace"}) {
    const auto trace = read_trace(folder_ / name);
    ASSERT_FALSE(trace);
    EXPECT_EQ(trace.error().code, "trace-format");
  }
  EXPECT_EQ(read_trace(folder_ / "none.trace").error().code, "file-missing");
  EXPECT_FALSE(TraceWriter::open(folder_ / "no" / "such.trace", TraceFormat::csv, machine_, 0.001));
}

}  // namespace
}  // namespace volute::sim

#include "geometry/file.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

TEST(File, ComesBackByteForByte) {
  const auto file = scratch("file") / "a.bin";
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(file, bytes));
  EXPECT_EQ(read_file(file).value(), bytes);
  ASSERT_TRUE(write_file(file, ""));
  EXPECT_EQ(read_file(file).value(), "");
}

TEST(File, MissingFilesAndFoldersAreBadInput) {
  const auto folder = scratch("file");
  for (const auto& file : {folder / "none", folder}) {
    const auto bytes = read_file(file);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, "file-missing");
    EXPECT_EQ(bytes.error().kind, ErrorKind::bad_input);
    EXPECT_NE(bytes.error().message.find(file.string()), std::string::npos);
  }
}

TEST(File, AFailedWriteLeavesNothingBehind) {
  const auto folder = scratch("file");
  std::filesystem::create_directory(folder / "taken");
  const auto status = write_file(folder / "taken", "x");  // a folder of that name stands there
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, "file-not-written");
  EXPECT_EQ(status.error().kind, ErrorKind::system);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "taken"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  EXPECT_FALSE(write_file(folder / "no" / "such" / "folder", "x"));
}

TEST(File, WritingOverAFileLeavesOneFile) {
  const auto folder = scratch("file");
  ASSERT_TRUE(write_file(folder / "a", "one"));
  ASSERT_TRUE(write_file(folder / "a", "two"));
  EXPECT_EQ(read_file(folder / "a").value(), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

}  // namespace
}  // namespace volute::geometry::test

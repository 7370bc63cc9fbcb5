#include "geometry/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace volute::geometry {

namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, FileCloser>;

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

tl::unexpected<Error> not_read(const std::filesystem::path& file, int error_number) {
  return system_error("file-not-read", file.string() + ": could not be read: " + reason_of(error_number));
}

tl::unexpected<Error> not_written(const std::filesystem::path& file, int error_number) {
  return system_error("file-not-written", file.string() + ": could not be written: " + reason_of(error_number) +
                                              "; check the folder, its permissions and the free space");
}

/// True when every byte has reached the system's hands.
bool write_bytes(const std::filesystem::path& file, std::string_view bytes) {
  FileHandle handle(std::fopen(file.c_str(), "wb"));
  if (!handle) return false;
  if (std::fwrite(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size()) return false;
  return std::fclose(handle.release()) == 0;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& file) {
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    return bad_input("file-missing",
                     file.string() + ": no such file; check the path (relative paths in a job start at the job file)");
  if (!std::filesystem::is_regular_file(file, status))
    return bad_input("file-missing", file.string() + ": is a folder or a device, not a file; name a file in it");
  FileHandle handle(std::fopen(file.c_str(), "rb"));
  if (!handle) return not_read(file, errno);
  const auto size = std::filesystem::file_size(file, status);
  if (status) return not_read(file, status.value());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  errno = 0;
  if (std::fread(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size()) return not_read(file, errno);
  return bytes;
}

Result<void> write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::path beside = file;
  beside += ".part-" + std::to_string(::getpid());
  errno = 0;
  if (write_bytes(beside, bytes) && std::rename(beside.c_str(), file.c_str()) == 0) return {};
  const int error_number = errno;
  std::remove(beside.c_str());
  return not_written(file, error_number);
}

}  // namespace volute::geometry

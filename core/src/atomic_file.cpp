#include "swayaw/core/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

namespace fs = std::filesystem;

bool is_device(const fs::path& file) {
  std::error_code ignored;
  const auto status = fs::status(file, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

bool write_all(const fs::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  return !out.fail();
}

[[noreturn]] void fail(const fs::path& file, std::string_view deed) {
  throw FileError({.file = file}, std::string(deed) + " (" + std::strerror(errno) + ")");
}

}  // namespace

std::string read_text(const fs::path& file) {
  if (fs::is_directory(file)) throw FileError({.file = file}, "is a folder, not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, "cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

void write_text(const fs::path& file, std::string_view text) {
  if (is_device(file)) {
    if (!write_all(file, text)) fail(file, "cannot be written");
    return;
  }
  const fs::path draft = file.string() + ".part" + std::to_string(::getpid());
  if (!write_all(draft, text)) {
    const int reason = errno;
    std::error_code ignored;
    fs::remove(draft, ignored);
    errno = reason;
    fail(file, "cannot be written");
  }
  fs::rename(draft, file);
}

}  // namespace swayaw

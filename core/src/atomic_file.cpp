#include "swayaw/core/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {
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

[[noreturn]] void fail(const FilePlace& place, std::string_view deed) {
  throw FileError(place, std::string(deed) + " (" + std::strerror(errno) + ")");
}

/// Where the text goes: a link stays, the file it points to changes.
fs::path target_of(const fs::path& file) {
  std::error_code failed;
  const auto target = fs::canonical(file, failed);
  return failed ? file : target;
}

bool rename_to(const fs::path& draft, const fs::path& target) {
  return std::rename(draft.c_str(), target.c_str()) == 0;
}

}  // namespace

std::string read_text(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw FileError({file, 1, 1}, "is a folder, not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) fail({file, 1, 1}, "cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  if (text.bad()) fail({file, 1, 1}, "cannot be read to its end");
  return std::move(text).str();
}

void write_draft(const fs::path& file, const std::function<bool(const fs::path&)>& write) {
  if (is_device(file)) {
    if (!write(file)) fail({.file = file}, "cannot be written");
    return;
  }
  const fs::path target = target_of(file);
  const fs::path draft = target.string() + ".part" + std::to_string(::getpid());
  if (write(draft) && rename_to(draft, target)) return;
  const int reason = errno;
  std::error_code ignored;
  fs::remove(draft, ignored);
  errno = reason;
  fail({.file = file}, "cannot be written");
}

void write_text(const fs::path& file, std::string_view text) {
  write_draft(file, [text](const fs::path& draft) { return write_all(draft, text); });
}

}  // namespace swayaw::core

#include "swayaw/core/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <utility>

#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const FilePlace& place, std::string_view deed) {
  throw FileError(place, std::string(deed) + " (" + std::strerror(errno) + ")");
}

/// An open file, closed at its end and in programs that are started.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

// ---------------------------------------------------------------- sizes

/// 0: the usual sizes hold.
std::atomic<std::uint64_t> largest{0};

/// "2 GB", "10 MB", "999 bytes"
std::string size_text(std::uint64_t bytes) {
  const auto number = static_cast<double>(bytes);
  if (bytes >= 1'000'000'000) return fmt::format("{:.4g} GB", 1e-9 * number);
  return bytes >= 1'000'000 ? fmt::format("{:.4g} MB", 1e-6 * number) : fmt::format("{} bytes", bytes);
}

/// The value of --max-file-size with which so many bytes are read.
std::string limit_for(std::uint64_t bytes) {
  const auto unit = bytes >= 1'000'000'000 ? std::pair(1'000'000'000ULL, "GB") : std::pair(1'000'000ULL, "MB");
  return fmt::format("{}{}", bytes / unit.first + 1, unit.second);
}

/// @param bytes  of a pipe the size that it would have next
[[noreturn]] void refuse_size(const fs::path& file, const std::string& size, std::uint64_t bytes, FileUse use) {
  throw FileError({.file = file},
                  fmt::format("has {}, and files of up to {} are read here; --max-file-size {} reads it", size,
                              size_text(largest_file(use)), limit_for(bytes)));
}

void require_size(const fs::path& file, std::uint64_t bytes, FileUse use) {
  if (bytes > largest_file(use)) refuse_size(file, size_text(bytes), bytes, use);
}

// ---------------------------------------------------------------- reading

/// Opens it without waiting for the other end of a pipe.
OpenFile opened(const fs::path& file) {
  return OpenFile(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
}

/// From now on waits for what comes through a pipe.
void wait_for(const OpenFile& pipe) {
  ::fcntl(pipe.descriptor(), F_SETFL, ::fcntl(pipe.descriptor(), F_GETFL) & ~O_NONBLOCK);
}

/// Appends what comes next, up to `most` bytes. @return how many; 0 at the end
std::size_t append(const OpenFile& from, std::size_t most, std::string& text, const fs::path& file) {
  const auto before = text.size();
  text.resize(before + most);
  ::ssize_t count = 0;
  do count = ::read(from.descriptor(), text.data() + before, most);
  while (count < 0 && errno == EINTR);
  if (count < 0) fail({file, 1, 1}, "cannot be read to its end");
  text.resize(before + static_cast<std::size_t>(count));
  return static_cast<std::size_t>(count);
}

/// From line end to line end, as many lines at once as `longest_line` has room for.
void require_short_lines(const std::string& text, const fs::path& file) {
  for (std::size_t begin = 0; text.size() - begin > longest_line;) {
    const auto end = text.find_last_of("\r\n", begin + longest_line);
    if (end == std::string::npos || end < begin) {
      const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
      throw FileError({file, static_cast<std::size_t>(lines) + 1, 1},
                      fmt::format("a line of more than {} bytes; no table and no text has such lines", longest_line));
    }
    begin = end + 1;
  }
}

// ---------------------------------------------------------------- writing

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

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// A link that another user laid into a folder where all may write leads where that user wants. The kernel does not
/// follow such links where fs.protected_symlinks = 1, but it need not be.
bool is_foreign_link(const fs::path& file) {
  struct stat link {
  }, folder{};
  if (::lstat(file.c_str(), &link) != 0 || !S_ISLNK(link.st_mode)) return false;
  if (::stat(folder_of(file).c_str(), &folder) != 0) return false;
  const bool for_all = (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & S_IWOTH) != 0;
  return for_all && link.st_uid != ::geteuid() && link.st_uid != folder.st_uid;
}

/// Where the text goes: a link stays, the file it points to changes.
fs::path target_of(const fs::path& file) {
  if (is_foreign_link(file))
    throw FileError({.file = file}, "is a link that another user laid into a folder for all; it is not followed");
  std::error_code failed;
  const auto target = fs::canonical(file, failed);
  return failed ? file : target;
}

/// An empty file beside the target that nobody else made, with its permissions. Its name cannot be foreseen, and a link
/// of that name would not be followed.
fs::path draft_beside(const fs::path& target, const fs::path& named) {
  struct stat old {};
  const bool is_new = ::stat(target.c_str(), &old) != 0;
  std::random_device random;
  while (true) {
    const auto draft = target.parent_path() / fmt::format(".swayaw-{:08x}{:08x}.part", random(), random());
    const OpenFile made(
        ::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, is_new ? 0666 : 0600));
    if (!made.is_open() && errno == EEXIST) continue;
    if (!made.is_open()) fail({.file = named}, "cannot be written");
    if (!is_new) ::fchmod(made.descriptor(), old.st_mode & 0777);
    return draft;
  }
}

bool rename_to(const fs::path& draft, const fs::path& target) {
  return std::rename(draft.c_str(), target.c_str()) == 0;
}

}  // namespace

std::uint64_t largest_file(FileUse use) {
  if (const auto bytes = largest.load()) return bytes;
  return use == FileUse::samples ? usual_samples_size : usual_description_size;
}

void set_largest_file(std::uint64_t bytes) { largest = bytes; }

std::string read_text(const fs::path& file, FileUse use) {
  const auto in = opened(file);
  if (!in.is_open()) fail({file, 1, 1}, "cannot be read");
  struct stat about {};
  if (::fstat(in.descriptor(), &about) != 0) fail({file, 1, 1}, "cannot be read");
  if (S_ISDIR(about.st_mode)) throw FileError({file, 1, 1}, "is a folder, not a file");
  if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) throw FileError({file, 1, 1}, "is a device, not a file");
  if (S_ISFIFO(about.st_mode)) wait_for(in);
  const auto size = S_ISREG(about.st_mode) ? static_cast<std::uint64_t>(about.st_size) : 0;
  require_size(file, size, use);
  constexpr std::size_t piece = 1 << 20;
  std::string text;
  text.reserve(size + piece);
  while (append(in, piece, text, file) > 0)
    if (text.size() > largest_file(use))
      refuse_size(file, "more than " + size_text(largest_file(use)), 2 * largest_file(use), use);
  require_short_lines(text, file);
  return text;
}

void require_regular_file(const fs::path& file, FileUse use) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return;
  if (S_ISDIR(about.st_mode)) throw FileError({file, 1, 1}, "is a folder, not a file");
  if (!S_ISREG(about.st_mode)) throw FileError({file, 1, 1}, "is a pipe or a device; a regular file is needed here");
  require_size(file, static_cast<std::uint64_t>(about.st_size), use);
}

void write_draft(const fs::path& file, const std::function<bool(const fs::path&)>& write) {
  if (is_device(file)) {
    if (!write(file)) fail({.file = file}, "cannot be written");
    return;
  }
  const fs::path target = target_of(file);
  const fs::path draft = draft_beside(target, file);
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

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch.hpp>
#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"

/// A reader sees the old text or the new, and no draft is left behind.
namespace swayaw {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST_CASE("text is written and read as it is", "[core][round-trip]") {
  const test::Scratch scratch;
  const std::string text(
      "a\r\n\0\xFF"
      "b",
      6);
  write_text(scratch / "file", text);
  CHECK(read_text(scratch / "file") == text);
  write_text(scratch / "file", "");
  CHECK(read_text(scratch / "file").empty());
  CHECK(entries(scratch / "") == 1);
}

TEST_CASE("a relative name without a folder is written in the current one", "[core]") {
  const test::Scratch scratch;
  const auto before = fs::current_path();
  fs::current_path(scratch / "");
  write_text("file", "text");
  fs::current_path(before);
  CHECK(read_text(scratch / "file") == "text");
}

TEST_CASE("writing into a folder that is not there is refused and makes nothing", "[core][refusal]") {
  const test::Scratch scratch;
  const auto file = scratch / "absent" / "file";
  CHECK_THROWS_WITH(write_text(file, "text"), file.string() + ": cannot be written (No such file or directory)");
  CHECK(entries(scratch / "") == 0);
}

TEST_CASE("a file that takes the place of a folder is refused", "[core][refusal]") {
  const test::Scratch scratch;
  fs::create_directory(scratch / "folder");
  CHECK_THROWS_AS(write_text(scratch / "folder", "text"), FileError);
  CHECK_THROWS_AS(write_text(scratch / "folder" / "", "text"), FileError);
  CHECK(fs::is_directory(scratch / "folder"));
  CHECK(entries(scratch / "") == 1);
}

TEST_CASE("a full device is told", "[core][refusal]") {
  if (!fs::exists("/dev/full")) return;
  CHECK_THROWS_WITH(write_text("/dev/full", std::string(100000, 'x')),
                    "/dev/full: cannot be written (No space left on device)");
  CHECK_THROWS_AS(write_text("/dev/full", "x"), FileError);
  CHECK(fs::exists("/dev/full"));
}

TEST_CASE("a draft that cannot be written leaves the old text and no draft", "[core][refusal]") {
  const test::Scratch scratch;
  write_text(scratch / "file", "old");
  CHECK_THROWS_AS(write_draft(scratch / "file", [](const fs::path&) { return false; }), FileError);
  CHECK(read_text(scratch / "file") == "old");
  CHECK(entries(scratch / "") == 1);
}

TEST_CASE("a link stays a link and its target gets the text", "[core]") {
  const test::Scratch scratch;
  write_text(scratch / "target", "old");
  fs::create_symlink(scratch / "target", scratch / "link");
  write_text(scratch / "link", "new");
  CHECK(fs::is_symlink(scratch / "link"));
  CHECK(read_text(scratch / "target") == "new");
  CHECK(entries(scratch / "") == 2);
}

// ---------------------------------------------------------------- who may read it, and where it goes

unsigned mode_of(const fs::path& file) { return static_cast<unsigned>(fs::status(file).permissions()) & 0777U; }

TEST_CASE("a new file has the permissions that the user's mask leaves, as its draft has", "[core]") {
  const test::Scratch scratch;
  const auto before = ::umask(027);
  unsigned of_draft = 0;
  write_draft(scratch / "file", [&](const fs::path& draft) {
    of_draft = mode_of(draft);
    return true;
  });
  ::umask(before);
  CHECK(of_draft == 0640);
  CHECK(mode_of(scratch / "file") == 0640);
}

TEST_CASE("a private file stays private while it is written and after", "[core]") {
  const test::Scratch scratch;
  write_text(scratch / "file", "old");
  fs::permissions(scratch / "file", fs::perms(0600));
  write_draft(scratch / "file", [&](const fs::path& draft) {
    CHECK(mode_of(draft) == 0600);
    return true;
  });
  CHECK(mode_of(scratch / "file") == 0600);
}

TEST_CASE("a draft stands beside its file under a name that differs each time", "[core]") {
  const test::Scratch scratch;
  std::set<fs::path> drafts;
  for (int i = 0; i < 20; ++i)
    write_draft(scratch / std::string(255, 'n'), [&](const fs::path& draft) { return drafts.insert(draft).second; });
  CHECK(drafts.size() == 20);
  for (const auto& draft : drafts) CHECK(draft.parent_path() == (scratch / "file").parent_path());
}

TEST_CASE("a link that another user laid into a folder for all is not followed", "[core][refusal]") {
  if (::geteuid() != 0) return;  // only root may lay a link for another
  const test::Scratch scratch;
  fs::create_directory(scratch / "for_all");
  write_text(scratch / "victim", "old");
  const auto link = scratch / "for_all" / "page.html";
  fs::create_symlink(scratch / "victim", link);
  REQUIRE(::lchown(link.c_str(), 12345, 12345) == 0);
  write_text(link, "in a folder of one's own");
  CHECK(read_text(scratch / "victim") == "in a folder of one's own");
  fs::permissions(scratch / "for_all", fs::perms(01777));
  CHECK_THROWS_WITH(write_text(link, "elsewhere"), link.string() +
                                                       ": is a link that another user laid into a folder for "
                                                       "all; it is not followed");
  CHECK(read_text(scratch / "victim") == "in a folder of one's own");
}

// ---------------------------------------------------------------- what is not read

/// The limit holds for this process.
struct Limit {
  explicit Limit(std::uint64_t bytes) { set_largest_file(bytes); }
  ~Limit() { set_largest_file(0); }
};

TEST_CASE("a file that is too large is refused in one line that tells how it is read", "[core][refusal]") {
  const test::Scratch scratch;
  const auto large = scratch / "large";
  write_text(large, "");
  fs::resize_file(large, usual_description_size + 1);  // takes no room
  CHECK_THROWS_WITH(
      read_text(large, FileUse::description),
      large.string() + ": has 10 MB, and files of up to 10 MB are read here; --max-file-size 11MB reads it");
  fs::resize_file(large, usual_samples_size + 500'000'000);
  CHECK_THROWS_WITH(
      read_text(large),
      large.string() + ": has 1.5 GB, and files of up to 1 GB are read here; --max-file-size 2GB reads it");
  CHECK_THROWS_AS(require_regular_file(large), FileError);
}

TEST_CASE("another limit holds for files of all uses", "[core][refusal]") {
  const test::Scratch scratch;
  write_text(scratch / "file", std::string(100, '\n'));
  const Limit limit(99);
  CHECK_THROWS_AS(read_text(scratch / "file"), FileError);
  CHECK_THROWS_AS(read_text(scratch / "file", FileUse::description), FileError);
  set_largest_file(100);
  CHECK(read_text(scratch / "file").size() == 100);
}

TEST_CASE("devices and endless pipes do not fill the memory", "[core][refusal]") {
  const test::Scratch scratch;
  CHECK_THROWS_WITH(read_text("/dev/zero"), "/dev/zero:1:1: is a device, not a file");
  CHECK_THROWS_AS(require_regular_file("/dev/zero"), FileError);
  const auto pipe = scratch / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(read_text(pipe).empty());  // nobody writes
  CHECK_THROWS_AS(require_regular_file(pipe), FileError);
  const Limit limit(1'000'000);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  const int writer = ::open(pipe.c_str(), O_WRONLY);
  std::signal(SIGPIPE, SIG_IGN);
  std::thread endless([&] {
    const std::string line = std::string(999, 'x') + "\n";
    while (::write(writer, line.data(), line.size()) > 0) {}
  });
  CHECK_THROWS_WITH(read_text(pipe), ContainsSubstring("has more than 1 MB, and files of up to 1 MB are read here"));
  ::close(reader);
  endless.join();
  ::close(writer);
}

TEST_CASE("what comes through a pipe is read to its end", "[core]") {
  const test::Scratch scratch;
  const auto pipe = scratch / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int writer = ::open(pipe.c_str(), O_RDWR);
  std::thread slow([&] {
    for (const std::string_view part : {"one\n", "two\n"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      if (::write(writer, part.data(), part.size()) < 0) return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    ::close(writer);
  });
  CHECK(read_text(pipe) == "one\ntwo\n");
  slow.join();
}

TEST_CASE("lines may be as long as a description, whatever ends them", "[core][limit]") {
  const test::Scratch scratch;
  const std::string line(longest_line, 'x');
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    write_text(scratch / "file", line + end + line + end + line);
    CHECK(read_text(scratch / "file").size() == 3 * longest_line + 2 * end.size());
  }
  write_text(scratch / "file", "short\n" + line + "\n" + line + "x");
  CHECK_THROWS_WITH(read_text(scratch / "file"), (scratch / "file").string() +
                                                     ":3:1: a line of more than 10000000 bytes; "
                                                     "no table and no text has such lines");
}

}  // namespace
}  // namespace swayaw

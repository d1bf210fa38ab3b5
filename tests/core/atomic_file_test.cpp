#include <catch.hpp>

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
  if (!fs::exists("/dev/full")) return;
  write_text(scratch / "file", "old");
  const auto draft = (scratch / "file").string() + ".part" + std::to_string(::getpid());
  fs::create_symlink("/dev/full", draft);
  CHECK_THROWS_AS(write_text(scratch / "file", std::string(100000, 'x')), FileError);
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

}  // namespace
}  // namespace swayaw

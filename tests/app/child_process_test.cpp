#include "../../app/src/child_process.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parallel.hpp"

/// What programs that are started see of this one.
namespace swayaw::app {
namespace {

using test::Scratch;

/// A variable of the environment, as it was before at the end.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (old_) ::setenv(name_, old_->c_str(), 1);
    else ::unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

/// A program of that name that says so.
void make_program(const std::filesystem::path& file) {
  write_text(file, "#!/bin/sh\necho it ran\n");
  std::filesystem::permissions(file, std::filesystem::perms(0755));
}

TEST_CASE("a program reads its input, and both its outputs and its code are told", "[app]") {
  const auto end = run_program({"sh", "-c", "cat; echo trouble >&2; exit 7"}, "words\n");
  REQUIRE(end);
  CHECK(end->out == "words\n");
  CHECK(end->err == "trouble\n");
  CHECK(end->code == 7);
}

TEST_CASE("words are words, whatever a shell would make of them", "[app][refusal]") {
  const std::string evil = "a b; touch made `touch made` $(touch made) \" ' * | > made";
  const auto end = run_program({"printf", "%s", evil}, {});
  REQUIRE(end);
  CHECK(end->out == evil);
  CHECK_FALSE(std::filesystem::exists("made"));
}

TEST_CASE("what a part of a work starts keeps to one core", "[app]") {
  const auto told = [] { return run_program({"sh", "-c", "echo \"$SWAYAW_ON_A_PART\""}, {})->out; };
  std::array<std::string, 2> parts;
  core::in_parallel(parts.size(), 2, [&](std::size_t i) { parts[i] = told(); });
  for (const auto& part : parts) CHECK(part == "1\n");
  CHECK(told() == "\n");

  const Variable variable("SWAYAW_ON_A_PART", "1");
  take_part();
  std::set<std::thread::id> threads;
  core::in_parallel(8, 4, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  CHECK(threads == std::set{std::this_thread::get_id()});
  core::on_a_part = false;
}

TEST_CASE("a program sees no variable that it does not need", "[app][refusal]") {
  const Variable secret("GITHUB_TOKEN", "secret"), preload("LD_PRELOAD_OF_NOBODY", "x"), language("LC_ALL", "C");
  const auto end = run_program({"env"}, {});
  REQUIRE(end);
  CHECK(end->out.find("secret") == std::string::npos);
  CHECK(end->out.find("LD_PRELOAD") == std::string::npos);
  CHECK(end->out.find("HOME=") == std::string::npos);
  CHECK(end->out.find("LC_ALL=C\n") != std::string::npos);
  CHECK(end->out.find("PATH=/") != std::string::npos);
}

TEST_CASE("a program has the three standard files open and no other, which are no files of a folder",
          "[app][refusal]") {
  const int left_open = ::open("/dev/null", O_RDONLY);  // as a library might, without O_CLOEXEC
  const auto numbers =
      run_program({"sh", "-c", "for f in /proc/$$/fd/*; do [ -e $f ] && echo ${f##*/}; done; true"}, {});
  const auto names = run_program({"sh", "-c", "readlink /proc/$$/fd/0 /proc/$$/fd/1 /proc/$$/fd/2"}, {});
  ::close(left_open);
  REQUIRE(numbers);
  REQUIRE(names);
  CHECK(numbers->out == "0\n1\n2\n");
  CHECK(names->out == "/memfd:swayaw (deleted)\n/memfd:swayaw (deleted)\n/memfd:swayaw (deleted)\n");
}

TEST_CASE("the current folder is not searched, even if PATH says so", "[app][refusal]") {
  const Scratch scratch;
  make_program(scratch / "gnuplot_of_nobody");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(scratch / "");
  for (const std::string path : {"", ":", ".", "./", "..:.", ":/usr/bin:."}) {
    const Variable searched("PATH", path);
    CHECK_FALSE(run_program({"gnuplot_of_nobody"}, {}));
  }
  const Variable searched("PATH", (scratch / "").string());
  const auto end = run_program({"gnuplot_of_nobody"}, {});
  std::filesystem::current_path(before);
  REQUIRE(end);
  CHECK(end->out == "it ran\n");
}

}  // namespace
}  // namespace swayaw::app

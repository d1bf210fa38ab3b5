#include "targets.hpp"

#include <algorithm>
#include <fstream>

#include "swayaw/core/refusal.hpp"

namespace swayaw::fuzz {

void promise(bool holds, std::string_view what) {
  if (!holds) throw BrokenPromise(std::string(what));
}

void write(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

namespace {

/// Whether it acts on a terminal, or ends the line.
bool is_control(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7F'; }

void require_one_line(const Target& target, const std::string& refusal) {
  const auto name = std::filesystem::path(target.file).filename().string();
  promise(refusal.find(name) != std::string::npos, "a refusal does not name the file: " + refusal);
  promise(std::ranges::none_of(refusal, is_control), "a refusal is not one line of plain text: " + refusal);
  promise(refusal.size() > name.size() + 2, "a refusal says nothing: " + refusal);
}

}  // namespace

End end_of(const Target& target, std::string_view bytes, const std::filesystem::path& scratch) {
  try {
    target.read(bytes, scratch / target.file);
    return {};
  } catch (const FileError& error) {
    require_one_line(target, error.what());
    return {error.what()};
  } catch (const BrokenPromise&) {
    throw;
  } catch (const std::exception& error) {
    throw BrokenPromise(std::string("not a refusal with its place: ") + error.what());
  }
}

}  // namespace swayaw::fuzz

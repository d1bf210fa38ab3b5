#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "../import/nmea_sentence.hpp"
#include "swayaw/core/detail/recording_rows.hpp"
#include "swayaw/core/manoeuvres_in.hpp"

namespace swayaw::inline core {
namespace {

/// start_utc of what begins so much later; nothing where it cannot be read.
std::vector<RunRemark> later(std::vector<RunRemark> remarks, double seconds) {
  std::erase_if(remarks, [&](RunRemark& remark) {
    if (remark.key != "start_utc") return false;
    const auto start = detail::time_stamp_in(remark.value);
    const bool known = start && start->kind == detail::TimeStamp::Kind::instant;
    if (known) remark.value = '"' + detail::utc_text(start->seconds + seconds) + '"';
    return !known;
  });
  return remarks;
}

}  // namespace

std::filesystem::path file_of_piece(const std::filesystem::path& out, std::size_t number, const ManoeuvrePiece& piece) {
  auto words = piece.manoeuvre;
  std::ranges::replace_if(
      words, [](char c) { return c == ' ' || c == '/'; }, '_');
  auto file = out;
  return file.replace_filename(fmt::format("{}_{}_{}{}", out.stem().string(), number, words, out.extension().string()));
}

Recording piece_of(const Recording& run, const ManoeuvrePiece& piece) {
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(run.time, piece.begin) - run.time.begin());
  const auto end = static_cast<std::size_t>(std::ranges::upper_bound(run.time, piece.end) - run.time.begin());
  if (first >= end)
    throw std::domain_error(fmt::format("no sample between {} s and {} s of {}", piece.begin, piece.end, run.name));
  const double zero = run.time[first];
  auto result = detail::rows_of(run, first, end);
  for (double& time : result.time) time -= zero;
  result.facts.manoeuvre = piece.manoeuvre;
  result.facts.execute = piece.execute ? std::optional(*piece.execute - zero) : std::nullopt;
  result.facts.remarks = later(std::move(result.facts.remarks), zero);
  return result;
}

}  // namespace swayaw::core

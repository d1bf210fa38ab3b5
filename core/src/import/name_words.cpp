#include "name_words.hpp"

#include <array>
#include <utility>

#include "characters.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

/// Letters that names have besides the plain ones, and how the table of names writes them.
constexpr std::array letters = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"ä", "ae"},  {"Ä", "ae"},    {"ö", "oe"},  {"Ö", "oe"},    {"ü", "ue"},    {"Ü", "ue"},  {"ß", "ss"},
     {"å", "aa"},  {"Å", "aa"},    {"ø", "o"},   {"Ø", "o"},     {"æ", "ae"},    {"Æ", "ae"},  {"á", "a"},
     {"Á", "a"},   {"Í", "i"},     {"Ó", "o"},   {"Ú", "u"},     {"Ñ", "n"},     {"à", "a"},   {"é", "e"},
     {"è", "e"},   {"ê", "e"},     {"É", "e"},   {"í", "i"},     {"ï", "i"},     {"ó", "o"},   {"ô", "o"},
     {"ú", "u"},   {"ñ", "n"},     {"ç", "c"},   {"ā", "a"},     {"ē", "e"},     {"ī", "i"},   {"ō", "o"},
     {"ū", "u"},   {"ψ", "psi"},   {"Ψ", "psi"}, {"δ", "delta"}, {"Δ", "delta"}, {"φ", "phi"}, {"ϕ", "phi"},
     {"Φ", "phi"}, {"ω", "omega"}, {"β", "beta"}});

constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

/// Bars at the borders of "RudderAngle" and "Rudder1", special letters as plain ones.
std::string plain_letters(std::string_view name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size();) {
    const auto rest = name.substr(i);
    const auto* found = letters.begin();
    while (found != letters.end() && !rest.starts_with(found->first)) ++found;
    if (found != letters.end()) {
      plain += found->second;
      i += found->first.size();
      continue;
    }
    const char c = rest.front(), before = plain.empty() ? ' ' : plain.back();
    const char after = rest.size() > 1 ? rest[1] : ' ';
    const bool new_word = is_upper(c) && is_lower(before) && (is_upper(after) || is_lower(after));  // but not of "StB"
    const bool border = new_word || (is_digit(c) && (is_lower(before) || is_upper(before)));
    if (border) plain += '_';
    plain += c;
    ++i;
  }
  return plain;
}

}  // namespace

std::vector<std::string> words_of(std::string_view name, bool signs) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.push_back(lower_case(word));
    word.clear();
  };
  for (const char c : plain_letters(name)) {
    if (is_upper(c) || is_lower(c) || is_digit(c)) {
      word += c;
      continue;
    }
    end_word();
    if (signs && (c == '+' || c == '-')) words.emplace_back(1, c);
  }
  end_word();
  return words;
}

}  // namespace swayaw::core::detail

#include "number_cell.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "characters.hpp"
#include "swayaw/core/detail/csv_text.hpp"

namespace swayaw::inline core::detail {
namespace {

constexpr std::array<std::string_view, 22> missing_marks{
    "nan", "-nan", "nan(ind)", "n/a",  "na",   "#n/a", "#nv", "#value!", "#wert!", "#div/0!",      "-",
    "--",  "---",  "----",     "null", "none", "nil",  "?",   "k.a.",    "void",   "\xE2\x80\x93", "\xE2\x80\x94"};

/// Length of a separator of groups that no decimal can be mistaken for: blank, no-break blank, thin blank, apostrophe.
std::size_t group_blank(std::string_view text) {
  for (const std::string_view blank : {" ", "'", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xE2\x80\x99"})
    if (text.starts_with(blank)) return blank.size();
  return 0;
}

bool three_digits(std::string_view text) {
  return text.size() >= 3 && std::all_of(text.begin(), text.begin() + 3, is_digit) &&
         (text.size() == 3 || !is_digit(text[3]));
}

/// What follows a number may be a unit, not the rest of a date, a clock time or a position.
bool may_be_unit(std::string_view text) {
  return text.empty() || (std::string_view(":-/.,+'").find(text.front()) == std::string_view::npos &&
                          std::ranges::none_of(text, is_digit));
}

/// Takes a number apart, character by character.
class Digits {
 public:
  Digits(std::string_view cell, const NumberRules& rules) : rest_(cell), rules_(rules) {}

  std::optional<NumberCell> read() {
    take_sign();
    take_digits();
    while (take_group()) {}
    take_decimals();
    take_exponent();
    number_.unit = trimmed(rest_);
    if (!may_be_unit(number_.unit) || !finish()) return std::nullopt;
    return number_;
  }

 private:
  void put(char c) {
    if (number_.length < number_.digits.size()) number_.digits[number_.length++] = c;
    else too_long_ = true;
  }

  void take_sign() {
    constexpr std::string_view minus = "\xE2\x88\x92";
    if (rest_.starts_with(minus)) return put('-'), rest_.remove_prefix(minus.size());
    if (rest_.starts_with('-')) put('-');
    if (rest_.starts_with('-') || rest_.starts_with('+')) rest_.remove_prefix(1);
  }

  std::size_t take_digits() {
    std::size_t count = 0;
    for (; count < rest_.size() && is_digit(rest_[count]); ++count) put(rest_[count]);
    rest_.remove_prefix(count);
    whole_ += count;
    return count;
  }

  /// Whether a decimal mark comes later, or a second group, which tells that this mark separates groups.
  bool groups_follow(char mark) const {
    auto later = rest_.substr(4);
    if (later.starts_with(mark)) return three_digits(later.substr(1));
    return later.starts_with(mark == '.' ? ',' : '.');
  }

  bool take_group() {
    if (whole_ == 0 || rest_.empty() || (groups_ == '\0' && whole_ > 3)) return false;
    const char mark = rest_.front();
    const bool is_mark = mark == '.' || mark == ',';
    const auto width = is_mark ? 1 : group_blank(rest_);
    if (width == 0 || !three_digits(rest_.substr(width))) return false;
    if (is_mark && mark != rules_.thousands && mark != groups_ && (mark == rules_.decimal || !groups_follow(mark)))
      return false;
    groups_ = mark;
    rest_.remove_prefix(width);
    take_digits();
    return true;
  }

  void take_decimals() {
    if (rest_.empty() || (rest_.front() != '.' && rest_.front() != ',') || rest_.front() == groups_) return;
    const bool point = rest_.front() == '.';
    const bool doubtful = groups_ == '\0' && whole_ >= 1 && whole_ <= 3 &&
                          number_.text().find_first_not_of('-') != std::string_view::npos && first_digit() != '0' &&
                          three_digits(rest_.substr(1)) && rules_.decimal != rest_.front();
    number_.separators = point ? (doubtful ? Separators::doubtful_point : Separators::point)
                               : (doubtful ? Separators::doubtful_comma : Separators::comma);
    rest_.remove_prefix(1);
    put('.');
    number_.decimals = static_cast<int>(take_digits());
  }

  char first_digit() const { return number_.digits[number_.digits[0] == '-' ? 1 : 0]; }

  void take_exponent() {
    if (whole_ == 0 || rest_.size() < 2 || (rest_[0] != 'e' && rest_[0] != 'E')) return;
    const std::size_t sign = rest_[1] == '-' || rest_[1] == '+' ? 1 : 0;
    int power = 0;
    const auto [end, error] = std::from_chars(rest_.data() + 1 + (rest_[1] == '+'), rest_.data() + rest_.size(), power);
    if (error != std::errc{} || rest_.size() <= 1 + sign) return;
    number_.decimals = std::max(0, number_.decimals - power);
    for (const char* c = rest_.data(); c != end; ++c) put(*c);
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  }

  bool finish() {
    if (whole_ == 0 || too_long_) return false;
    const auto text = number_.text();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number_.value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(number_.value);
  }

  std::string_view rest_;
  const NumberRules& rules_;
  NumberCell number_;
  std::size_t whole_ = 0;  ///< digits so far
  char groups_ = '\0';     ///< what separates groups of three
  bool too_long_ = false;
};

/// The usual cell: sign, digits, at most one decimal point, all of them taken as they are.
bool read_plainly(std::string_view cell, const NumberRules& rules, NumberCell& number) {
  if (cell.size() > number.digits.size() || rules.thousands == '.') return false;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number.value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(number.value)) return false;
  const auto point = cell.find('.');
  if (cell.find_first_of("eEinIN") != std::string_view::npos) return false;
  std::ranges::copy(cell, number.digits.begin());
  number.length = cell.size();
  number.is_plain = true;
  if (point == std::string_view::npos) return true;
  number.decimals = static_cast<int>(cell.size() - point - 1);
  const auto whole = cell.substr(cell.front() == '-' ? 1 : 0, point - (cell.front() == '-' ? 1 : 0));
  const bool doubtful =
      number.decimals == 3 && !whole.empty() && whole.size() <= 3 && whole.front() != '0' && rules.decimal != '.';
  number.separators = doubtful ? Separators::doubtful_point : Separators::point;
  return true;
}

bool is_missing_mark(std::string_view cell) {
  constexpr std::size_t longest = 8;
  if (cell.empty()) return true;
  if (cell.size() > longest || is_digit(cell.back())) return false;
  return std::ranges::count(missing_marks, lower_case(cell)) > 0;
}

}  // namespace

std::optional<NumberCell> number_cell(std::string_view cell, const NumberRules& rules) {
  if (cell.empty()) return std::nullopt;
  if (NumberCell number; read_plainly(cell, rules, number)) return number;
  return Digits(cell, rules).read();
}

CellKind read_cell(std::string_view cell, const NumberRules& rules, NumberCell& number) {
  if (is_missing_mark(cell) || std::ranges::count(rules.missing_texts, cell) > 0) return CellKind::missing;
  if (auto found = number_cell(cell, rules)) {
    number = *found;
    return std::ranges::count(rules.missing_numbers, number.value) > 0 ? CellKind::missing : CellKind::number;
  }
  return CellKind::text;
}

}  // namespace swayaw::core::detail

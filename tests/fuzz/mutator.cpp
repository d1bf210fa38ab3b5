#include "mutator.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace swayaw::fuzz {
namespace {

/// Numbers that readers and physics may stumble over.
constexpr std::array<std::string_view, 30> odd_numbers{"nan",
                                                       "NaN",
                                                       "inf",
                                                       "-inf",
                                                       "1e308",
                                                       "-1e308",
                                                       "1e309",
                                                       "5e-324",
                                                       "1e-310",
                                                       "-0.0",
                                                       "0",
                                                       "1",
                                                       "-1",
                                                       "1e-9",
                                                       "1e9",
                                                       "1e18",
                                                       "0x7f",
                                                       "1e",
                                                       ".",
                                                       "--1",
                                                       "4e999",
                                                       "2147483648",
                                                       "9223372036854775807",
                                                       "9223372036854775808",
                                                       "-9223372036854775808",
                                                       "18446744073709551616",
                                                       "1_000",
                                                       "1,5",
                                                       "+3",
                                                       "00012"};

/// Pieces that mean something to a reader.
constexpr std::array<std::string_view, 34> telling{",",
                                                   ";",
                                                   "\t",
                                                   "\n",
                                                   "\r\n",
                                                   "\r",
                                                   "\"",
                                                   "'",
                                                   "#",
                                                   "=",
                                                   "[",
                                                   "]",
                                                   "{",
                                                   "}",
                                                   "\\",
                                                   "\\u",
                                                   "\xEF\xBB\xBF",
                                                   "\xFF\xFE",
                                                   "\xC3",
                                                   "\xE2\x80\xA8",
                                                   "\x1B[2J",
                                                   "\x7F",
                                                   "*",
                                                   "$",
                                                   "!",
                                                   "\"\"\"",
                                                   "'''",
                                                   "[[a]]\n",
                                                   "a.b.c = 1\n",
                                                   "time_s",
                                                   "1970-01-01T00:00:00Z",
                                                   "\xC2\xB0",
                                                   "'N",
                                                   "%"};

class Mutator {
 public:
  Mutator(std::span<const std::string> corpus, bool is_text, unsigned seed)
      : corpus_(corpus), is_text_(is_text), random_(seed), text_(one_of_corpus()) {}

  std::string run() {
    for (auto times = 1 + below(4); times > 0; --times) damage();
    return std::move(text_);
  }

 private:
  /// From 0 to n − 1. (std::uniform_int_distribution is another one in every standard library.)
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  std::string one_of_corpus() { return corpus_[below(corpus_.size())]; }

  void damage() {
    if (!is_text_ || one_in(4)) return damage_bytes();
    switch (below(13)) {
      case 0:
      case 1:
      case 2:
      case 3: return replace_number();
      case 4: return erase_line();
      case 5: return repeat_line();
      case 6: return swap_lines();
      case 7: return change_column();
      case 8: return insert(std::string(telling[below(telling.size())]));
      case 9: return change_ends();
      case 10: return one_in(3) ? encode() : replace_number();
      case 11: return one_in(3) ? nest() : replace_number();
      default: return one_in(6) ? lengthen_line() : splice();
    }
  }

  // ---------------------------------------------------------------- bytes

  void damage_bytes() {
    if (text_.empty()) text_ = one_of_corpus();
    const auto at = below(text_.size());
    switch (below(7)) {
      case 0: text_[at] = static_cast<char>(text_[at] ^ (1 << below(8))); return;
      case 1: text_[at] = static_cast<char>(random_()); return;
      case 2: text_.erase(at, 1 + below(8)); return;
      case 3: text_.insert(at, text_.substr(below(text_.size()), below(64))); return;
      case 4: text_.resize(at); return;
      case 5: return splice();
      default: return overwrite_count(at);
    }
  }

  /// A count of a binary file becomes huge, negative or none.
  void overwrite_count(std::size_t at) {
    constexpr std::array<unsigned char, 6> bytes{0x00, 0x01, 0x7F, 0x80, 0xFE, 0xFF};
    for (std::size_t i = at; i < std::min(at + 4, text_.size()); ++i)
      text_[i] = static_cast<char>(bytes[below(bytes.size())]);
  }

  void insert(const std::string& piece) { text_.insert(below(text_.size() + 1), piece); }

  /// The front of this one and the back of another.
  void splice() {
    const auto other = one_of_corpus();
    text_ = text_.substr(0, below(text_.size() + 1)) + other.substr(below(other.size() + 1));
  }

  // ---------------------------------------------------------------- text

  static bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

  void replace_number() {
    const auto from = std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(below(text_.size() + 1)), text_.end(),
                                   [](char c) { return c >= '0' && c <= '9'; });
    if (from == text_.end()) return;
    auto begin = from;
    while (begin != text_.begin() && is_of_number(begin[-1])) --begin;
    const auto end = std::find_if_not(from, text_.end(), is_of_number);
    text_.replace(begin, end, odd_numbers[below(odd_numbers.size())]);
  }

  /// First byte of a line and of the next.
  std::pair<std::size_t, std::size_t> line() {
    const auto at = below(text_.size() + 1);
    const auto before = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    const auto end = text_.find('\n', at);
    return {before == std::string::npos ? 0 : before + 1, end == std::string::npos ? text_.size() : end + 1};
  }

  void erase_line() {
    const auto [begin, end] = line();
    text_.erase(begin, end - begin);
  }

  void repeat_line() {
    const auto [begin, end] = line();
    const auto one = text_.substr(begin, end - begin);
    for (auto times = one_in(8) ? below(200) : 1; times > 0; --times) text_.insert(begin, one);
  }

  void swap_lines() {
    const auto [begin, end] = line();
    const auto one = text_.substr(begin, end - begin);
    text_.erase(begin, end - begin);
    text_.insert(line().first, one);
  }

  /// A column is lost, or comes twice.
  void change_column() {
    constexpr std::string_view separators = ",;\t ";
    const char separator = separators[below(separators.size())];
    const auto column = below(6);
    const bool twice = one_in(2);
    std::string changed;
    for (std::size_t begin = 0; begin < text_.size();) {
      const auto end = std::min(text_.find('\n', begin), text_.size());
      changed += changed_row(std::string_view(text_).substr(begin, end - begin), separator, column, twice) + '\n';
      begin = end + 1;
    }
    text_ = std::move(changed);
  }

  static std::string changed_row(std::string_view row, char separator, std::size_t column, bool twice) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < column && begin != std::string_view::npos; ++i) {
      begin = row.find(separator, begin);
      if (begin != std::string_view::npos) ++begin;
    }
    if (begin == std::string_view::npos) return std::string(row);
    const auto end = std::min(row.find(separator, begin), row.size() - 1) + 1;
    const std::string front(row.substr(0, begin)), cell(row.substr(begin, end - begin)), back(row.substr(end));
    return twice ? front + cell + cell + back : front + back;
  }

  void change_ends() {
    std::string changed;
    const std::string_view end = std::array<std::string_view, 4>{"\r\n", "\r", "\n\n", " \n"}[below(4)];
    for (const char c : text_) c == '\n' ? changed.append(end) : changed.append(1, c);
    text_ = std::move(changed);
  }

  /// UTF-16 with or without its mark, UTF-8 with one.
  void encode() {
    if (one_in(3)) return static_cast<void>(text_.insert(0, "\xEF\xBB\xBF"));
    const bool big = one_in(2);
    std::string wide = one_in(2) ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text_) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    text_ = std::move(wide);
  }

  /// Lists, tables or keys within each other.
  void nest() {
    const auto depth = one_in(2) ? 300 : 20;
    std::string piece = "deep = ";
    const auto kind = below(3);
    if (kind == 2) piece = "a";
    for (int i = 0; i < depth; ++i) piece += kind == 0 ? "[" : kind == 1 ? "{ a = " : ".a";
    if (kind == 2) piece += " = 1";
    text_.insert(line().first, (one_in(2) ? "# " : "") + piece + "\n");
  }

  void lengthen_line() { insert(std::string(1 + below(20'000), telling[below(telling.size())][0])); }

  std::span<const std::string> corpus_;
  bool is_text_;
  std::mt19937 random_;
  std::string text_;
};

}  // namespace

std::string mutated(std::span<const std::string> corpus, bool is_text, unsigned seed) {
  return Mutator(corpus, is_text, seed).run();
}

}  // namespace swayaw::fuzz

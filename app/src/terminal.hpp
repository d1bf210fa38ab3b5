#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "swayaw/core/detail/printable.hpp"

/// What goes to a person at a terminal rather than to a file or another program. All of it goes through here, where
/// texts of others lose what a terminal would obey.
namespace swayaw::app {

/// Columns of the terminal behind stdout; 0 where there is none.
int terminal_columns();

/// The words folded at blanks so that no line is wider; further lines begin with `indent` blanks. 0 columns: as it is.
std::string folded(std::string_view words, int columns, std::size_t indent = 0);

/// A line without the blanks at its end, folded: it goes on below the last of its columns, which two blanks or more
/// part, or below its first word.
std::string fitted(std::string_view line, int columns);

/// Text to stdout, its lines fitted to the terminal.
void print_fitted(std::string_view text);

/// Text to stderr.
void print_aside(std::string_view text);

namespace detail {

/// A value as it is shown: a text, or texts joined, on one line, with nothing in it that acts.
template <class Value>
decltype(auto) shown(const Value& value) {
  if constexpr (std::is_convertible_v<const Value&, std::string_view>) return core::detail::printable(value);
  else return (value);
}

template <class Iterator, class End>
  requires std::is_convertible_v<decltype(*std::declval<Iterator>()), std::string_view> std::string shown(
      const fmt::join_view<Iterator, End, char>& texts) {
    return core::detail::printable(fmt::vformat("{}", fmt::make_format_args(texts)));
  }

template <class... Value>
std::string shown_text(fmt::string_view text, const Value&... values) {
  return fmt::vformat(text, fmt::make_format_args(shown(values)...));
}

}  // namespace detail

/// To stdout. Texts among the values stay on one line; lines end where the first text says so.
template <class... Value>
void say(fmt::format_string<Value...> text, Value&&... values) {
  print_fitted(detail::shown_text(text, values...));
}

/// The same to stderr: what is not the answer.
template <class... Value>
void say_aside(fmt::format_string<Value...> text, Value&&... values) {
  print_aside(detail::shown_text(text, values...));
}

}  // namespace swayaw::app

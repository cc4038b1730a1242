#pragma once
/// \file suggest.h
/// Words for problem messages: nearest names, quoted lists, JSON pointers.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other, letter case
/// ignored.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` was probably meant to be: the nearest by edit distance if it is near enough (a third of
/// the letters), else one that `word` is the beginning of; nothing if there is no such candidate.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `; did you mean "steel"?`, or an empty text if no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// `"a", "b" or "c"` with the given last link ("or", "and").
std::string quoted_list(const std::vector<std::string>& words, std::string_view link = "or");

/// A name as a token of a JSON pointer: "~" and "/" escaped (RFC 6901).
std::string pointer_token(std::string_view name);

} // namespace abut

#include "scene/suggest.h"

#include <algorithm>
#include <cctype>

namespace abut {

namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return lower;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    const std::string from = lower_case(a);
    const std::string to = lower_case(b);
    // Rows of the distance table: of from[0, i-2], from[0, i-1] and from[0, i] to every beginning of `to`.
    std::vector<std::size_t> before(to.size() + 1);
    std::vector<std::size_t> previous(to.size() + 1);
    std::vector<std::size_t> row(to.size() + 1);
    for (std::size_t j = 0; j <= to.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        before = previous;
        previous = row;
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[to.size()];
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    std::size_t best_distance = 0;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        const std::size_t near = std::max<std::size_t>(1, std::max(word.size(), candidate.size()) / 3);
        const bool nothing_kept = distance >= std::max(word.size(), candidate.size());
        if (distance > near || nothing_kept) continue;
        if (!best || distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    if (best || word.size() < 3) return best;
    const std::string beginning = lower_case(word);
    for (const std::string& candidate : candidates)
        if (lower_case(candidate).starts_with(beginning)) return candidate;
    return {};
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::optional<std::string> name = nearest(word, candidates);
    return name ? "; did you mean \"" + *name + "\"?" : "";
}

std::string quoted_list(const std::vector<std::string>& words, std::string_view link) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " " + std::string(link) + " " : ", ";
        text += '"' + words[i] + '"';
    }
    return text;
}

std::string pointer_token(std::string_view name) {
    std::string token;
    for (const char letter : name) {
        if (letter == '~') {
            token += "~0";
        } else if (letter == '/') {
            token += "~1";
        } else {
            token += letter;
        }
    }
    return token;
}

} // namespace abut

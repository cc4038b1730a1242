#pragma once
/// \file text_scanner.h
/// Words and numbers of a text, with the line in which they stand.

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace abut {

/// Numbers are read the same in every locale. Lines end with LF, CR LF or CR.
class TextScanner {
public:
    /// \param comment begins a comment that ends with its line; 0: there are none
    explicit TextScanner(std::string_view text, char comment = 0) : text_(text), comment_(comment) {}

    int line() const { return line_; }
    std::size_t position() const { return position_; }
    std::size_t left() const { return text_.size() - position_; }

    /// The next word of this line, empty at its end.
    std::string_view word_of_line() {
        while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
        if (comment_ != 0 && position_ < text_.size() && text_[position_] == comment_)
            while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
        const std::size_t begin = position_;
        while (position_ < text_.size() && !is_blank(text_[position_]) && !is_line_end(text_[position_])) ++position_;
        return text_.substr(begin, position_ - begin);
    }

    /// Moves to the next line. False at the end of the text.
    bool next_line() {
        while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
        if (position_ == text_.size()) return false;
        const bool two = text_[position_] == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
        position_ += two ? 2 : 1;
        ++line_;
        return position_ < text_.size();
    }

    /// The next word of this or a later line, empty at the end of the text.
    std::string_view word() {
        for (;;) {
            const std::string_view found = word_of_line();
            if (!found.empty() || !next_line()) return found;
        }
    }

    double number() { return to_number(required(word())); }
    double number_of_line() { return to_number(required(word_of_line())); }
    long long integer() { return to_integer(required(word())); }
    long long integer_of_line() { return to_integer(required(word_of_line())); }

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(fmt::format("line {}: {}", line_, what));
    }

    /// What a message may show of a word.
    static std::string shown(std::string_view word) {
        std::string text;
        for (const char c : word.substr(0, 24)) text += c >= ' ' && c < 127 ? c : '?';
        return word.size() > 24 ? text + "…" : text;
    }

    double to_number(std::string_view word) const {
        double value = 0;
        const auto [end, error] = std::from_chars(unsigned_begin(word), word.data() + word.size(), value);
        if (error == std::errc::result_out_of_range) return out_of_range(word);
        if (error != std::errc() || end != word.data() + word.size())
            fail(fmt::format("\"{}\" is not a number", shown(word)));
        return value;
    }
    long long to_integer(std::string_view word) const {
        long long value = 0;
        const auto [end, error] = std::from_chars(unsigned_begin(word), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            fail(fmt::format("\"{}\" is not a whole number", shown(word)));
        return value;
    }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

    /// from_chars knows no plus.
    static const char* unsigned_begin(std::string_view word) {
        return word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
    }
    /// Too small is as good as 0; too large is infinite, which the checks of a surface report.
    static double out_of_range(std::string_view word) {
        const bool small = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
        return small ? 0 : std::numeric_limits<double>::infinity();
    }
    std::string_view required(std::string_view word) const {
        if (!word.empty()) return word;
        if (position_ == text_.size()) fail("the file ends here, in the middle: it seems to be cut off");
        fail("a number is missing");
    }

    std::string_view text_;
    std::size_t position_ = 0;
    int line_ = 1;
    char comment_;
};

} // namespace abut

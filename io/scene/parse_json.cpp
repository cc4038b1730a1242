#include "io/scene/parse_json.h"

#include "scene/suggest.h"

#include <algorithm>
#include <deque>
#include <utility>

#include <fmt/format.h>

namespace abut {

namespace {

/// Builds a value from the parser's events. (nlohmann's own builder keeps the last of repeated keys without a word.)
class Builder {
public:
    explicit Builder(std::string_view text) : text_(text) {}

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(Json::number_integer_t value) { return put(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return put(value); }
    bool number_float(Json::number_float_t value, const std::string&) { return put(value); }
    bool string(std::string& value) { return put(std::move(value)); }
    bool binary(Json::binary_t&) { return false; } // not in JSON text
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        Frame& frame = open_.back();
        frame.key = name;
        if (frame.container->contains(name)) {
            problems.push_back({pointer(), "this key is given twice"});
            frame.slot = &discarded_.emplace_back();
        } else {
            frame.slot = &(*frame.container)[name];
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
        // The error lies at the last character read; a line break that was read belongs to the line it ends.
        const std::string_view before = text_.substr(0, std::min(position > 0 ? position - 1 : 0, text_.size()));
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const std::size_t line_break = before.rfind('\n');
        const std::size_t column = before.size() - (line_break == std::string_view::npos ? 0 : line_break + 1) + 1;
        problems.push_back(
            {"", fmt::format("syntax error at line {}, column {}: {}", line, column, reason(error.what()))});
        return false;
    }

    Json root;
    std::vector<Problem> problems;

private:
    struct Frame {
        Json* container;
        std::string key{};
        Json* slot = nullptr; ///< where an object's next value goes
    };

    template <class Value>
    bool put(Value&& value) {
        slot() = std::forward<Value>(value);
        return true;
    }

    // A container does not change while one inside it is open, so the pointers stay good.
    bool open(Json container) {
        Json& place = slot();
        place = std::move(container);
        open_.push_back({&place});
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    Json& slot() {
        if (open_.empty()) return root;
        Frame& frame = open_.back();
        if (!frame.container->is_array()) return *frame.slot;
        frame.container->push_back(nullptr);
        return frame.container->back();
    }

    std::string pointer() const {
        std::string path;
        for (const Frame& frame : open_) {
            path += frame.container->is_array() ? fmt::format("/{}", frame.container->size() - 1)
                                                : "/" + pointer_token(frame.key);
        }
        return path;
    }

    /// nlohmann's message without its own name, number and position.
    static std::string reason(std::string_view message) {
        for (const std::string_view head : {"syntax error ", "] "}) {
            const std::size_t at = message.find(head);
            if (at != std::string_view::npos) return std::string(message.substr(at + head.size()));
        }
        return std::string(message);
    }

    std::string_view text_;
    std::vector<Frame> open_;
    std::deque<Json> discarded_; ///< values of repeated keys
};

} // namespace

ParsedJson parse_json(std::string_view text) {
    constexpr bool whole_text = true;
    constexpr bool ignore_comments = true;
    Builder builder(text);
    const bool parsed = Json::sax_parse(text, &builder, Json::input_format_t::json, whole_text, ignore_comments);
    if (!parsed) return {{}, std::move(builder.problems)};
    return {std::move(builder.root), std::move(builder.problems)};
}

} // namespace abut

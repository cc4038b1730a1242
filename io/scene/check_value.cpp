#include "io/scene/check.h"

#include "io/scene/check_parts.h"
#include "scene/suggest.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace abut {

namespace {

using Value = CheckedValue;

std::string hint(const Key& key) {
    return key.hint.empty() ? "" : "; " + key.hint;
}

bool is_later_word(const Json& json, const Key& key) {
    if (!json.is_string()) return false;
    for (const std::string& word : key.later_words)
        if (json == word) return true;
    return false;
}

std::optional<Json> in_range(double number, const Value& value, const std::string& unit) {
    if (contains(value.key.range, number)) return Json(number);
    const std::string given = value.json.is_string() ? value.json.get<std::string>() : value.json.dump();
    return value.wrong(fmt::format("must be {}, not {}{}", in_words(value.key.range, unit), given, hint(value.key)));
}

std::optional<Json> integer(const Value& value) {
    const double number = value.json.is_number() ? value.json.get<double>() : 0.5;
    if (number != std::floor(number)) return value.wrong_type("a whole number");
    if (!in_range(number, value, "")) return {};
    if (std::abs(number) > std::numeric_limits<int>::max()) return value.wrong("too large a whole number");
    return Json(static_cast<int>(number));
}

std::optional<Json> word(const Value& value) {
    const Key& key = value.key;
    if (!value.json.is_string()) return value.wrong_type(quoted_list(key.words));
    if (is_later_word(value.json, key)) {
        return value.wrong(fmt::format("{} is not available in this version of abut; available: {}", value.json.dump(),
                                       quoted_list(key.words, "and")));
    }
    const auto text = value.json.get<std::string>();
    for (const std::string& allowed : key.words)
        if (text == allowed) return value.json;
    std::vector<std::string> known = key.words;
    known.insert(known.end(), key.later_words.begin(), key.later_words.end());
    return value.wrong(fmt::format("unknown word \"{}\"{}; allowed: {}{}", text, did_you_mean(text, known),
                                   quoted_list(key.words, "and"), hint(key)));
}

std::optional<Json> text(const Value& value) {
    if (!value.json.is_string()) return value.wrong_type("a text");
    if (value.key.kind != Kind::text && value.json.get_ref<const std::string&>().empty())
        return value.wrong("must not be empty");
    return value.json;
}

std::optional<Json> colour(const Value& value) {
    const std::string text = value.json.is_string() ? value.json.get<std::string>() : "";
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return value.wrong_type("a colour as \"#rrggbb\" (hexadecimal)");
    return value.json;
}

} // namespace

std::nullopt_t CheckedValue::wrong(const std::string& message) const {
    checking.problems.push_back({pointer, message});
    return std::nullopt;
}

std::nullopt_t CheckedValue::wrong_type(const std::string& needed) const {
    return wrong(fmt::format("{} is needed, not {}", needed, in_words(json)));
}

std::optional<Json> check_quantity(const CheckedValue& value) {
    const Dimension& dimension = value.key.dimension;
    if (value.json.is_number()) return in_range(value.json.get<double>(), value, unit_of(dimension));
    if (dimension == dimensions::none) return value.wrong_type("a number without unit");
    if (!value.json.is_string())
        return value.wrong_type(
            fmt::format("{} (a number in {} or a text with a unit)", name_of(dimension), unit_of(dimension)));
    try {
        return in_range(parse_quantity(value.json.get<std::string>(), dimension), value, unit_of(dimension));
    } catch (const UnitError& error) {
        std::string message = error.what();
        if (message.find(" needed") == std::string::npos)
            message += fmt::format("; {} ({}) is needed", name_of(dimension), unit_of(dimension));
        return value.wrong(message);
    }
}

std::optional<Json> check_value(const Json& json, const Key& key, const std::string& pointer, Checking& checking) {
    const Value value{json, key, pointer, checking};
    switch (key.kind) {
    case Kind::quantity:
        return check_quantity(value);
    case Kind::vector:
        return check_vector(value);
    case Kind::per_axis:
        return json.is_array() ? check_vector(value) : check_quantity(value);
    case Kind::spin:
        return check_spin(value);
    case Kind::points:
        return check_points(value);
    case Kind::outlines:
        return check_outlines(value);
    case Kind::matrix:
        return check_matrix(value);
    case Kind::function:
        return check_function(value);
    case Kind::functions:
        return check_functions(value);
    case Kind::number:
        if (!json.is_number()) return value.wrong_type("a number without unit");
        return in_range(json.get<double>(), value, "");
    case Kind::integer:
        return integer(value);
    case Kind::boolean:
        if (!json.is_boolean()) return value.wrong_type("true or false");
        return json;
    case Kind::text:
    case Kind::name:
    case Kind::file:
        return text(value);
    case Kind::word:
        return word(value);
    case Kind::colour:
        return colour(value);
    case Kind::any:
        return json;
    case Kind::later:
        return value.wrong("not available in this version of abut; leave this key out");
    case Kind::object:
    case Kind::list:
    case Kind::map:
        break; // they have keys below them
    }
    return {};
}

std::string in_words(const Json& value) {
    if (value.is_string()) return "the text " + value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (value.is_array()) return "a list";
    if (value.is_object()) return "an object";
    return value.dump();
}

std::string in_words(const Range& range, const std::string& unit) {
    const std::string suffix = unit.empty() || unit == "1" ? "" : " " + unit;
    if (range.minimum && range.maximum) {
        std::string excluded;
        if (range.minimum_excluded && range.maximum_excluded) {
            excluded = " (both excluded)";
        } else if (range.minimum_excluded || range.maximum_excluded) {
            excluded = fmt::format(" ({} excluded)", range.minimum_excluded ? *range.minimum : *range.maximum);
        }
        return fmt::format("between {} and {}{}{}", *range.minimum, *range.maximum, suffix, excluded);
    }
    if (range.minimum)
        return fmt::format("{} {}{}", range.minimum_excluded ? "greater than" : "at least", *range.minimum, suffix);
    if (range.maximum)
        return fmt::format("{} {}{}", range.maximum_excluded ? "less than" : "at most", *range.maximum, suffix);
    return "any number";
}

bool contains(const Range& range, double value) {
    if (!std::isfinite(value)) return false;
    if (range.minimum && (range.minimum_excluded ? value <= *range.minimum : value < *range.minimum)) return false;
    return !(range.maximum && (range.maximum_excluded ? value >= *range.maximum : value > *range.maximum));
}

} // namespace abut

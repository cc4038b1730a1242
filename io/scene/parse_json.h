#pragma once
#include "io/scene/json.h"
#include "scene/problem.h"

#include <optional>
#include <string_view>
#include <vector>

namespace abut {

/// What became of a text: no value after a syntax error; else the value, with a problem for each repeated key (the
/// first one counts).
struct ParsedJson {
    std::optional<Json> value;
    std::vector<Problem> problems;
};

/// Parses JSON with // and /* */ comments.
ParsedJson parse_json(std::string_view text);

} // namespace abut

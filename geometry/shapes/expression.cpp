#include "geometry/shapes/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <array>
#include <limits>
#include <numbers>
#include <regex>
#include <stdexcept>

namespace abut {

struct Expression::Parser {
    std::array<double, 3> variables{};
    mu::Parser parser;
};

Expression::Expression(const std::string& text) : parser_(std::make_unique<Parser>()) {
    try {
        mu::Parser& parser = parser_->parser;
        parser.ResetLocale(); // "." whatever the user's language
        parser.EnableOptimizer(true);
        parser.DefineVar("x", parser_->variables.data());
        parser.DefineVar("y", &parser_->variables[1]);
        parser.DefineVar("z", &parser_->variables[2]);
        parser.DefineConst("pi", std::numbers::pi);
        parser.DefineConst("e", std::numbers::e);
        parser.SetExpr(text);
        parser.Eval();
        if (parser.GetNumResults() != 1)
            throw std::runtime_error(
                fmt::format("\"{}\": there are {} expressions, separated by commas", text, parser.GetNumResults()));
        if (parser.GetUsedVar().empty())
            throw std::runtime_error(fmt::format("\"{}\": x, y and z don't occur, so it is the same everywhere", text));
    } catch (const mu::Parser::exception_type& error) {
        // Its messages count characters from 0.
        const std::string what =
            std::regex_replace(error.GetMsg(), std::regex(R"(( found)?( at)? position \d+|\.$)"), std::string());
        const auto position = static_cast<long long>(error.GetPos());
        std::string where = position < 0 ? "" : fmt::format(", character {}", position + 1);
        if (position >= static_cast<long long>(text.size())) where = ", at its end";
        throw std::runtime_error(fmt::format("\"{}\"{}: {}", text, where, what));
    }
}

Expression::~Expression() = default;

double Expression::operator()(double x, double y, double z) const {
    parser_->variables = {x, y, z};
    try {
        return parser_->parser.Eval();
    } catch (const mu::Parser::exception_type&) { // domain errors, in builds of muParser that have them
        return std::numeric_limits<double>::quiet_NaN();
    }
}

} // namespace abut

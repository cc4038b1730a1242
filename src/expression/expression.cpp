#include "expression/expression.h"

#include "scene/suggest.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <regex>
#include <stdexcept>

namespace abut {

struct Expression::Parser {
    std::vector<double> values;
    mu::Parser parser;
};

namespace {

constexpr const char* name_characters = "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

double norm(const double* values, int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += values[i] * values[i];
    return std::sqrt(sum);
}

std::vector<std::string> known_names(const mu::Parser& parser) {
    std::vector<std::string> names;
    for (const auto& variable : parser.GetVar()) names.push_back(variable.first);
    for (const auto& constant : parser.GetConst()) names.push_back(constant.first);
    for (const auto& function : parser.GetFunDef()) names.push_back(function.first);
    return names;
}

/// A parser's complaint in our words; its messages count characters from 0.
std::string complaint(const std::string& text, const mu::Parser::exception_type& error, const mu::Parser& parser) {
    const auto position = static_cast<long long>(error.GetPos());
    std::string where = position < 0 ? "" : fmt::format(", character {}", position + 1);
    if (position >= static_cast<long long>(text.size())) where = ", at its end";
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) {
        std::string name = error.GetToken();
        while (!name.empty() && std::isspace(static_cast<unsigned char>(name.back()))) name.pop_back();
        return fmt::format("\"{}\"{}: unknown name \"{}\"{}", text, where, name,
                           did_you_mean(name, known_names(parser)));
    }
    const std::string what =
        std::regex_replace(error.GetMsg(), std::regex(R"(( found)?( at)? position \d+|\.$)"), std::string());
    return fmt::format("\"{}\"{}: {}", text, where, what);
}

} // namespace

Expression::Expression(const std::string& text, const std::vector<std::string>& variables,
                       const std::vector<Constant>& constants)
    : parser_(std::make_unique<Parser>()) {
    parser_->values.assign(variables.size(), 1.0);
    mu::Parser& parser = parser_->parser;
    try {
        parser.ResetLocale(); // "." whatever the user's language
        parser.EnableOptimizer(true);
        parser.DefineNameChars(name_characters);
        parser.DefineFun("norm", norm);
        parser.ClearConst();
        const auto taken = [&](const std::string& name) { return parser.GetConst().contains(name); };
        for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &parser_->values[i]);
        for (const auto& [name, value] : constants)
            if (!parser.GetVar().contains(name)) parser.DefineConst(name, value);
        for (const auto& [name, value] : {Constant{"pi", std::numbers::pi}, Constant{"e", std::numbers::e}})
            if (!parser.GetVar().contains(name) && !taken(name)) parser.DefineConst(name, value);
        parser.SetExpr(text);
        parser.Eval();
        if (parser.GetNumResults() != 1)
            throw std::runtime_error(
                fmt::format("\"{}\": there are {} expressions, separated by commas", text, parser.GetNumResults()));
        const auto& found = parser.GetUsedVar();
        for (std::size_t i = 0; i < variables.size(); ++i)
            if (found.contains(variables[i])) used_.push_back(i);
    } catch (const mu::Parser::exception_type& error) {
        throw std::runtime_error(complaint(text, error, parser));
    }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(std::span<const double> values) const {
    std::copy(values.begin(), values.end(), parser_->values.begin());
    try {
        return parser_->parser.Eval();
    } catch (const mu::Parser::exception_type&) { // domain errors, in builds of muParser that have them
        return std::numeric_limits<double>::quiet_NaN();
    }
}

std::string expression_name(const std::string& name) {
    std::string result;
    for (const char c : name) result += std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' ? c : '_';
    if (result.empty() || result[0] == '.' || std::isdigit(static_cast<unsigned char>(result[0])))
        result.insert(0, "_");
    return result;
}

} // namespace abut

#pragma once
/// \file expression.h
/// Expressions as text, evaluated by muParser: `1 - total_energy/first_total_energy`.

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace abut {

/// A named number.
struct Constant {
    std::string name;
    double value = 0;
};

/// An expression in named variables. It may use + - * / ^, comparisons, `c ? a : b`, muParser's functions (sin, sqrt,
/// exp, abs, min, max ...), norm(a, b, ...), the root of the sum of squares, and the constants pi and e. A variable or
/// constant of the caller hides pi and e of that name.
/// Not for several threads at once.
class Expression {
public:
    /// \param variables names in the order in which values are handed over; see expression_name()
    /// \throws std::runtime_error when the text is no expression in these names; says where, and offers the nearest
    /// name
    explicit Expression(const std::string& text, const std::vector<std::string>& variables,
                        const std::vector<Constant>& constants = {});
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    /// \param values one a variable, in their order. \return infinite or NaN where the expression is
    double operator()(std::span<const double> values) const;

    /// Numbers of the variables that the expression uses, ascending.
    const std::vector<std::size_t>& used() const { return used_; }

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::vector<std::size_t> used_;
};

/// A name as expressions can have it: letters, digits, "_" and "." stay, all else becomes "_"; a leading digit or dot
/// gets a "_" before it.
std::string expression_name(const std::string& name);

} // namespace abut

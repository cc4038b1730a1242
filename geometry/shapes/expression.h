#pragma once
/// \file expression.h
/// Expressions in x, y, z as text (muParser).

#include <memory>
#include <string>

namespace abut {

/// Not for several threads at once.
class Expression {
public:
    /// \throws std::runtime_error when the text is no expression in x, y, z or uses none of them; says where
    explicit Expression(const std::string& text);
    ~Expression();
    Expression(const Expression&) = delete;
    Expression& operator=(const Expression&) = delete;

    /// Infinite or NaN where the expression is.
    double operator()(double x, double y, double z) const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace abut

#pragma once
#include <cstddef>
#include <cstdint>

/// What writing and reading of checkpoints have in common.
namespace abut::checkpoint {

/// Of the file's arrays: their names, extents and meanings.
constexpr std::int64_t version = 1;

/// Reals that make up an element: a vector, a matrix (column by column, as it lies in memory) or a struct of sums.
template <class Element>
constexpr std::size_t width = sizeof(Element) / sizeof(double);

} // namespace abut::checkpoint

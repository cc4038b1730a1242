#pragma once
#include "math/linear_algebra.h"

#include <cstring>
#include <vector>

namespace abut {

/// Some doubles, for sums over the points of a cloud. (Eight of them are slower: g++ 12 takes comparisons apart.)
using Wide = double __attribute__((vector_size(32)));
inline constexpr int lanes = 4;

/// The particles that a contact node sees, as the regression wants them: positions relative to the node in cells, and
/// classes c = -1 (body a) or +1 (body b) (contact paper §3.1). Filled up to a multiple of `lanes` with points of
/// weight 0.
template <int D>
struct Cloud {
    int size = 0;
    int size_b = 0;    ///< of them of class +1
    double spread = 0; ///< variance of a position within a particle's domain, per axis [cells²]
    std::vector<double> x[D];
    std::vector<double> c;
    std::vector<double> weight;

    void clear() { size = size_b = 0; }
    void add(const Vec<D>& position, double point_class) {
        if (size % lanes == 0) open();
        for (int a = 0; a < D; ++a) x[a][size] = position[a];
        c[size] = point_class;
        weight[size] = 1;
        ++size;
        size_b += point_class > 0;
    }
    int blocks() const { return (size + lanes - 1) / lanes; }
    /// The q-th `lanes` entries of one of the arrays.
    static Wide block(const std::vector<double>& values, int q) {
        Wide result;
        std::memcpy(&result, values.data() + std::ptrdiff_t{lanes} * q, sizeof result);
        return result;
    }

private:
    /// Room for the next `lanes` points, of weight 0 until they are added. Keeps what room it has from point to point.
    void open() {
        const auto begin = static_cast<std::size_t>(size);
        const auto fresh = [&](std::vector<double>& values) {
            if (values.size() < begin + lanes) values.resize(begin + lanes);
            std::fill_n(values.begin() + size, lanes, 0.0);
        };
        for (auto& axis : x) fresh(axis);
        fresh(c);
        fresh(weight);
    }
};

} // namespace abut

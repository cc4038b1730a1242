#pragma once
#include "math/linear_algebra.h"

#include <vector>

namespace abut {

/// The particles that a contact node sees, as the regression wants them: positions relative to the node in cells, and
/// classes c = -1 (body a) or +1 (body b) (contact paper §3.1). Filled up to a multiple of 4 with points of weight 0.
template <int D>
struct Cloud {
    int size = 0;
    int size_b = 0;    ///< of them of class +1
    double spread = 0; ///< variance of a position within a particle's domain, per axis [cells²]
    std::vector<Pack> x[D];
    std::vector<Pack> c;
    std::vector<Pack> weight;

    void clear() {
        size = size_b = 0;
        for (auto& axis : x) axis.clear();
        c.clear();
        weight.clear();
    }
    void add(const Vec<D>& position, double point_class) {
        const int lane = size % 4;
        if (lane == 0) {
            for (auto& axis : x) axis.push_back(Pack{});
            c.push_back(Pack{});
            weight.push_back(Pack{});
        }
        for (int a = 0; a < D; ++a) x[a].back()[lane] = position[a];
        c.back()[lane] = point_class;
        weight.back()[lane] = 1;
        ++size;
        size_b += point_class > 0;
    }
};

} // namespace abut

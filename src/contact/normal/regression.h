#pragma once
#include "contact/cloud.h"

namespace abut {

/// A plane between the two classes of a cloud.
template <int D>
struct Regression {
    Vec<D> normal = Vec<D>::Zero(); ///< unit, from class -1 to class +1; zero if the cloud gives none
    int iterations = 0;
    bool found = false;
};

} // namespace abut

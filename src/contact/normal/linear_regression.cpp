#include "contact/normal/linear_regression.h"

#include "contact/normal/regress.h"

namespace abut {

template <int D>
Regression<D> linear_regression(const Cloud<D>& cloud) {
    Regression<D> result;
    double phi[D + 1] = {};
    first_iterate(cloud, phi, result);
    return result;
}

template Regression<2> linear_regression<2>(const Cloud<2>&);
template Regression<3> linear_regression<3>(const Cloud<3>&);

} // namespace abut

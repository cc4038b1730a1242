#include "contact/normal/logistic_regression.h"

#include "contact/normal/regress.h"

namespace abut {

namespace {

/// Least squares with the scaled logistic function f = 2/(1 + e^−z) − 1 = tanh(z/2), z = x·φ (contact paper Eq. 20), of
/// derivative ψ = (1 − f²)/2 (Eq. 53): JᵀWJ = Σ w ψ² x xᵀ (Eq. 54), JᵀW (c − f) = Σ w ψ (c − f) x (Eq. 56).
struct LogisticTerms {
    static Terms at(Wide z, Wide c) {
        const Logistic s = logistic(z);
        return {s.psi * s.psi, s.psi * (c - s.f)};
    }
};

} // namespace

template <int D>
Regression<D> logistic_regression(const Cloud<D>& cloud) {
    return regress<D, LogisticTerms>(cloud);
}

template Regression<2> logistic_regression<2>(const Cloud<2>&);
template Regression<3> logistic_regression<3>(const Cloud<3>&);

} // namespace abut

#include "contact/normal/irls_regression.h"

#include "contact/normal/regress.h"

namespace abut {

namespace {

/// The Newton step of the likelihood, H = Σ φ x xᵀ + Λ and −∇Ω = Σ (m − f) x − Λφ (notes 3.37-3.42), in the scaled
/// logistic function of classes c = 2m − 1: the notes' f is (1 + f)/2, so m − f is (c − f)/2, and f (1 − f) is ψ/2.
struct IrlsTerms {
    static Terms at(Wide z, Wide c) {
        const Logistic s = logistic(z);
        return {0.5 * s.psi, 0.5 * (c - s.f)};
    }
};

} // namespace

template <int D>
Regression<D> irls_regression(const Cloud<D>& cloud) {
    return regress<D, IrlsTerms>(cloud);
}

template Regression<2> irls_regression<2>(const Cloud<2>&);
template Regression<3> irls_regression<3>(const Cloud<3>&);

} // namespace abut

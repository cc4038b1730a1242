#pragma once
/// Clouds for the tests of regressions, and the regressions in plain dense algebra.

#include "support.h"

#include "contact/normal/irls_regression.h"
#include "contact/normal/linear_regression.h"
#include "contact/normal/logistic_regression.h"

#include <Eigen/Dense>

namespace test {

template <int D>
struct Method {
    const char* name;
    Regression<D> (*solve)(const Cloud<D>&);
};
template <int D>
inline constexpr std::array regressions{Method<D>{"logistic", logistic_regression<D>},
                                        Method<D>{"linear", linear_regression<D>},
                                        Method<D>{"irls", irls_regression<D>}};

template <int D>
Vec<D> place(const Cloud<D>& cloud, int p) {
    Vec<D> x;
    for (int a = 0; a < D; ++a) x[a] = cloud.x[a][p];
    return x;
}
template <int D>
double class_of(const Cloud<D>& cloud, int p) {
    return cloud.c[p];
}

template <int D>
struct Point {
    Vec<D> x;
    double c;
};
template <int D>
Cloud<D> cloud_of(const std::vector<Point<D>>& points, double spread) {
    Cloud<D> cloud;
    cloud.spread = spread;
    for (const Point<D>& point : points) cloud.add(point.x, point.c);
    return cloud;
}
/// The same points, each changed.
template <int D>
Cloud<D> changed(const Cloud<D>& cloud, const std::function<Point<D>(Point<D>)>& change) {
    std::vector<Point<D>> points;
    for (int p = 0; p < cloud.size; ++p) points.push_back(change({place(cloud, p), class_of(cloud, p)}));
    return cloud_of(points, cloud.spread);
}

/// Points of two classes on both sides of a plane, at least `gap`/2 from it.
template <int D>
Cloud<D> separable(std::mt19937& random, int n, const Vec<D>& normal, double gap) {
    std::uniform_real_distribution<double> in(-1.2, 1.2);
    Cloud<D> cloud;
    cloud.spread = 0.25 * 0.25 / 3;
    for (int p = 0; p < n; ++p) {
        const double side = p % 2 ? 1 : -1;
        Vec<D> x;
        do
            for (int a = 0; a < D; ++a) x[a] = in(random);
        while (side * x.dot(normal) < gap / 2);
        cloud.add(x, side);
    }
    return cloud;
}

/// Points of both classes anywhere.
template <int D>
Cloud<D> mixed(std::mt19937& random, int n) {
    std::uniform_real_distribution<double> in(-1, 1);
    std::bernoulli_distribution coin;
    Cloud<D> cloud;
    cloud.spread = 0.02;
    for (int p = 0; p < n; ++p) {
        Vec<D> x;
        for (int a = 0; a < D; ++a) x[a] = in(random);
        cloud.add(x, p < 2 ? 2 * p - 1 : coin(random) ? 1 : -1);
    }
    return cloud;
}

template <int D>
Vec<D> random_direction(std::mt19937& random) {
    std::normal_distribution<double> in;
    Vec<D> n;
    for (int a = 0; a < D; ++a) n[a] = in(random);
    return n.normalized();
}

/// Derivatives of a regression's error at z = x·φ: what a point adds to matrix and vector.
struct PlainTerms {
    double matrix, vector;
};
/// Contact paper Eq. 53-56 with f of Eq. (20).
inline PlainTerms plain_logistic(double z, double c) {
    const double e = std::exp(-z);
    const double f = 2 / (1 + e) - 1;
    const double psi = 2 * e / ((1 + e) * (1 + e));
    return {psi * psi, psi * (c - f)};
}
/// Notes 3.37-3.42 with f of 3.35 and classes m = 0 and 1.
inline PlainTerms plain_irls(double z, double c) {
    const double f = 1 / (1 + std::exp(-z));
    const double m = c < 0 ? 0 : 1;
    return {f * (1 - f), m - f};
}

/// A regression in plain dense algebra, with the damping that the comment of iterate() describes.
template <int D>
Regression<D> scalar_twin(const Cloud<D>& cloud, PlainTerms (*terms)(double, double), int most_iterations) {
    constexpr int N = D + 1;
    Eigen::Matrix<double, N, 1> phi = Eigen::Matrix<double, N, 1>::Zero();
    Regression<D> result;
    while (result.iterations < most_iterations) {
        Eigen::Matrix<double, N, N> A = Eigen::Matrix<double, N, N>::Zero();
        Eigen::Matrix<double, N, 1> b = Eigen::Matrix<double, N, 1>::Zero();
        for (int p = 0; p < cloud.size; ++p) {
            Eigen::Matrix<double, N, 1> x;
            x << place(cloud, p), 1;
            const PlainTerms t = terms(x.dot(phi), class_of(cloud, p));
            A += t.matrix * x * x.transpose();
            b += t.vector * x;
        }
        const double damping = cloud.spread * A(D, D);
        for (int a = 0; a < D; ++a) {
            A(a, a) += 1e-7 + damping;
            b[a] -= 1e-7 * phi[a];
        }
        phi += A.ldlt().solve(b);
        const Vec<D> previous = result.normal;
        result.normal = phi.template head<D>().normalized();
        if (result.iterations++ > 1 && 1 - result.normal.dot(previous) < 1e-5) break;
    }
    result.found = true;
    return result;
}

} // namespace test

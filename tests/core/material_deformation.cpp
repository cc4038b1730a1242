/// Exponentials and products of matrices.

#include "material/deformation.h"

#include "support.h"

#include <Eigen/Dense>

namespace {

using namespace test;

template <int D>
using Long = Eigen::Matrix<long double, D, D>;

/// Taylor series in long double after halving until the norm is small, then squaring.
template <int D>
Mat<D> exponential_oracle(const Mat<D>& A) {
    int halvings = 0;
    for (double norm = A.norm(); norm > 0.1; norm /= 2) ++halvings;
    const Long<D> small = A.template cast<long double>() * std::pow(0.5L, halvings);
    Long<D> sum = Long<D>::Identity();
    Long<D> term = Long<D>::Identity();
    for (int k = 1; k < 20; ++k) {
        term = (term * small / static_cast<long double>(k)).eval();
        sum += term;
    }
    for (int i = 0; i < halvings; ++i) sum = (sum * sum).eval();
    return sum.template cast<double>();
}

template <int D>
Mat<D> random_matrix(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> in(-size, size);
    Mat<D> A;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) A(i, j) = in(random);
    return A;
}

template <int D>
void check_exponential(double largest) {
    std::mt19937 random(5);
    double worst = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Mat<D> A = random_matrix<D>(random, largest * std::pow(10.0, -7 + 7.0 * (trial % 100) / 99));
        const Mat<D> oracle = exponential_oracle<D>(A);
        // The result's error is at best that of A times its condition, the norm of A.
        const double error = (exponential(A) - oracle).norm() / ((1 + A.norm()) * oracle.norm());
        worst = std::max(worst, error);
        EXPECT_LT(error, 1e-14) << A;
        // det by its rounding error, that of the products of entries.
        EXPECT_NEAR(exponential(A).determinant() / std::exp(A.trace()), 1,
                    2e-14 * std::pow(oracle.norm(), D) / std::exp(A.trace()) * (1 + A.norm()));
    }
    std::printf("[ figures  ] exp of %dx%d matrices up to %g: relative error %.1e\n", D, D, largest, worst);
}

TEST(Exponential, IsTheSeries) {
    check_exponential<2>(10);
    check_exponential<3>(10);
    // Equal eigenvalues that the matrix is not a multiple of, and the seam between series and closed form.
    for (const double s : {0.0, 0.25, -0.25, 0.2499999999, 0.2500000001, -0.2499999999, -0.2500000001}) {
        Mat<2> A;
        A << 0.3, s, 1, 0.3;
        EXPECT_LT((exponential(A) - exponential_oracle<2>(A)).norm(), 1e-15 * 8) << s;
    }
}

TEST(Exponential, OfASymmetricMatrixIsThatOfItsEigenvalues) {
    std::mt19937 random(6);
    for (int trial = 0; trial < 300; ++trial) {
        Mat<3> A = random_matrix<3>(random, trial % 2 ? 0.1 : 3);
        A = (0.5 * (A + A.transpose())).eval();
        const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(A);
        const Mat<3> oracle = solver.eigenvectors() * solver.eigenvalues().array().exp().matrix().asDiagonal() *
                              solver.eigenvectors().transpose();
        EXPECT_LT((exponential(A) - oracle).norm(), 3e-14 * oracle.norm());
    }
}

TEST(Exponential, OfASpinIsARotation) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        Mat<3> W = random_matrix<3>(random, trial % 2 ? 0.01 : 20);
        W = (W - W.transpose()).eval();
        const Mat<3> Q = exponential(W);
        EXPECT_LT((Q * Q.transpose() - Mat<3>::Identity()).norm(), 1e-13 * (1 + W.norm()));
        EXPECT_NEAR(Q.determinant(), 1, 1e-13 * (1 + W.norm()));
        const Vec<3> axis(W(2, 1), W(0, 2), W(1, 0));
        const Mat<3> rodrigues = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
        EXPECT_LT((Q - rodrigues).norm(), 1e-14 * (1 + W.norm()) * 10);
    }
}

TEST(Exponential, InSpaceOfAPlaneMatrixIsThatInThePlane) {
    std::mt19937 random(8);
    for (int trial = 0; trial < 300; ++trial) {
        const Mat<2> A = random_matrix<2>(random, trial % 2 ? 0.01 : 2);
        Mat<3> B = Mat<3>::Zero();
        B.topLeftCorner<2, 2>() = A;
        const Mat<3> e = exponential(B);
        EXPECT_LT((e.topLeftCorner<2, 2>() - exponential(A)).norm(), 1e-14 * e.norm() * (1 + A.norm()));
        EXPECT_NEAR(e(2, 2), 1, 1e-14 * e.norm() * (1 + A.norm()));
        EXPECT_LT(std::abs(e(0, 2)) + std::abs(e(2, 1)), 1e-14);
    }
}

/// A velocity gradient's whole step equals many parts of it, and large ones keep volume positive.
TEST(Exponential, KeepsParticlesFromTurningInsideOut) {
    Mat<3> A = -50 * Mat<3>::Identity();
    A(0, 1) = 30;
    EXPECT_GT(exponential(A).determinant(), 0);
    EXPECT_NEAR(std::log(exponential(A).determinant()), -150, 1e-9);
}

TEST(Product, IsTheMatrixProduct) {
    std::mt19937 random(9);
    for (int trial = 0; trial < 100; ++trial) {
        const Mat<2> A = random_matrix<2>(random, 1), B = random_matrix<2>(random, 1);
        const Mat<3> C = random_matrix<3>(random, 1), E = random_matrix<3>(random, 1);
        EXPECT_LT((product<2>(A, B) - A * B).norm(), 1e-15);
        EXPECT_LT((product<3>(C, E) - C * E).norm(), 2e-15);
    }
}

TEST(Exponential, OfWhatIsNoNumberIsNoNumber) {
    for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e6}) {
        Mat<3> A = Mat<3>::Zero();
        A(0, 1) = bad;
        EXPECT_FALSE(exponential(A).allFinite());
    }
}

} // namespace

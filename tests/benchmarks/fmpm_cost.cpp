/// What orders of FMPM cost: time a particle and step, and F, the time of one more order over the time of a FLIP step
/// (FMPM paper §2.3: 0.33 to 0.49 in that paper's examples). One thread.

#include "core/support.h"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cstdio>
#include <map>

namespace {

using namespace test;

template <int D>
State<D> moving_block(ShapeKind shape, int order) {
    const int edge = D == 2 ? 100 : 22; // cells
    Scene scene = plane_scene(1, 0, 0, edge + 4, edge + 4, material(1, 1, 0.4, MaterialModel::neo_hookean));
    if (D == 3) {
        scene.analysis = Analysis::three_d;
        scene.grid.cell[2] = 1;
        scene.grid.upper[2] = edge + 4;
    }
    scene.method.shape = shape;
    if (order > 0) scene.method.transfer = {TransferScheme::fmpm, order, {}, {}};
    Model model;
    const int body = add_body(model, "block");
    model.bodies[body].velocity.gradient[0][1] = 1e-3; // sheared, so that particles leave the lattice
    const int n = 2 * edge;
    for (int k = 0; k < (D == 3 ? n : 1); ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                model.position.push_back({2.25 + 0.5 * i, 2.25 + 0.5 * j, D == 3 ? 2.25 + 0.5 * k : 0.0});
                model.half_size.push_back({0.25, 0.25, D == 3 ? 0.25 : 0.0});
                model.body.push_back(body);
            }
    return make_state<D>(scene, model);
}

std::map<std::string, std::map<int, double>> results; ///< ns by method and order

template <int D>
void step(benchmark::State& timer, ShapeKind shape, const std::string& name, int order) {
    omp_set_num_threads(1);
    State<D> state = moving_block<D>(shape, order);
    auto tasks = step_tasks<D>(state.scene);
    const auto advance_one = [&] {
        state.dt = 0.2 * crossing_time(state);
        advance(state, tasks);
    };
    for (int i = 0; i < 5; ++i) advance_one();
    const auto start = std::chrono::steady_clock::now();
    std::int64_t steps = 0;
    for (auto _ : timer) {
        advance_one();
        ++steps;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double ns = seconds * 1e9 / static_cast<double>(steps * static_cast<std::int64_t>(state.particles.size()));
    timer.counters["ns_per_particle_step"] = ns;
    double& best = results[name][order];
    best = best > 0 ? std::min(best, ns) : ns;
}

template <int D>
void add(ShapeKind shape, const std::string& name) {
    for (const int order : {0, 1, 2, 3, 4, 5, 6, 7, 8})
        benchmark::RegisterBenchmark((name + (order ? "/fmpm" + std::to_string(order) : "/flip")).c_str(),
                                     [=](benchmark::State& timer) { step<D>(timer, shape, name, order); })
            ->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char** argv) {
    add<2>(ShapeKind::ugimp, "2d/ugimp");
    add<2>(ShapeKind::cpdi, "2d/cpdi");
    add<2>(ShapeKind::b2spline, "2d/b2spline");
    add<2>(ShapeKind::b2cpdi, "2d/b2cpdi");
    add<3>(ShapeKind::ugimp, "3d/ugimp");
    add<3>(ShapeKind::cpdi, "3d/cpdi");
    add<3>(ShapeKind::b2spline, "3d/b2spline");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    std::printf("\nns a particle and step, and F = (t(8) - t(1)) / 7 / t(FLIP); published F: 0.33 to 0.49, aim 0.25\n");
    for (const auto& [name, by_order] : results) {
        std::printf("%-12s", name.c_str());
        for (const auto& [order, ns] : by_order) std::printf(" %s%.0f", order ? "" : "FLIP ", ns);
        if (by_order.count(0) && by_order.count(1) && by_order.count(8))
            std::printf("   F = %.3f", (by_order.at(8) - by_order.at(1)) / 7 / by_order.at(0));
        std::printf("\n");
    }
}

#include "io/study/measures.h"
#include "io/study/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut {

namespace {

std::vector<double> column(MeasuredRun& run, const std::string& name) {
    return run.tables.values({TableVariable::Table::history, name, name, {}, {}, false});
}

double largest(const std::vector<double>& values) {
    double result = 0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

/// Sum over the bodies of their momenta without signs, at each row; and the mass of all [kg].
struct BodyMomenta {
    std::vector<double> magnitude;
    double mass = 0;
};

BodyMomenta body_momenta(MeasuredRun& run) {
    const CsvFile& bodies = run.tables.bodies();
    const std::size_t rows = run.tables.times().size();
    std::array<const CsvColumn*, 4> columns{bodies.find("mass"), bodies.find("vx"), bodies.find("vy"),
                                            bodies.find("vz")};
    if (rows == 0 || bodies.rows % rows != 0 || std::count(columns.begin(), columns.end(), nullptr) > 0)
        throw std::runtime_error(bodies.path.string() + ": does not fit history.csv");
    BodyMomenta momenta{std::vector<double>(rows), 0};
    const std::size_t count = bodies.rows / rows;
    for (std::size_t i = 0; i < bodies.rows; ++i) {
        const auto value = [&](std::size_t c) { return columns[c]->numbers[i]; };
        momenta.magnitude[i / count] += value(0) * std::hypot(value(1), value(2), value(3));
        if (i < count) momenta.mass += value(0);
    }
    return momenta;
}

/// What boundaries and rigid bodies did to the momentum along an axis up to each row [N s]. Forces are means since the
/// row before.
std::vector<double> impulses(MeasuredRun& run, char axis) {
    const std::vector<double>& times = run.tables.times();
    std::vector<double> total(times.size());
    const std::string end = std::string("_") + axis;
    for (const CsvColumn& force : run.tables.history().columns) {
        if (!force.name.starts_with("force_") || !force.name.ends_with(end)) continue;
        const std::string owner = force.name.substr(6, force.name.size() - 8);
        // Boundaries: on the bodies; rigid bodies, which have torques too: on themselves.
        const double sign = run.tables.history().find("torque_" + owner + end) ? -1 : 1;
        double sum = 0;
        for (std::size_t r = 1; r < times.size(); ++r) {
            sum += sign * force.numbers[r] * (times[r] - times[r - 1]);
            total[r] += sum;
        }
    }
    return total;
}

} // namespace

double measure_energy(const Metric& metric, MeasuredRun& run) {
    const std::vector<double> total = column(run, "total_energy");
    const std::vector<double> external = column(run, "external_work");
    const std::vector<double> contact = column(run, "contact_work");
    std::vector<double> balance;
    for (std::size_t r = 0; r < total.size(); ++r) balance.push_back(total[r] - total[0] - external[r] - contact[r]);
    const double whole = largest(total);
    if (!(whole > 0)) throw NoValue("there is no energy");
    if (metric.type == MetricType::energy_loss) {
        Metric end = metric;
        end.reduce = Reduction::end;
        return -reduce_in_time(end, run.tables.times(), balance) / whole;
    }
    return std::abs(reduce_in_time(metric, run.tables.times(), balance)) / whole;
}

double measure_momentum(const Metric& metric, MeasuredRun& run) {
    const Scene& scene = run.variant.scene.scene;
    const std::vector<double>& times = run.tables.times();
    const BodyMomenta momenta = body_momenta(run);
    std::vector<double> squares(times.size());
    for (int a = 0; a < dimension(scene.analysis); ++a) {
        if (scene.analysis == Analysis::axisymmetric && a == 0) continue; // hoop stress changes it
        const std::vector<double> momentum = column(run, std::string("momentum_") + "xyz"[a]);
        const std::vector<double> given = impulses(run, "xyz"[a]);
        const double weight = momenta.mass * scene.gravity[static_cast<std::size_t>(a)];
        for (std::size_t r = 0; r < times.size(); ++r) {
            const double error = momentum[r] - momentum[0] - given[r] - weight * (times[r] - times[0]);
            squares[r] += error * error;
        }
    }
    for (double& square : squares) square = std::sqrt(square);
    const double error = reduce_in_time(metric, times, squares);
    if (!metric.scale.empty()) return error / scale_of(metric, run);
    const double whole = largest(momenta.magnitude);
    if (!(whole > 0)) throw NoValue("nothing moves");
    return error / whole;
}

} // namespace abut

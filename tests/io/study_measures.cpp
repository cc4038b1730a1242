/// Measures of runs whose tables and frames are written by hand, against sums done by hand.
#include "study_support.h"

#include "io/results/csv.h"
#include "io/results/pvd.h"
#include "io/results/write_frame.h"
#include "io/study/describe.h"
#include "io/study/metrics.h"

#include <cmath>
#include <functional>

namespace abut::study_test {
namespace {

/// A row of history.csv of a body of 2 kg.
struct Row {
    double time, y, vy, energy, external;
};

constexpr double mass = 2;

/// Writes tables of a run with one body, "block".
void write_tables(const std::filesystem::path& folder, const std::vector<Row>& rows) {
    std::filesystem::create_directories(folder);
    CsvTable history(folder / "history.csv",
                     {"step", "time", "total_energy", "external_work", "contact_work", "momentum_x", "momentum_y",
                      "momentum_z", "force_my floor_x", "force_my floor_y"});
    CsvTable bodies(folder / "bodies.csv", {"step", "time", "body", "mass", "y", "vx", "vy", "vz"});
    double step = 0;
    for (const Row& row : rows) {
        history.row({step, row.time, row.energy, row.external, 0.0, 0.0, mass * row.vy, 0.0, 0.0, step});
        bodies.row({step, row.time, std::string_view("block"), mass, row.y, 0.0, row.vy, 0.0});
        ++step;
    }
}

VariantColumns columns() {
    VariantColumns columns;
    columns.history = {"step",       "time",       "total_energy", "external_work",    "contact_work",
                       "momentum_x", "momentum_y", "momentum_z",   "force_my floor_x", "force_my floor_y"};
    columns.bodies = {"block"};
    return columns;
}

/// A study of three cells with some metrics, and its folder.
struct Measured {
    Folder folder;
    Study study;
    std::vector<Variant> variants;
    StudyResults results;

    explicit Measured(const std::string& metrics) {
        Json json = study_json();
        json["combine"] = Json::parse(R"([{"cell": "*"}])");
        json.erase("tolerances");
        json["metrics"] = Json::parse(metrics);
        study = read_study(folder.write("study.json", json.dump()));
        variants = make_variants(study);
    }
    std::filesystem::path run(std::size_t variant) const { return folder / run_folder(variants[variant]); }
    void measure() {
        results = describe(study);
        for (const Variant& variant : variants) {
            VariantResult& result = results.variants.emplace_back();
            result.name = variant.name;
            result.levels = variant.levels;
            result.sizes = variant.sizes;
            result.status = std::filesystem::exists(folder / run_folder(variant)) ? Status::done : Status::unstable;
        }
        abut::measure(study, variants, std::vector<VariantColumns>(variants.size(), columns()), folder / "", results);
    }
    /// The value of the only metric; the cause is a failure.
    double value(std::size_t variant, std::size_t metric = 0) const {
        const auto& found = results.variants[variant].metrics[metric];
        EXPECT_TRUE(found) << results.variants[variant].absent[metric];
        return found.value_or(NAN);
    }
};

/// Rows at irregular times; y = 3 + t², vy = −t.
std::vector<Row> rows(double end = 1) {
    std::vector<Row> all;
    for (const double t : {0.0, 0.1, 0.4, 0.5, 0.9, 1.0})
        if (t <= end) all.push_back({t, 3 + t * t, -t, 10 - 2 * t, t});
    return all;
}

/// ∫ f over the rows by trapezoids, over their span.
double mean(const std::vector<Row>& all, const std::function<double(const Row&)>& f) {
    double sum = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        sum += 0.5 * (f(all[i]) + f(all[i - 1])) * (all[i].time - all[i - 1].time);
    return sum / (all.back().time - all.front().time);
}

TEST(StudyMeasures, HistoryAgainstAClosedForm) {
    Measured m(R"({"end": {"value": "block.y", "exact": "first_block.y + t^3/2"},
                   "max": {"value": "block.y", "exact": "3 + t^3", "reduce": "max"},
                   "rms": {"value": "block.y", "exact": "3 + t", "reduce": "rms"},
                   "relative": {"value": "block.y", "exact": "3 + t", "reduce": "rms", "relative": true},
                   "at": {"value": "block.y", "at": "0.45 s"},
                   "vector": {"value": ["block.y", "2*t"], "exact": ["3 + t^2", "t"], "reduce": "mean"},
                   "scaled": {"value": "block.y", "exact": "0", "scale": "-total_energy*h"},
                   "within": {"value": "t", "reduce": "mean", "from": 0.4, "to": "0.5 s"},
                   "plain": "-block.vy*total_energy",
                   "floor": "force_my_floor_y"})");
    write_tables(m.run(0), rows());
    m.measure();
    EXPECT_NEAR(m.value(0, 0), 0.5, 1e-15);
    EXPECT_NEAR(m.value(0, 1), 0.125, 1e-15); // at 0.5, of all rows
    const double rms = std::sqrt(mean(rows(), [](const Row& r) { return std::pow(r.time * r.time - r.time, 2); }));
    EXPECT_NEAR(m.value(0, 2), rms, 1e-15);
    const double whole = std::sqrt(mean(rows(), [](const Row& r) { return std::pow(3 + r.time, 2); }));
    EXPECT_NEAR(m.value(0, 3), rms / whole, 1e-15);
    EXPECT_NEAR(m.value(0, 4), 0.5 * (3.16 + 3.25), 1e-15);
    EXPECT_NEAR(m.value(0, 5), 0.5, 1e-15);
    EXPECT_NEAR(m.value(0, 6), 4 / (10 * 2e-3), 1e-12); // h is the cell of 2 mm
    EXPECT_NEAR(m.value(0, 7), 0.45, 1e-15);
    EXPECT_NEAR(m.value(0, 8), 8, 1e-15);
    EXPECT_EQ(m.value(0, 9), 5);
    EXPECT_FALSE(m.results.variants[1].metrics[0]);
    EXPECT_EQ(m.results.variants[1].absent[0], "the run is unstable");
}

TEST(StudyMeasures, HistoryAgainstAnotherRun) {
    Measured m(R"({"finest": {"value": "block.y", "reference": {"cell": "finest"}, "reduce": "max"},
                   "coarse": {"value": "block.y", "reference": {"cell": "2 mm"}, "relative": true}})");
    write_tables(m.run(0), rows());
    write_tables(m.run(1), {{0, 3, 0, 1, 0}, {1, 5, 0, 1, 0}});
    write_tables(m.run(2), {{0, 3, 0, 1, 0}, {1, 4, 0, 1, 0}});
    m.measure();
    EXPECT_NEAR(m.value(0, 0), 0.25, 1e-15); // y = 3 + t there: most at 0.5
    EXPECT_NEAR(m.value(1, 0), 1, 1e-15);
    EXPECT_FALSE(m.results.variants[2].metrics[0]);
    EXPECT_EQ(m.results.variants[2].absent[0], "it is the reference itself");
    EXPECT_NEAR(m.value(1, 1), 0.25, 1e-15);
}

TEST(StudyMeasures, NoValueHasACause) {
    Measured m(R"({"late": {"value": "t", "at": 2}, "zero": {"value": "t", "exact": "0", "relative": true},
                   "infinite": "1/(1 - t)*2", "none": {"value": "t", "from": 3},
                   "longer": {"value": "t", "reference": {"cell": "0.5 mm"}},
                   "frames": {"type": "particles", "value": "x"}})");
    write_tables(m.run(0), rows());
    write_tables(m.run(2), rows(0.5));
    m.measure();
    const std::vector<std::string>& absent = m.results.variants[0].absent;
    EXPECT_THAT(absent[0], HasSubstr("end at 1 s, before 2 s"));
    EXPECT_THAT(absent[1], HasSubstr("no relative error"));
    EXPECT_THAT(absent[2], HasSubstr("no finite number"));
    EXPECT_THAT(absent[3], HasSubstr("no row"));
    EXPECT_THAT(absent[4], HasSubstr("ends at 0.5 s, before 1 s"));
    EXPECT_THAT(absent[5], HasSubstr("particles.pvd"));
    for (const auto& metric : m.results.variants[0].metrics) EXPECT_FALSE(metric);
}

TEST(StudyMeasures, ConservationOfEnergyAndMomentum) {
    Measured m(R"({"loss": {"type": "energy-loss"}, "early": {"type": "energy-loss", "at": 0.5},
                   "balance": {"type": "balance-error"}, "momentum": {"type": "momentum-error", "reduce": "end"},
                   "kick": {"type": "momentum-error", "scale": "3"}})");
    write_tables(m.run(0), rows());
    m.measure();
    // Energy falls by 2 t while work of t is done: 3 t are missing, of 10 J.
    EXPECT_NEAR(m.value(0, 0), 0.3, 1e-15);
    EXPECT_NEAR(m.value(0, 1), 0.15, 1e-15);
    EXPECT_NEAR(m.value(0, 2), 0.3, 1e-15);
    // p = −2 t; gravity gives −2 · 9.81 t; the floor's force is the row's number since the row before.
    const auto error = [](std::size_t last) {
        double impulse = 0;
        const std::vector<Row> all = rows();
        for (std::size_t i = 1; i <= last; ++i) impulse += double(i) * (all[i].time - all[i - 1].time);
        return std::abs(-2 * all[last].time - impulse + mass * 9.81 * all[last].time);
    };
    EXPECT_NEAR(m.value(0, 3), error(5) / 2, 1e-14); // 2 N s at most
    double most = 0;
    for (std::size_t i = 0; i < 6; ++i) most = std::max(most, error(i));
    EXPECT_NEAR(m.value(0, 4), most / 3, 1e-14);
}

/// Writes a series of one frame of two by two particles about x = 1 mm at 0.5 s. \param moved displacements, x and y
void write_frames(const std::filesystem::path& folder, const std::vector<double>& moved) {
    PointFrame frame;
    frame.time = 0.5;
    std::vector<double> displacement, velocity;
    std::vector<std::int32_t> body;
    for (std::size_t p = 0; p < 4; ++p) {
        const double X = p % 2 == 0 ? 0.5e-3 : 1.5e-3, Y = p < 2 ? 0.5e-3 : 1.5e-3;
        frame.points.insert(frame.points.end(), {X + moved[2 * p], Y + moved[2 * p + 1], 0});
        displacement.insert(displacement.end(), {moved[2 * p], moved[2 * p + 1], 0});
        velocity.insert(velocity.end(), {2 * X, 0.1, 0});
        body.push_back(p < 2 ? 0 : 1);
    }
    frame.arrays = {{"displacement", 3, displacement, "m"},
                    {"velocity", 3, velocity, "m/s"},
                    {"body", 1, body, ""},
                    {"mass", 1, std::vector<double>{1, 2, 3, 4}, "kg"}};
    frame.words = {{"body_names", {"low", "high"}}};
    std::filesystem::create_directories(folder / "particles");
    write_particles(folder / "particles/particles_00000.vtu", frame);
    PvdSeries{folder / "particles.pvd", {{0.5, "particles/particles_00000.vtu"}}}.write();
}

TEST(StudyMeasures, ParticlesAgainstAField) {
    Measured m(R"({"rms": {"type": "particles", "value": "velocity_x", "exact": "4*X*t"},
                   "off": {"type": "particles", "value": "velocity_x", "exact": "4*x*t", "reduce": "max"},
                   "vector": {"type": "particles", "value": ["velocity_x", "velocity_y"], "exact": ["2*X", "0.1 - Y/h"],
                              "relative": true},
                   "mass": {"type": "particles", "value": "velocity_x", "reduce": "mean", "weight": "mass"},
                   "all": {"type": "particles", "value": "t", "reduce": "mean", "frames": "max"},
                   "high": {"type": "particles", "value": "velocity_x", "reduce": "mean", "bodies": ["high"]}})");
    write_tables(m.run(0), rows());
    write_frames(m.run(0), {1e-4, 0, 0, 0, 0, 0, 0, 2e-4});
    m.measure();
    EXPECT_NEAR(m.value(0, 0), 0, 1e-15);
    EXPECT_NEAR(m.value(0, 1), 2e-4, 1e-15);
    const double errors = 2 * 0.25 * 0.25 + 2 * 0.75 * 0.75; // Y/h, h = 2 mm
    const double wholes = 2 * (1e-6 + 9e-6) + 2 * 0.15 * 0.15 + 2 * 0.65 * 0.65;
    EXPECT_NEAR(m.value(0, 2), std::sqrt(errors / wholes), 1e-12);
    EXPECT_NEAR(m.value(0, 3), (4 * 1e-3 + 6 * 3e-3) / 10, 1e-15);
    EXPECT_EQ(m.value(0, 4), 0.5);
    EXPECT_NEAR(m.value(0, 5), 2e-3, 1e-15);
}

TEST(StudyMeasures, Symmetry) {
    const std::string metrics = R"({"s": {"type": "symmetry-error", "mirror": "x", "plane": "1 mm"}})";
    Measured symmetric(metrics);
    write_tables(symmetric.run(0), rows());
    write_frames(symmetric.run(0), {1e-4, 2e-4, -1e-4, 2e-4, 0, 3e-4, 0, 3e-4});
    write_tables(symmetric.run(1), rows());
    write_frames(symmetric.run(1), {1e-4, 0, 1e-4, 0, 0, 0, 0, 0}); // both to the right
    symmetric.measure();
    EXPECT_NEAR(symmetric.value(0), 0, 1e-12);
    EXPECT_NEAR(symmetric.value(1), std::sqrt((4.0 + 4.0) / 2), 1e-9); // differences of 2e-4, displacements of 1e-4
    Measured off(R"({"s": {"type": "symmetry-error", "mirror": "x", "plane": "1.2 mm"}})");
    write_tables(off.run(0), rows());
    write_frames(off.run(0), std::vector<double>(8));
    off.measure();
    EXPECT_THAT(off.results.variants[0].absent[0], HasSubstr("not symmetric at the start"));
}

TEST(StudyMeasures, ConvergenceAndSeries) {
    Measured m(R"({"y": "block.y", "y error": {"type": "convergence", "of": "y", "axis": "cell", "relative": true}})");
    const auto y = [](double h) { return 5 + 0.3 * std::pow(h, 1.5); }; // h in mm
    const std::vector<double> sizes{2, 1, 0.5};
    for (std::size_t v = 0; v < 3; ++v) write_tables(m.run(v), {{0, 3, 0, 1, 0}, {1, y(sizes[v]), 0, 1, 0}});
    m.measure();
    for (std::size_t v = 0; v < 3; ++v) EXPECT_NEAR(m.value(v, 1), 0.06 * std::pow(sizes[v], 1.5), 1e-9);
    ASSERT_EQ(m.results.series.size(), 2U);
    const ConvergenceSeries& series = m.results.series[1];
    EXPECT_EQ(series.metric, 1U);
    EXPECT_EQ(series.axis, 0U);
    EXPECT_EQ(series.variants, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_NEAR(series.observed_order.value_or(0), 1.5, 1e-6);
    EXPECT_NEAR(series.fitted_order.value_or(0), 1.5, 1e-6);
    EXPECT_NEAR(series.extrapolated.value_or(0), 5, 1e-7);
}

TEST(StudyMeasures, ChecksExpressionsBefore) {
    const auto problems = [](const std::string& metrics) {
        const Measured m(metrics);
        std::string text;
        for (const Problem& problem : check_metrics(m.study, m.variants[0], columns()))
            text += problem.pointer + ": " + problem.message + "\n";
        return text;
    };
    EXPECT_EQ(problems(R"({"a": "total_energy + block.vx + h"})"), "");
    EXPECT_THAT(problems(R"({"a": "total_enery"})"), HasSubstr("/metrics/a/value: \"total_enery\""));
    EXPECT_THAT(problems(R"({"a": "total_enery"})"), HasSubstr("did you mean \"total_energy\""));
    EXPECT_THAT(problems(R"({"a": {"value": "t", "exact": "2*(t"}})"), HasSubstr("/metrics/a/exact: "));
    EXPECT_THAT(problems(R"({"a": "blck.vx"})"), HasSubstr("no body \"blck\"; did you mean \"block\""));
    EXPECT_THAT(problems(R"({"a": "block.vq"})"), HasSubstr("bodies.csv has no column \"vq\""));
    EXPECT_THAT(problems(R"({"a": "block.block.force_x"})"), HasSubstr("no contact"));
    EXPECT_THAT(problems(R"({"a": {"type": "particles", "value": "velocity"}})"),
                HasSubstr("did you mean \"velocity_"));
    EXPECT_THAT(problems(R"({"a": {"type": "particles", "value": "temperature"}})"), HasSubstr("unknown name"));
    EXPECT_THAT(problems(R"({"a": {"type": "particles", "value": "x", "bodies": ["blok"]}})"),
                HasSubstr("/metrics/a/bodies/0: no body \"blok\"; did you mean \"block\""));
    EXPECT_THAT(problems(R"({"a": {"type": "interpenetration"}})"), HasSubstr("with contact only"));
}

} // namespace
} // namespace abut::study_test

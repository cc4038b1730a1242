#include "app/trouble.h"

#include "io/scene/words.h"
#include "plan/time_step.h"
#include "step/good_state.h"
#include "step/setback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// Nothing if the trouble comes whatever the step.
template <int D>
std::string smaller_step(const State<D>& state) {
    if (state.setback && state.setback->returns == most_returns) return "";
    const TimeSpec& time = state.scene.time;
    const double reduction = std::ldexp(1.0, -state.step_reductions);
    const std::string reduced =
        state.step_reductions > 0 ? fmt::format(", halved {} times since", state.step_reductions) : "";
    if (time.step)
        return fmt::format("a smaller time step: --set \"/time/step={:.3g} s\" (it is {:.4g} s{})",
                           0.5 * reduction * *time.step, *time.step, reduced);
    const double used = std::min(time.cfl, cfl_limit(state.scene));
    const std::string cut = used < time.cfl ? fmt::format(", cut to {:.3g} for this method", used) : "";
    return fmt::format("a smaller time step: --set /time/cfl={:.3g} (it is {:g}{}{})", 0.5 * reduction * used, time.cfl,
                       cut, reduced);
}

std::string finer_grid(const Scene& scene) {
    const auto& cell = scene.grid.cell;
    const int axes = dimension(scene.analysis);
    if (std::all_of(cell.begin(), cell.begin() + axes, [&](double size) { return size == cell[0]; }))
        return fmt::format("a finer grid: --set \"/grid/cell={:.3g} m\" (it is {:.4g} m)", 0.5 * cell[0], cell[0]);
    std::string half, whole;
    for (int a = 0; a < axes; ++a) {
        half += fmt::format("{}{:.3g}", a > 0 ? ", " : "", 0.5 * cell[a]);
        whole += fmt::format("{}{:.4g}", a > 0 ? ", " : "", cell[a]);
    }
    return fmt::format("a finer grid: --set \"/grid/cell=[{}]\" (it is [{}] m)", half, whole);
}

/// Another transfer against noise; nothing if the scene's damps well.
std::string calmer_transfer(const Scene& scene) {
    const TransferSpec& transfer = scene.method.transfer;
    switch (transfer.scheme) {
    case TransferScheme::flip:
        return "a transfer that damps noise: --set '/method/transfer={\"scheme\": \"xpic\", \"order\": 2}' (it is "
               "flip)";
    case TransferScheme::xpic:
        if (transfer.order > 2)
            return fmt::format("more damping: --set /method/transfer/order=2 (it is xpic of order {})", transfer.order);
        break;
    case TransferScheme::fmpm:
        if (transfer.order > 2)
            return fmt::format("more damping: --set /method/transfer/order=2 (it is fmpm of order {})", transfer.order);
        break;
    case TransferScheme::pic:
        break;
    }
    return transfer.every_cfl
               ? fmt::format("its transfer more often: a smaller /method/transfer/every_cfl (it is {:g}, "
                             "with flip steps between)",
                             *transfer.every_cfl)
               : "";
}

/// Shape functions of higher order; nothing if the scene has them.
std::string smoother_shape(const Scene& scene, const char* wanted) {
    const ShapeKind shape = scene.method.shape;
    const auto word = text_of(shape_words, shape);
    if (word == wanted) return "";
    return fmt::format("shape functions of higher order: --set /method/shape={} (it is {})", wanted, word);
}

/// Particles that keep their size can't be drawn out across the grid.
std::string shape_that_keeps_size(const Scene& scene) {
    const ShapeKind shape = scene.method.shape;
    if (shape == ShapeKind::linear || shape == ShapeKind::ugimp || shape == ShapeKind::b2spline) return "";
    return fmt::format("particles that keep their size: --set /method/shape=ugimp or b2spline (it is {})",
                       text_of(shape_words, shape));
}

std::string stress_last(const Scene& scene) {
    const StressUpdate update = scene.method.stress_update;
    if (update == StressUpdate::usl || update == StressUpdate::usl_plus) return "";
    return fmt::format("stress updated last, which damps what the grid can't resolve: --set /method/stress_update=usl "
                       "(it is {})",
                       text_of(stress_update_words, update));
}

std::string larger_grid(const Scene& scene) {
    std::string box;
    for (int a = 0; a < dimension(scene.analysis); ++a)
        box += fmt::format("{}{:g} to {:g}", a > 0 ? ", " : "", scene.grid.lower[a], scene.grid.upper[a]);
    return fmt::format("if the material should be there, a larger grid: /grid/lower, /grid/upper (now {} m)", box);
}

/// What the user may do, for the kind of trouble and the scene's settings: keys of the scene with their present values,
/// the most promising first.
template <int D>
std::vector<std::string> advice_on(Trouble trouble, const State<D>& state) {
    const Scene& scene = state.scene;
    std::vector<std::string> advice;
    const auto add = [&](std::string text) {
        if (!text.empty()) advice.push_back(std::move(text));
    };
    switch (trouble) {
    case Trouble::left_grid:
    case Trouble::domain_left_grid:
        add(larger_grid(scene));
        add(smaller_step(state));
        add(trouble == Trouble::domain_left_grid ? shape_that_keeps_size(scene) : "");
        break;
    case Trouble::crossed_axis:
        add(smaller_step(state));
        add(finer_grid(scene));
        break;
    case Trouble::too_fast:
    case Trouble::not_a_number:
        add(smaller_step(state));
        add(calmer_transfer(scene));
        add(stress_last(scene));
        add(trouble == Trouble::too_fast ? "if such speeds are meant, a higher /time/limits/speed" : "");
        break;
    case Trouble::inside_out:
        add(smaller_step(state));
        add(finer_grid(scene));
        add(smoother_shape(scene, "b2cpdi"));
        add(calmer_transfer(scene));
        break;
    case Trouble::stretched:
        add(smaller_step(state));
        add(shape_that_keeps_size(scene));
        add(finer_grid(scene));
        break;
    case Trouble::step_too_large:
        add(smaller_step(state));
        add("a step that follows the wave speed: /time/cfl instead of /time/step");
        break;
    case Trouble::energy_growth:
        add(smaller_step(state));
        add(stress_last(scene));
        add(calmer_transfer(scene));
        add(smoother_shape(scene, "b2cpdi"));
        break;
    case Trouble::step_vanished:
        add("waves have become so fast that the step is nothing: material is compressed beyond all measure; look at "
            "boundaries and velocities of the scene");
        break;
    case Trouble::rigid_left_grid:
        add("the motion of the rigid body, or a larger grid: /grid/lower, /grid/upper");
        break;
    }
    return advice;
}

/// The lines of a report: the diagnosis; what was left and where; what to do. All but the first are indented.
std::string trouble_report(const std::string& diagnosis, const std::vector<std::string>& left,
                           const std::vector<std::string>& advice) {
    std::string report = diagnosis;
    for (const std::string& line : left) report += "\n  " + line;
    for (std::size_t i = 0; i < advice.size(); ++i) report += (i == 0 ? "\n  try " : "\n  or  ") + advice[i];
    return report;
}

} // namespace

std::string word_of(Trouble trouble) {
    switch (trouble) {
    case Trouble::left_grid:
        return "left-grid";
    case Trouble::domain_left_grid:
        return "domain-left-grid";
    case Trouble::crossed_axis:
        return "crossed-axis";
    case Trouble::too_fast:
        return "too-fast";
    case Trouble::not_a_number:
        return "not-a-number";
    case Trouble::inside_out:
        return "inside-out";
    case Trouble::stretched:
        return "stretched";
    case Trouble::step_too_large:
        return "step-too-large";
    case Trouble::step_vanished:
        return "step-vanished";
    case Trouble::energy_growth:
        return "energy-growth";
    case Trouble::rigid_left_grid:
        return "rigid-left-grid";
    }
    return "";
}

bool depends_on_step(Trouble trouble) {
    return trouble != Trouble::rigid_left_grid && trouble != Trouble::step_vanished;
}

template <int D>
void report_trouble(const RunError& error, State<D>& state, RunFiles& files, GoodStates<D>& good,
                    const std::string& checkpoint, const std::string& unwritten) {
    state.setback = setback_of(state, error);
    const bool comes_back = state.setback->returns == most_returns;
    std::vector<std::string> advice = advice_on(error.trouble(), state);
    std::vector<std::string> left;
    const auto write = [&](const char* name, const std::string& what) {
        try {
            left.push_back(fmt::format("{}: {}", what, files.write_apart(state, name).string()));
        } catch (const std::exception& cause) {
            left.push_back(fmt::format("{}: not written: {}", what, cause.what()));
        }
    };
    write("failed", "the state gone wrong");
    if (!good.empty()) {
        if (comes_back)
            left.emplace_back(
                "it came back at the same time and place though the time step was halved twice: a smaller "
                "one won't help");
        else if (state.step_reductions == most_step_reductions)
            left.push_back(fmt::format("the time step was halved {} times in vain", most_step_reductions));
        go_back(good.oldest().state, state);
        write("last_good", fmt::format("the last good state, step {}, {:g} s", state.step, state.time));
    } else if (const std::string frame = files.last_frame(); !frame.empty()) {
        left.emplace_back("the last frame before: " + frame);
    }
    left.push_back(checkpoint.empty() ? "no checkpoint was written before: see /output/checkpoint_every"
                                      : "the last checkpoint before: " + checkpoint);
    if (!unwritten.empty()) left.push_back(unwritten);
    if (good.empty() && depends_on_step(error.trouble()) && !comes_back)
        advice.emplace_back(checkpoint.empty()
                                ? "--set /time/on_trouble=shrink-step, which goes back and halves the step by itself"
                                : "go on from the checkpoint: --resume --set /time/on_trouble=shrink-step");
    throw RunError(error.trouble(), error.particle(), trouble_report(error.what(), left, advice));
}

template void report_trouble<2>(const RunError&, State<2>&, RunFiles&, GoodStates<2>&, const std::string&,
                                const std::string&);
template void report_trouble<3>(const RunError&, State<3>&, RunFiles&, GoodStates<3>&, const std::string&,
                                const std::string&);

} // namespace abut

#include "io/render/render_series.h"

#include "io/render/animation.h"
#include "io/render/compose.h"
#include "io/render/offscreen_context.h"
#include "io/render/preset.h"
#include "io/render/select.h"
#include "io/render/series_source.h"
#include "io/render/workers.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>

namespace abut {
namespace {

/// A series with all that its pictures need.
struct Job {
    RenderOptions options;
    SeriesSource source;
    std::vector<int> frames;
    Selection selection;
    Look look;

    PointFrame particles(int index, const std::vector<std::string>& wanted) const {
        PointFrame frame = source.particles(index, wanted);
        select_particles(frame, selection);
        return frame;
    }
    std::optional<PointFrame> contact(int index) const {
        if (!with_contact(options)) return {};
        PointFrame frame = source.contact(index);
        select_contacts(frame, selection);
        return frame;
    }
};

std::vector<int> chosen_frames(const RenderOptions& options, const PvdSeries& series) {
    const int count = static_cast<int>(series.entries.size());
    if (options.last_only) return {count - 1};
    if (options.frames) {
        std::vector<int> chosen; // each once: two processes must not write the same file
        for (const int frame : *options.frames) {
            if (frame < 0 || frame >= count)
                throw RenderRequestError(
                    fmt::format("{}: no frame {}; there are 0 to {}", series.path.string(), frame, count - 1));
            if (std::find(chosen.begin(), chosen.end(), frame) == chosen.end()) chosen.push_back(frame);
        }
        return chosen;
    }
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Frames for which contact.pvd has one too: contact pairs may be written at other times than particles.
void keep_frames_with_contact(Job& job) {
    if (!job.source.contacts) return;
    const std::string path = job.source.contacts->path.string();
    const bool asked_for = job.options.frames || job.options.last_only;
    const std::size_t all = job.frames.size();
    std::erase_if(job.frames, [&](int index) {
        if (job.source.contact_entry(index)) return false;
        if (asked_for)
            throw RenderRequestError(fmt::format("frame {}: {} has no frame at its time (contact_every)", index, path));
        return true;
    });
    if (job.frames.empty())
        throw RenderRequestError(path + ": it has no frame at any time of the particles' (contact_every)");
    if (job.frames.size() < all && job.options.note)
        job.options.note(fmt::format("{} of {} frames are not drawn: {} has no frame at their times (contact_every)",
                                     all - job.frames.size(), all, path));
}

/// Of the pictures' folder.
std::string default_name(const RenderOptions& options) {
    if (!options.preset.empty()) return options.preset;
    if (!by_body(options)) return options.array;
    return options.separations ? "contact" : options.normals ? "normals" : "bodies";
}

void check_animation_place(const RenderOptions& options, const std::vector<std::filesystem::path>& pictures) {
    const auto place = [](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
    };
    const std::filesystem::path animation = place(options.animation);
    for (const std::filesystem::path& picture : pictures)
        if (place(picture) == animation)
            throw RenderRequestError(options.animation.string() + ": the animation would replace one of the pictures");
}

/// Chooses what is drawn, and the look, from the first frame; from all where the range of values or the bounds need it.
void prepare(Job& job) {
    const RenderOptions& options = job.options;
    const std::string where = job.source.series.path.string();
    const PointFrame first = job.source.particles(job.frames.front(), {});
    chosen_array(first, options, where);
    if (job.source.contacts)
        check_contact_arrays(job.source.contact(job.frames.front()), options, job.source.contacts->path.string());
    if (!options.bodies.empty()) job.selection.bodies = body_numbers(first, options.bodies, where);

    // A box of space that is mostly empty would leave little of the picture to the bodies: there the picture shows the
    // box that they need, in the plane that of the grid.
    const bool in_space = is_in_space(first);
    const std::optional<Bounds> grid = job.source.grid_bounds();
    std::optional<Bounds> bounds;
    if (!in_space) bounds = grid;
    if (!options.region.empty()) {
        Bounds whole = bounds ? *bounds : nothing();
        if (!bounds) extend(whole, first, in_space);
        bounds = job.selection.region = region_of(options.region, whole.flat());
        check_region(*bounds, grid ? *grid : whole, grid.has_value());
    }
    ShownValues values;
    const bool wants_values = !options.range && (!by_body(options) || options.separations);
    // The legend of a region names the bodies that come into it.
    const bool wants_bodies = job.selection.region && by_body(options) && !options.separations && options.legend;
    std::set<int> bodies;
    if (!bounds || wants_values || wants_bodies) {
        Bounds points = nothing();
        std::vector<std::string> wanted{options.array, "body"};
        if (in_space || job.selection.region) wanted.insert(wanted.end(), {"half_size", "deformation_gradient"});
        for (const int index : job.frames) {
            const std::optional<PointFrame> contact = job.contact(index);
            PointFrame frame;
            if (!bounds || !options.separations) frame = job.particles(index, wanted);
            if (!bounds) extend(points, frame, in_space);
            if (const Array* body = find_array(frame, "body"); body && wants_bodies)
                for (const double number : values_of(*body, -1)) bodies.insert(static_cast<int>(number));
            if (wants_values) values = joined(values, shown_values(frame, contact ? &*contact : nullptr, options));
        }
        if (!bounds) bounds = around(points);
    }
    if (job.selection.bodies && !wants_bodies) bodies = *job.selection.bodies;
    job.look = make_look(first, *bounds, values, options, where,
                         wants_bodies || job.selection.bodies ? std::optional(bodies) : std::nullopt);
    job.look.title = job.source.title();
    job.look.end_time = job.source.series.entries.back().time;
}

Picture picture_of(const Job& job, int index) {
    const PointFrame frame = job.particles(index, needed_arrays(job.options));
    const std::optional<PointFrame> contact = job.contact(index);
    try {
        return compose(frame, contact ? &*contact : nullptr,
                       job.source.series.entries[static_cast<std::size_t>(index)].time, job.look, job.options);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("frame {}: {}", index, error.what()));
    }
}

} // namespace

void render_frame(const PointFrame& frame, const Bounds& grid, const std::string& title, const RenderOptions& given,
                  const std::filesystem::path& file) {
    RenderOptions options = resolved(given);
    options.normals = options.separations = false;
    Bounds bounds = grid;
    if (is_in_space(frame)) {
        bounds = nothing();
        extend(bounds, frame, true);
        bounds = around(bounds);
    }
    Look look = make_look(frame, bounds, shown_values(frame, nullptr, options), options, file.string());
    look.title = title;
    OffscreenContext context;
    write_png(context, compose(frame, nullptr, {}, look, options), file);
}

std::vector<std::filesystem::path> render_series(const std::filesystem::path& result_dir, const RenderOptions& given) {
    Job job{resolved(given), {}, {}, {}, {}};
    const RenderOptions& options = job.options;
    if (!options.animation.empty()) check_animation(options.animation, options.fps);
    job.source = open_series(result_dir, with_contact(options));
    job.frames = chosen_frames(options, job.source.series);
    if (job.frames.empty()) return {};
    keep_frames_with_contact(job);
    job.source.check_files(job.frames);
    prepare(job);

    const auto folder = options.output.empty() ? result_dir / "frames" / default_name(options) : options.output;
    std::vector<std::filesystem::path> files;
    for (const int index : job.frames) files.push_back(folder / fmt::format("frame_{:05}.png", index));
    if (!options.animation.empty()) check_animation_place(options, files);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.message()));

    const int total = static_cast<int>(files.size());
    std::unique_ptr<OffscreenContext> context; // of the process that draws
    const auto draw = [&](int i) {
        if (!context) context = std::make_unique<OffscreenContext>();
        const auto k = static_cast<std::size_t>(i);
        write_png(*context, picture_of(job, job.frames[k]), files[k]);
    };
    const auto report = [&](int done) {
        if (options.progress) options.progress(done, total);
    };
    // Drivers don't survive a fork.
    share_work(total, OffscreenContext::used() ? 1 : options.jobs, draw, report);
    if (!options.animation.empty()) {
        write_animation(files, options.animation, options.fps);
        files.push_back(options.animation);
    }
    return files;
}

} // namespace abut

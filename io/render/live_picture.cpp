#include "io/render/live_picture.h"

#include "io/render/compose.h"
#include "io/render/offscreen_context.h"
#include "io/render/preset.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace abut {

struct LivePicture::State {
    std::filesystem::path file;
    Bounds grid;
    std::string title;
    RenderOptions options;
    double end_time = 0;

    bool failed = false;
    std::optional<OffscreenContext> context;
    std::optional<Bounds> space; ///< what is seen of a scene in space
    ShownValues values;          ///< so far

    Bounds view_of(const PointFrame& particles) {
        if (!is_in_space(particles)) return grid;
        Bounds needed = nothing();
        extend(needed, particles, true);
        const auto within = [&] {
            for (std::size_t k = 0; k < 3; ++k)
                if (needed.lower[k] < space->lower[k] || needed.upper[k] > space->upper[k]) return false;
            return true;
        };
        if (!space) space = around(needed);
        if (!within()) {
            const Bounds wider = around(needed);
            for (std::size_t k = 0; k < 3; ++k) {
                space->lower[k] = std::min(space->lower[k], wider.lower[k]);
                space->upper[k] = std::max(space->upper[k], wider.upper[k]);
            }
        }
        return *space;
    }

    void draw(const PointFrame& particles, const PointFrame* contact) {
        if (with_contact(options) && !contact)
            throw RenderRequestError(
                fmt::format("preset \"{}\" shows contact, of which this scene has none", options.preset));
        values = joined(values, shown_values(particles, contact, options));
        Look look = make_look(particles, view_of(particles), values, options, file.filename().string());
        look.title = title;
        look.end_time = end_time;
        const Picture picture =
            compose(particles, with_contact(options) ? contact : nullptr, particles.time, look, options);
        if (!context) context.emplace();
        write_png(*context, picture, file);
    }
};

LivePicture::LivePicture(const std::filesystem::path& file, const Bounds& grid, const std::string& title,
                         const std::string& preset, double end_time)
    : state_(std::make_unique<State>()) {
    state_->file = file;
    state_->grid = grid;
    state_->title = title;
    state_->options.preset = preset;
    state_->options = resolved(state_->options);
    state_->end_time = end_time;
}

LivePicture::~LivePicture() = default;
LivePicture::LivePicture(LivePicture&& other) noexcept = default;
LivePicture& LivePicture::operator=(LivePicture&& other) noexcept = default;

bool LivePicture::wants_contact() const {
    return with_contact(state_->options);
}

void LivePicture::draw(const PointFrame& particles, const PointFrame* contact) {
    if (state_->failed) return;
    try {
        state_->draw(particles, contact);
    } catch (const std::exception& error) {
        state_->failed = true;
        fmt::print(stderr, "warning: {} is not drawn: {}\n", state_->file.string(), error.what());
    }
}

} // namespace abut

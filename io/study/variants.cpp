#include "io/study/variants.h"

#include "io/results/checksum.h"
#include "io/scene/overrides.h"
#include "io/scene/parse_json.h"
#include "io/study/output_of_variants.h"
#include "io/study/scene_values.h"
#include "io/study/variant_names.h"
#include "scene/input_files.h"
#include "scene/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace abut {

namespace {

constexpr std::size_t most_variants = 100'000;

using Levels = std::vector<std::size_t>;

bool contains(const LevelChoice& choice, const Levels& levels) {
    for (std::size_t a = 0; a < levels.size(); ++a)
        if (std::find(choice[a].begin(), choice[a].end(), levels[a]) == choice[a].end()) return false;
    return true;
}

/// All combinations of a choice, the last axis running fastest.
std::vector<Levels> product_of(const LevelChoice& choice) {
    std::vector<Levels> all{{}};
    for (const std::vector<std::size_t>& levels : choice) {
        std::vector<Levels> longer;
        for (const Levels& begun : all)
            for (const std::size_t level : levels) longer.emplace_back(begun).push_back(level);
        all = std::move(longer);
    }
    return all;
}

/// What a study's way to combine asks for, without exceptions.
std::vector<LevelChoice> choices_of(const Study& study) {
    if (study.combine == Combine::chosen) return study.chosen;
    LevelChoice all, centers;
    for (const Axis& axis : study.axes) {
        std::vector<std::size_t>& levels = all.emplace_back(axis.levels.size());
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = i;
        centers.push_back({axis.center});
    }
    if (study.combine == Combine::product) return {all};
    std::vector<LevelChoice> choices{centers};
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
        choices.push_back(centers);
        choices.back()[a] = all[a];
    }
    return choices;
}

/// Problems of many scenes, each told once: with how many variants have it.
class SharedProblems {
public:
    void add(const Problem& problem, const std::string& variant) {
        const auto [place, added] = index_.try_emplace({problem.pointer, problem.message}, entries_.size());
        if (added) entries_.push_back({problem, variant, 0});
        ++entries_[place->second].count;
    }
    bool empty() const { return entries_.empty(); }

    [[noreturn]] void complain(const Study& study, std::size_t variants) const {
        std::vector<Problem> of_base, of_variants;
        for (const auto& [problem, variant, count] : entries_) {
            if (count == variants) {
                of_base.push_back(problem);
                continue;
            }
            const std::string others = count == 1   ? ""
                                       : count == 2 ? " and another one"
                                                    : fmt::format(" and {} others", count - 1);
            of_variants.push_back(
                {"", fmt::format("variant \"{}\"{}: {}: {}", variant, others, problem.pointer, problem.message)});
        }
        // Problems that all variants have are those of the base.
        if (of_base.empty()) throw SceneError(study.file.string(), of_variants);
        throw SceneError(study.base_file.empty() ? study.file.string() + ": /base" : study.base_file.string(), of_base);
    }

private:
    struct Entry {
        Problem problem;
        std::string variant; ///< the first that has it
        std::size_t count;
    };
    std::map<std::pair<std::string, std::string>, std::size_t> index_;
    std::vector<Entry> entries_;
};

std::vector<Setting> settings_of(const Study& study, const Levels& levels) {
    std::vector<Setting> settings = study.settings;
    for (std::size_t a = 0; a < levels.size(); ++a) {
        const std::vector<Setting>& more = study.axes[a].levels[levels[a]].settings;
        settings.insert(settings.end(), more.begin(), more.end());
    }
    return settings;
}

/// The scene with the settings, and with the output of a study. Throws SceneError.
LoadedScene load_variant(const Study& study, const Json& base, const std::vector<Setting>& settings) {
    const std::filesystem::path folder =
        std::filesystem::absolute(study.base_file.empty() ? study.file : study.base_file).parent_path();
    Json scene = base;
    for (const Setting& setting : settings)
        if (const auto message = apply_setting(scene, setting.pointer, Json::parse(setting.value)))
            throw SceneError("", {{setting.where, *message}});
    const LoadedScene loaded = load_scene_text(scene.dump(), "", folder);
    Json resolved = Json::parse(loaded.resolved);
    resolved["output"] = output_of_variants(study, loaded.scene, resolved["output"]);
    for (const Setting& setting : settings)
        if (setting.pointer.starts_with("/output"))
            apply_setting(resolved, setting.pointer, Json::parse(setting.value));
    return load_scene_text(resolved.dump(), "", folder);
}

/// Files with a "*" in their names: all that fit, in order.
std::vector<std::filesystem::path> matching(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.find('*') == std::string::npos) return {file};
    const std::string escaped = std::regex_replace(name, std::regex(R"([.^$|()\[\]{}+?\\])"), R"(\$&)");
    const std::regex pattern(std::regex_replace(escaped, std::regex(R"(\*)"), ".*"));
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(file.parent_path(), ignored))
        if (std::regex_match(entry.path().filename().string(), pattern)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// A checksum of all that a run depends on; where the files lie doesn't matter, what is in them does.
std::string key_of(const LoadedScene& loaded, int threads) {
    std::string text = loaded.resolved;
    for (const std::filesystem::path& file : input_files(loaded.scene)) {
        std::string content;
        for (const std::filesystem::path& one : matching(file)) content += checksum_of_file(one);
        const std::string name = Json(file.string()).dump();
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at))
            text.replace(at, name.size(), content);
    }
    return checksum_of(fmt::format("{}threads {}", text, threads));
}

Variant make_variant(const Study& study, const Json& base, const Levels& levels) {
    Variant variant{{}, {}, levels, {}, {}, study.threads, load_variant(study, base, settings_of(study, levels)), {}};
    const Json resolved = Json::parse(variant.scene.resolved);
    for (std::size_t a = 0; a < levels.size(); ++a) {
        const Axis& axis = study.axes[a];
        const Level& level = axis.levels[levels[a]];
        variant.threads = level.threads.value_or(variant.threads);
        std::optional<double>& size = variant.sizes.emplace_back();
        if (level.threads) size = *level.threads;
        if (!axis.size) continue;
        try {
            size = number_at(resolved, axis.size->pointer);
        } catch (const NoNumber& error) {
            throw SceneError("", {{axis.size->where, error.what()}});
        }
    }
    std::string where;
    try {
        variant.parameters = parameters_of(study, resolved, where);
    } catch (const std::runtime_error& error) {
        throw SceneError("", {{where, error.what()}});
    }
    try {
        variant.key = key_of(variant.scene, variant.threads);
    } catch (const std::runtime_error& error) {
        throw SceneError("", {{"", error.what()}});
    }
    return variant;
}

} // namespace

std::vector<std::vector<std::size_t>> variant_levels(const Study& study) {
    std::vector<Levels> result;
    std::set<Levels> known;
    for (const LevelChoice& choice : choices_of(study)) {
        double count = 1;
        for (const auto& levels : choice) count *= static_cast<double>(levels.size());
        if (count + static_cast<double>(result.size()) > most_variants)
            throw SceneError(study.file.string(), {{"/combine", fmt::format("these are {:.3g} variants; at most {} are "
                                                                            "possible",
                                                                            count, most_variants)}});
        for (const Levels& levels : product_of(choice)) {
            const bool excepted = std::any_of(study.except.begin(), study.except.end(),
                                              [&](const LevelChoice& except) { return contains(except, levels); });
            if (!excepted && known.insert(levels).second) result.push_back(levels);
        }
    }
    if (result.empty()) {
        const std::string what =
            study.except.empty() ? "no variants: the list is empty" : "no variants: all are excepted";
        throw SceneError(study.file.string(), {{study.except.empty() ? "/combine" : "/except", what}});
    }
    return result;
}

std::vector<Variant> make_variants(const Study& study) {
    ParsedJson base = parse_json(study.base);
    const std::string shown = study.base_file.empty() ? study.file.string() : study.base_file.string();
    if (base.value && !base.value->is_object()) base.problems.push_back({"", "a scene is an object { }"});
    if (!base.problems.empty() || !base.value) throw SceneError(shown, base.problems);

    const std::vector<Levels> all = variant_levels(study);
    std::vector<Variant> variants;
    SharedProblems problems;
    VariantNames names(study);
    std::size_t wrong = 0;
    for (const Levels& levels : all) {
        const std::string name = names.name(levels);
        try {
            Variant variant = make_variant(study, *base.value, levels);
            variant.name = name;
            variant.folder = names.folder(name);
            if (wrong == 0) variants.push_back(std::move(variant));
        } catch (const SceneError& error) {
            ++wrong;
            for (const Problem& problem : error.problems()) problems.add(problem, name);
        }
    }
    if (!problems.empty()) problems.complain(study, all.size());
    return variants;
}

} // namespace abut

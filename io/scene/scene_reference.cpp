#include "io/scene/scene_reference.h"

#include "io/scene/check.h"
#include "io/scene/read_scene.h"
#include "io/scene/scene_reference_texts.h"
#include "io/scene/specification.h"
#include "results/arrays.h"

#include <fmt/format.h>

#include <algorithm>

namespace abut {

namespace {

std::string code_list(const std::vector<std::string>& words, const std::string& link = ", ") {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += link;
        text += '`';
        text += word;
        text += '`';
    }
    return text;
}

/// The kind of a key's value, with its unit and range, in words.
std::string type_of(const Key& key) {
    const bool plain = key.dimension == dimensions::none;
    const std::string unit = plain ? "numbers" : unit_of(key.dimension);
    const bool limited = key.range.minimum || key.range.maximum;
    const std::string range = limited ? ", " + in_words(key.range, "") : "";
    const std::string entries = limited && key.range.minimum == key.range.maximum
                                    ? fmt::format(" of {}", *key.range.minimum)
                                : limited ? fmt::format(", {} entries", in_words(key.range, ""))
                                          : "";
    switch (key.kind) {
    case Kind::object:
        return "object";
    case Kind::list:
        return "list" + entries;
    case Kind::map:
        return "object, any names";
    case Kind::quantity:
        return unit + range;
    case Kind::vector:
        return fmt::format("vector of {}{}", unit, range);
    case Kind::per_axis:
        return fmt::format("{0} or vector of {0}{1}", unit, range);
    case Kind::spin:
        return fmt::format("{0}; in `3d` vector of {0}", unit);
    case Kind::points:
        return fmt::format("list of vectors of {}", unit);
    case Kind::outlines:
        return fmt::format("list of lists of vectors of {}", unit);
    case Kind::matrix:
        return "matrix of " + unit;
    case Kind::function:
        return fmt::format("function, {}{}{}", unit, key.words.empty() ? "" : ", or ", code_list(key.words));
    case Kind::functions:
        return "vector of functions, " + unit;
    case Kind::number:
        return "number" + range;
    case Kind::integer:
        return "whole number" + range;
    case Kind::boolean:
        return "`true` or `false`";
    case Kind::text:
        return "text";
    case Kind::name:
        return "name";
    case Kind::file:
        return "path";
    case Kind::word:
        return code_list(key.words, " \\| ");
    case Kind::colour:
        return "`\"#rrggbb\"`";
    case Kind::any:
        return "anything";
    case Kind::later:
        break;
    }
    return "";
}

std::string default_of(const Key& key) {
    if (key.required) return "**required**";
    return key.otherwise ? "`" + *key.otherwise + "`" : "";
}

std::string meaning_of(const Key& key) {
    if (!key.unless.empty()) {
        Key rest = key;
        rest.unless.clear();
        return fmt::format("{} Not with `{}`.", meaning_of(rest), key.unless);
    }
    if (!key.only_with) return key.meaning;
    const OnlyWith& only = *key.only_with;
    if (only.values.empty()) return fmt::format("{} Only with `{}`.", key.meaning, only.name());
    std::string values;
    for (const std::string& value : only.values) values += (values.empty() ? "" : " \\| ") + value;
    return fmt::format("{} Only with `\"{}\": {}`.", key.meaning, only.name(), values);
}

std::string sentence_of(const Group& group) {
    const std::string_view count = group.count == Count::exactly_one   ? "Exactly one"
                                   : group.count == Count::exactly_two ? "Exactly two"
                                                                       : "At most one";
    return fmt::format("{} of {}.\n\n", count, code_list(group.keys));
}

/// "/bodies/#/disk" as "bodies / # / disk" with readable place-holders.
std::string heading_of(const std::string& path) {
    std::string heading = "`";
    for (const char letter : path) {
        if (letter == '*') {
            heading += "NAME";
        } else if (letter == '#') {
            heading += "[ ]";
        } else {
            heading += letter;
        }
    }
    return heading + "`";
}

void add_section(std::string& page, const SpecificationNode& node, const std::string& heading) {
    const Key& key = *node.key;
    if (key.kind == Kind::object) {
        page += fmt::format("## {}\n\n{}\n\n", heading, key.meaning);
        for (const Group* group : node.groups) page += sentence_of(*group);
        page += "| key | type | default | meaning |\n| --- | --- | --- | --- |\n";
        for (const SpecificationNode& child : node.children) {
            if (child.key->kind == Kind::later) continue;
            page += fmt::format("| `{}` | {} | {} | {} |\n", child.name, type_of(*child.key), default_of(*child.key),
                                meaning_of(*child.key));
        }
        page += '\n';
    }
    for (const SpecificationNode& child : node.children) add_section(page, child, heading_of(child.key->path));
}

void add_arrays(std::string& page, const char* file, std::span<const ArrayInfo> arrays) {
    page += fmt::format("### {}\n\n| array | components | unit | meaning |\n| --- | --- | --- | --- |\n", file);
    for (const ArrayInfo& array : arrays)
        page += fmt::format("| `{}` | {} | {} | {}{} |\n", array.name, array.components, array.unit, array.meaning,
                            array.only.empty() ? "" : fmt::format(" Only if {}.", array.only));
    page += '\n';
}

void add_later(std::string& page) {
    const auto is_later = [](const Key& key) { return key.kind == Kind::later || !key.later_words.empty(); };
    if (std::none_of(scene_keys().begin(), scene_keys().end(), is_later)) return;
    page += "## Not in this version\n\nThese names are kept for later versions; a scene that uses them is refused.\n\n";
    for (const Key& key : scene_keys()) {
        if (key.kind == Kind::later) page += fmt::format("* {}\n", heading_of(key.path));
        if (!key.later_words.empty())
            page += fmt::format("* {}: {}\n", heading_of(key.path), code_list(key.later_words));
    }
}

} // namespace

std::string key_tables(const SpecificationNode& specification, const std::string& heading) {
    std::string page;
    add_section(page, specification, heading);
    return page;
}

std::string scene_reference() {
    std::string page = reference_introduction;
    page += key_tables(scene_specification(), "The scene");
    page += result_arrays;
    add_arrays(page, "Particles: particles.pvd", particle_arrays());
    add_arrays(page, "The grid's nodes: grid.pvd", grid_arrays());
    add_arrays(page, "Contact pairs at nodes: contact.pvd", contact_arrays());
    add_arrays(page, "Contact nodes taken apart, the particles seen: clouds/cloud_….vtu", cloud_arrays());
    add_arrays(page, "Contact nodes taken apart, the planes of all methods: clouds/plane_….vtp", plane_arrays());
    add_later(page);
    return page;
}

} // namespace abut

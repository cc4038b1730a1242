#include "io/scene/specification.h"

#include "io/scene/specification_sections.h"

#include <algorithm>

namespace abut {

namespace {

std::vector<Key> all_keys() {
    std::vector<Key> keys;
    for (const auto& section : {general_keys(), output_keys(), matter_keys(), contact_keys(), boundary_keys()})
        keys.insert(keys.end(), section.begin(), section.end());
    return keys;
}

SpecificationNode& child_of(SpecificationNode& parent, const std::string& name) {
    for (SpecificationNode& child : parent.children)
        if (child.name == name) return child;
    return parent.children.emplace_back(SpecificationNode{name, nullptr, {}, {}});
}

SpecificationNode& descend(SpecificationNode& root, const std::string& path) {
    SpecificationNode* node = &root;
    for (std::size_t begin = 1; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        node = &child_of(*node, path.substr(begin, end - begin));
        begin = end + 1;
    }
    return *node;
}

} // namespace

SpecificationNode make_specification(const std::vector<Key>& keys, const std::vector<Group>& groups) {
    SpecificationNode root;
    for (const Key& key : keys) descend(root, key.path).key = &key;
    for (const Group& group : groups) descend(root, group.path).groups.push_back(&group);
    return root;
}

const SpecificationNode* SpecificationNode::find(std::string_view child) const {
    for (const SpecificationNode& node : children)
        if (node.name == child) return &node;
    return nullptr;
}

const std::vector<Key>& scene_keys() {
    static const std::vector<Key> keys = all_keys();
    return keys;
}

const std::vector<Group>& scene_groups() {
    static const std::vector<Group> groups{
        {"/time", {"cfl", "step"}, Count::at_most_one},
        {"/materials/*",
         {"bulk_modulus", "shear_modulus", "youngs_modulus", "poissons_ratio", "lame_lambda"},
         Count::exactly_two},
        {"/shapes/*", shape_kinds(), Count::exactly_one},
        {"/bodies/#", shape_kinds(), Count::exactly_one},
        {"/images/#", {"pixel", "size"}, Count::at_most_one},
        {"/images/#/legend/#", {"grey", "rgb", "grey_range"}, Count::exactly_one},
        {"/boundaries/#", {"wall", "velocity", "traction"}, Count::exactly_one},
        {"/boundaries/#/traction", {"stress", "pressure"}, Count::exactly_one},
    };
    return groups;
}

const SpecificationNode& scene_specification() {
    static const SpecificationNode root = make_specification(scene_keys(), scene_groups());
    return root;
}

std::vector<std::string> key_names(const SpecificationNode& object) {
    std::vector<std::string> names;
    for (const SpecificationNode& child : object.children)
        if (child.key->kind != Kind::later) names.push_back(child.name);
    return names;
}

} // namespace abut

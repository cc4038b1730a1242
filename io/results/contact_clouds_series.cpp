#include "io/results/write_contact_clouds.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace abut {

namespace {

/// A series that the scene asks for and the node that it shows now.
template <int D>
struct Choice {
    std::string series;
    Index<D> node;
};

template <int D>
std::vector<Choice<D>> choices_of(const State<D>& state, const ContactCloudsSpec& spec) {
    std::vector<Choice<D>> choices;
    for (const std::array<int, 3>& chosen : spec.nodes) {
        Index<D> node;
        std::copy_n(chosen.begin(), D, node.begin());
        choices.push_back({fmt::format("{}", fmt::join(node, "_")), node});
    }
    for (std::size_t k = 0; k < spec.near.size(); ++k)
        if (const auto nearest = nearest_contact_node<D>(state, to_vec<D>(spec.near[k])))
            choices.push_back({fmt::format("near_{}", k), *nearest});
    return choices;
}

/// Enters the files of one suffix in a series of clouds and one of planes.
void enter(CloudSeries& series, const std::filesystem::path& folder, const std::string& choice, double time,
           const std::string& suffix) {
    for (const auto& [kind, extension] : {std::pair{"cloud", "vtu"}, {"plane", "vtp"}}) {
        const std::string name = fmt::format("{}_{}", kind, choice);
        auto known = series.by_name.find(name);
        if (known == series.by_name.end()) {
            const std::filesystem::path path = folder / (name + ".pvd");
            known = series.by_name.emplace(name, std::filesystem::exists(path) ? read_pvd(path) : PvdSeries{path, {}})
                        .first;
        }
        known->second.append(time, fmt::format("{}_{}.{}", kind, suffix, extension));
    }
}

/// The table beside the clouds or planes of an entry.
std::string table_beside(const std::string& file) {
    const std::size_t begin = file.find('_');
    return "node" + file.substr(begin, file.rfind('.') - begin) + ".csv";
}

} // namespace

CloudSeries read_cloud_series(const std::filesystem::path& results) {
    CloudSeries series;
    const std::filesystem::path folder = results / "clouds";
    if (!std::filesystem::is_directory(folder)) return series;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".pvd" && (name.starts_with("cloud_") || name.starts_with("plane_")))
            series.by_name.emplace(name, read_pvd(entry.path()));
    }
    return series;
}

void cut_cloud_series(CloudSeries& series, double time) {
    for (auto& [name, pvd] : series.by_name) {
        const std::size_t before = pvd.entries.size();
        const std::string kind = name.substr(0, name.find('_') + 1);
        while (!pvd.entries.empty() && pvd.entries.back().time > time) {
            const std::string file = pvd.entries.back().file;
            pvd.entries.pop_back();
            if (!file.starts_with(kind) || file.find('/') != std::string::npos) continue; // not by this program
            std::filesystem::remove(pvd.path.parent_path() / file);
            std::filesystem::remove(pvd.path.parent_path() / table_beside(file));
        }
        if (pvd.entries.empty())
            std::filesystem::remove(pvd.path);
        else if (pvd.entries.size() < before)
            pvd.write();
    }
    std::erase_if(series.by_name, [](const auto& one) { return one.second.entries.empty(); });
}

template <int D>
void write_contact_clouds(State<D>& state, const std::filesystem::path& results, int frame, CloudSeries& series) {
    const ContactCloudsSpec& spec = *state.scene.output.contact_clouds;
    const std::filesystem::path folder = results / "clouds";
    const std::vector<Choice<D>> choices = choices_of(state, spec);
    std::vector<Index<D>> nodes; // each once
    for (const Choice<D>& choice : choices)
        if (std::find(nodes.begin(), nodes.end(), choice.node) == nodes.end()) nodes.push_back(choice.node);
    for (const NodeSeen<D>& node : inspect_contact<D>(state, nodes))
        write_node_files<D>(state, {node}, folder, node_file_suffix<D>(frame, node.node));
    for (const Choice<D>& choice : choices)
        enter(series, folder, choice.series, state.time, node_file_suffix<D>(frame, choice.node));
    if (!spec.disagreement) return;
    nodes.clear();
    for (const Disagreement<D>& one : nodes_in_disagreement(state, *spec.disagreement)) nodes.push_back(one.node);
    const std::string suffix = fmt::format("{:05}", frame);
    write_node_files<D>(state, inspect_contact<D>(state, nodes), folder, suffix);
    enter(series, folder, "disagreement", state.time, suffix);
}

template void write_contact_clouds<2>(State<2>&, const std::filesystem::path&, int, CloudSeries&);
template void write_contact_clouds<3>(State<3>&, const std::filesystem::path&, int, CloudSeries&);

} // namespace abut

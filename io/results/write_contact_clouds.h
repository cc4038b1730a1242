#pragma once
/// \file write_contact_clouds.h
/// Contact nodes taken apart (contact/inspect.h) as files for ParaView and spreadsheets. Three files for a node, or for
/// several together, in SI units:
///
/// * cloud_….vtu: the deformed domains of the particles that the search saw (quadrilaterals, hexahedra), once for each
///   pair of bodies at the node, with cloud_arrays() (results/arrays.h).
/// * plane_….vtp: the plane of each method (2D a segment, 3D a square) halfway between both edges, as wide as the
///   cloud, with plane_arrays(). A method that finds no normal has no plane here, but a row in the table.
/// * node_….csv: the same side by side, a row for each pair and method.
///
/// Field data: TimeValue, `step`, `units`, `body_names`, `method_names`; for one node `node` and `node_position` [m]
/// too.

#include "contact/inspect.h"
#include "io/results/pvd.h"
#include "results/frame.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace abut {

/// What is in cloud_….vtu and plane_….vtp.
template <int D>
CellFrame cloud_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);
template <int D>
CellFrame plane_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);
/// What is in node_….csv; names of bodies and methods as texts, `inf` and `nan` where there is no plane.
template <int D>
std::string node_table(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);

/// "00012_7_3": number of the frame and of the node along the axes, as in the names of its files.
template <int D>
std::string node_file_suffix(int frame, const Index<D>& node);

/// Makes the folder for such files if need be. Throws std::runtime_error "FOLDER: CAUSE" if it can't.
void make_node_folder(const std::filesystem::path& folder);

/// Writes cloud_SUFFIX.vtu, plane_SUFFIX.vtp and node_SUFFIX.csv to a folder, which is made if need be; each appears
/// complete or not at all. \return the three files. Throws as write_cells().
template <int D>
std::vector<std::filesystem::path> write_node_files(const State<D>& state, const std::vector<NodeSeen<D>>& nodes,
                                                    const std::filesystem::path& folder, const std::string& suffix);

/// Series of a run under way, by the names of their files without the extension.
struct CloudSeries {
    std::map<std::string, PvdSeries> by_name;
};

/// The series of clouds that are in a result folder. Throws as read_pvd().
CloudSeries read_cloud_series(const std::filesystem::path& results);
/// Takes the entries after `time` out of the series and removes their files, for a run that goes on from there.
void cut_cloud_series(CloudSeries& series, double time);

/// What `output.contact_clouds` of the scene asks for (which must be given), to RESULTS/clouds: three files for each
/// chosen node, and three for all nodes in disagreement together (cloud_FRAME.vtu, …); series for ParaView for each
/// choice, which continue those in `series` (and at their first frame those on the disk): cloud_I_J.pvd,
/// cloud_near_K.pvd (K: place in `near`, from 0; the nearest contact node may change), cloud_disagreement.pvd, and the
/// same of planes. A chosen node that is no contact node at the time gets files without cells. The state must have been
/// `look`ed at.
template <int D>
void write_contact_clouds(State<D>& state, const std::filesystem::path& results, int frame, CloudSeries& series);

} // namespace abut

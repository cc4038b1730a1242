#include "io/checkpoint/hdf5_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>

#include <cerrno>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace abut {

namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& cause) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), cause));
}

/// An HDF5 identifier that is closed at the end of its scope.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    operator hid_t() const { return id_; } // NOLINT(google-explicit-constructor): what HDF5's functions take
    bool good() const { return id_ >= 0; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// HDF5 prints its errors unless told not to. Where the disk was full it cannot close a file, keeps it, and crashes
/// when it closes all files at the end of the program; it must not do that then. Files are closed here, each.
void mute() {
    H5dont_atexit(); // heeded before the first other call
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::size_t count(const Shape& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Handle space_of(const Shape& shape) {
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose};
}

} // namespace

// === Writing

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, std::filesystem::path shown) : shown_(std::move(shown)) {
    mute();
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    if (file_ < 0) fail(shown_, fmt::format("cannot write: {}", std::strerror(errno)));
}

Hdf5Writer::~Hdf5Writer() {
    if (file_ >= 0) H5Fclose(file_);
}

void Hdf5Writer::write(const std::string& name, std::int64_t type, const void* values, const Shape& shape) {
    errno = 0;
    const Handle space = space_of(shape);
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links, 1);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false); // the same state gives the same bytes
    const Handle data(H5Dcreate2(file_, name.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose);
    if (!data.good() || (count(shape) > 0 && H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0))
        fail(shown_, fmt::format("cannot write: {}", errno != 0 ? std::strerror(errno) : "HDF5 refuses " + name));
}

void Hdf5Writer::reals(const std::string& name, std::span<const double> values, const Shape& shape) {
    if (values.size() != count(shape)) throw std::invalid_argument(name + ": values and shape don't fit");
    write(name, H5T_NATIVE_DOUBLE, values.data(), shape);
}

void Hdf5Writer::integers(const std::string& name, std::span<const std::int64_t> values, const Shape& shape) {
    if (values.size() != count(shape)) throw std::invalid_argument(name + ": values and shape don't fit");
    write(name, H5T_NATIVE_INT64, values.data(), shape);
}

void Hdf5Writer::text(const std::string& name, std::string_view text) {
    write(name, H5T_NATIVE_CHAR, text.data(), {text.size()});
}

void Hdf5Writer::close() {
    errno = 0;
    if (file_ >= 0 && H5Fclose(std::exchange(file_, -1)) < 0)
        fail(shown_, fmt::format("cannot write: {}", errno != 0 ? std::strerror(errno) : "HDF5 cannot close the file"));
}

// === Reading

namespace {

/// Whether the values of a data set stand in the file as Hdf5Writer puts them: one behind the other, `bytes` of them.
/// Others, packed or in pieces or in other files, are what hostile files would use to make HDF5 allocate or read
/// elsewhere.
bool lies_in_file(hid_t data, std::uintmax_t bytes, std::uintmax_t file_bytes) {
    const Handle creation(H5Dget_create_plist(data), H5Pclose);
    if (!creation.good() || H5Pget_layout(creation) != H5D_CONTIGUOUS || H5Pget_external_count(creation) != 0 ||
        H5Pget_nfilters(creation) != 0)
        return false;
    const haddr_t begin = H5Dget_offset(data);
    return begin != HADDR_UNDEF && begin <= file_bytes && bytes <= file_bytes - begin;
}

} // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path) {
    mute();
    if (!std::filesystem::is_regular_file(path)) fail(path, "no such file");
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0) fail(path, "cannot read: no HDF5 file, or a broken one");
}

Hdf5Reader::~Hdf5Reader() {
    if (file_ >= 0) H5Fclose(file_);
}

bool Hdf5Reader::has(const std::string& name) const {
    // Of "a/b" HDF5 wants "a" to be asked for first.
    for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
        if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

Shape Hdf5Reader::shape_of(const std::string& name) const {
    const Handle data(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
    if (!data.good()) fail(path_, fmt::format("cannot read: no array \"{}\"", name));
    const Handle space(H5Dget_space(data), H5Sclose);
    const int axes = space.good() ? H5Sget_simple_extent_ndims(space) : -1;
    if (axes < 0 || axes > 4) fail(path_, fmt::format("cannot read: \"{}\" is no array", name));
    std::vector<hsize_t> extents(static_cast<std::size_t>(axes));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return {extents.begin(), extents.end()};
}

std::size_t Hdf5Reader::rows(const std::string& name, std::size_t columns, std::size_t most) const {
    const Shape shape = shape_of(name);
    const bool fits = columns == 0 ? shape.size() == 1 : shape.size() == 2 && shape[1] == columns;
    if (!fits || shape[0] > most)
        fail(path_, fmt::format("\"{}\" has the extents {}, which cannot be", name, fmt::join(shape, " x ")));
    return shape[0];
}

void Hdf5Reader::read(const std::string& name, std::int64_t type, void* values, const Shape& shape) const {
    const Shape found = shape_of(name);
    if (found != shape)
        fail(path_, fmt::format("\"{}\" has the extents {} instead of {}", name, fmt::join(found, " x "),
                                fmt::join(shape, " x ")));
    const Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle stored(H5Dget_type(data), H5Tclose);
    if (H5Tequal(stored, type) <= 0) fail(path_, fmt::format("\"{}\" has values of another type", name));
    if (count(shape) == 0) return;
    if (!lies_in_file(data, count(shape) * H5Tget_size(type), std::filesystem::file_size(path_)))
        fail(path_, fmt::format("cannot read: the values of \"{}\" are not in the file", name));
    if (H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        fail(path_, fmt::format("cannot read: \"{}\" is broken", name));
}

std::vector<double> Hdf5Reader::reals(const std::string& name, const Shape& shape) const {
    if (shape_of(name) != shape) read(name, H5T_NATIVE_DOUBLE, nullptr, shape); // says what is wrong
    std::vector<double> values(count(shape));
    read(name, H5T_NATIVE_DOUBLE, values.data(), shape);
    return values;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& name, const Shape& shape) const {
    if (shape_of(name) != shape) read(name, H5T_NATIVE_INT64, nullptr, shape); // says what is wrong
    std::vector<std::int64_t> values(count(shape));
    read(name, H5T_NATIVE_INT64, values.data(), shape);
    return values;
}

std::string Hdf5Reader::text(const std::string& name, std::size_t longest) const {
    std::string text(rows(name, 0, longest), ' ');
    read(name, H5T_NATIVE_CHAR, text.data(), {text.size()});
    return text;
}

} // namespace abut

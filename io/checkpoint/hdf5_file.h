#pragma once
/// \file hdf5_file.h
/// HDF5 files as named arrays of reals and whole numbers and named texts: all that a checkpoint needs of HDF5.
/// Every failure throws std::runtime_error "FILE: CAUSE"; HDF5 itself prints nothing.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut {

/// Extents of an array, the slowest first.
using Shape = std::vector<std::size_t>;

/// A new file. Names may have groups: "particles/position".
class Hdf5Writer {
public:
    /// Creates or replaces `path`. \param shown name of the file in messages
    Hdf5Writer(const std::filesystem::path& path, std::filesystem::path shown);
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;
    ~Hdf5Writer();

    void reals(const std::string& name, std::span<const double> values, const Shape& shape);
    void integers(const std::string& name, std::span<const std::int64_t> values, const Shape& shape);
    void text(const std::string& name, std::string_view text);
    void close(); ///< reports what the destructor would swallow

private:
    void write(const std::string& name, std::int64_t type, const void* values, const Shape& shape);

    std::filesystem::path shown_;
    std::int64_t file_ = -1;
};

/// A file to read. What a file claims of itself is believed only after it has been checked: an array is read if it has
/// the shape that the reader expects, and nothing is allocated before.
class Hdf5Reader {
public:
    explicit Hdf5Reader(const std::filesystem::path& path);
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;
    ~Hdf5Reader();

    bool has(const std::string& name) const;
    /// Number of rows (the slowest extent) of an array of `columns`; 0 columns: of one extent. At most `most`.
    std::size_t rows(const std::string& name, std::size_t columns, std::size_t most) const;
    std::vector<double> reals(const std::string& name, const Shape& shape) const;
    std::vector<std::int64_t> integers(const std::string& name, const Shape& shape) const;
    std::string text(const std::string& name, std::size_t longest) const;

    const std::filesystem::path& path() const { return path_; }

private:
    Shape shape_of(const std::string& name) const;
    void read(const std::string& name, std::int64_t type, void* values, const Shape& shape) const;

    std::filesystem::path path_;
    std::int64_t file_ = -1;
};

} // namespace abut

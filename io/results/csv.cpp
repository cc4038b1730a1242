#include "io/results/csv.h"

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace abut {
namespace {

constexpr std::size_t buffer_size = 1 << 16; // bytes before the buffer is written unasked

void append_cell(std::string& buffer, std::string_view text) {
    buffer += csv_cell(text);
}
void append_cell(std::string& buffer, double value) {
    fmt::format_to(std::back_inserter(buffer), "{}", value);
}
void append_cell(std::string& buffer, std::int64_t value) {
    fmt::format_to(std::back_inserter(buffer), "{}", value);
}

std::string header(const std::vector<std::string>& columns) {
    std::string line;
    for (const std::string& name : columns) line += (line.empty() ? "" : ",") + csv_cell(name);
    return line + '\n';
}

} // namespace

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

CsvTable::CsvTable(const std::filesystem::path& path, const std::vector<std::string>& columns)
    : file_(path), columns_(columns.size()), buffer_(header(columns)) {
    flush();
}

CsvTable::CsvTable(const std::filesystem::path& path, const std::vector<std::string>& columns, std::uintmax_t bytes)
    : file_(OutputFile::continued(path, bytes)), columns_(columns.size()), bytes_(bytes) {}

CsvTable::~CsvTable() {
    try {
        flush();
    } catch (const std::exception&) { // a destructor cannot report it
    }
}

void CsvTable::row(std::span<const Value> values) {
    for (const Value& value : values) {
        std::visit([&](const auto& v) { append_cell(buffer_, v); }, value);
        buffer_ += ',';
    }
    end_row(values.size());
}

void CsvTable::row(std::span<const double> values) {
    for (const double value : values) {
        append_cell(buffer_, value);
        buffer_ += ',';
    }
    end_row(values.size());
}

void CsvTable::end_row(std::size_t values) {
    if (values != columns_)
        throw std::logic_error(fmt::format("a row of {} values in a table of {} columns", values, columns_));
    if (values > 0) buffer_.pop_back();
    buffer_ += '\n';
    if (buffer_.size() > buffer_size) flush();
}

void CsvTable::flush() {
    if (buffer_.empty()) return;
    const std::string rows = std::exchange(buffer_, {}); // a failed write is reported once, not again by the destructor
    file_.write(rows);
    bytes_ += rows.size();
}

void CsvTable::sync() {
    flush();
    file_.sync();
}

void check_continued(const std::filesystem::path& path, const std::vector<std::string>& columns, std::uintmax_t bytes) {
    const auto refuse = [&](const std::string& what) {
        throw std::runtime_error(fmt::format("{}: {}; put back the table that the run had written, or start anew with "
                                             "--overwrite",
                                             path.string(), what));
    };
    if (!std::filesystem::exists(path)) refuse(fmt::format("no such file, and the run has {} bytes in it", bytes));
    if (!std::filesystem::is_regular_file(path)) refuse("is no regular file");
    const std::uintmax_t size = std::filesystem::file_size(path);
    if (size < bytes) refuse(fmt::format("has {} bytes instead of at least {}: it has been changed", size, bytes));
    const std::string expected = header(columns);
    std::string found(expected.size(), ' ');
    char last = 0;
    std::ifstream file(path, std::ios::binary);
    file.read(found.data(), static_cast<std::streamsize>(found.size()));
    if (!file || found != expected) refuse("has other columns than this run");
    file.seekg(static_cast<std::streamoff>(bytes) - 1);
    if (!file.get(last) || last != '\n')
        refuse(fmt::format("no row ends after {} bytes, where the run goes on: it has been changed", bytes));
}

} // namespace abut

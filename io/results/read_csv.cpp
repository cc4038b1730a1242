#include "io/results/read_csv.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <system_error>

namespace abut {
namespace {

std::string read_all(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path))
        throw std::runtime_error(path.string() + ": cannot read: it is a folder, not a table");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (file.bad()) throw std::runtime_error(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
    return text;
}

/// Takes rows off a text, one after the other.
class Rows {
public:
    explicit Rows(std::string_view text) : text_(text) {}

    /// The cells of the next whole row; false if there is none.
    bool next(std::vector<std::string>& cells) {
        cells.assign(1, "");
        first_line_ = line_;
        bool quoted = false;
        for (std::size_t i = at_; i < text_.size(); ++i) {
            const char c = text_[i];
            if (c == '\n') ++line_;
            if (quoted) {
                if (c != '"')
                    cells.back() += c;
                else if (i + 1 < text_.size() && text_[i + 1] == '"')
                    cells.back() += text_[++i];
                else
                    quoted = false;
            } else if (c == '"') {
                quoted = true;
            } else if (c == ',') {
                cells.emplace_back();
            } else if (c == '\n') {
                at_ = i + 1;
                return true;
            } else if (c != '\r') {
                cells.back() += c;
            }
        }
        return false;
    }
    /// Where the row that was taken last begins, from 1.
    std::size_t line() const { return first_line_; }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1, first_line_ = 1;
};

/// A cell as it can be shown in a message.
std::string shown(const std::string& cell) {
    std::string text;
    for (const char c : cell.substr(0, 40)) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return cell.size() > 40 ? text + "..." : text;
}

void check_header(const CsvFile& table) {
    std::set<std::string> seen;
    for (const CsvColumn& column : table.columns)
        if (!seen.insert(column.name).second)
            throw std::runtime_error(
                fmt::format("{}: line 1: two columns \"{}\"", table.path.string(), shown(column.name)));
}

} // namespace

const CsvColumn* CsvFile::find(std::string_view name) const {
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

std::vector<std::string> CsvFile::names() const {
    std::vector<std::string> result;
    for (const CsvColumn& column : columns) result.push_back(column.name);
    return result;
}

CsvFile read_csv(const std::filesystem::path& path, const std::vector<std::string>& words) {
    const std::string text = read_all(path);
    CsvFile table{path, {}, 0};
    Rows rows(text);
    std::vector<std::string> cells;
    if (!rows.next(cells))
        throw std::runtime_error(path.string() + ": cannot read: there is no whole row of names yet");
    for (const std::string& name : cells) table.columns.push_back({name, {}, {}});
    check_header(table);
    std::vector<bool> is_words;
    for (const CsvColumn& column : table.columns)
        is_words.push_back(std::find(words.begin(), words.end(), column.name) != words.end());

    while (rows.next(cells)) {
        const auto fail = [&](const std::string& cause) {
            throw std::runtime_error(fmt::format("{}: line {}: {}", path.string(), rows.line(), cause));
        };
        if (cells.size() != table.columns.size())
            fail(fmt::format("{} values for {} columns", cells.size(), table.columns.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            CsvColumn& column = table.columns[i];
            const std::string& cell = cells[i];
            if (is_words[i]) {
                column.words.push_back(cell);
                continue;
            }
            double value = 0;
            const char* const end = cell.data() + cell.size();
            const auto [stop, error] = std::from_chars(cell.data(), end, value);
            if (error != std::errc() || stop != end)
                fail(fmt::format("column \"{}\": \"{}\" is no number", shown(column.name), shown(cell)));
            column.numbers.push_back(value);
        }
        ++table.rows;
    }
    return table;
}

} // namespace abut

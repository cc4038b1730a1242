#include "app_support.h"

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>

namespace abut::app_test {

namespace fs = std::filesystem;

namespace {

std::string read_all(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// In the child: sets everything up and becomes the program; never returns.
[[noreturn]] void become_program(const fs::path& folder, const fs::path& said, const Arguments& arguments,
                                 std::size_t largest_file) {
    std::vector<const char*> argv{ABUT_PROGRAM};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    argv.push_back(nullptr);
    const auto redirect = [](const fs::path& file, int descriptor) {
        const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(126);
    };
    redirect(said.string() + ".out", STDOUT_FILENO);
    redirect(said.string() + ".err", STDERR_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    if (largest_file > 0) {
        const rlimit limit{largest_file, largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(ABUT_PROGRAM, const_cast<char**>(argv.data())); // NOLINT: execv takes no const
    ::_exit(127);
}

} // namespace

Folder::Folder() {
    static int count = 0;
    path_ = fs::temp_directory_path() / ("abut-app-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    said_ = path_.string() + "-said";
    fs::remove_all(path_);
    fs::create_directories(path_);
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    for (const char* stream : {".out", ".err"}) fs::remove(said_.string() + stream, ignored);
}

void Folder::write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
    EXPECT_TRUE(fs::is_regular_file(path_ / name)) << name;
    return read_all(path_ / name);
}

std::map<std::string, std::uintmax_t> Folder::content() const {
    std::map<std::string, std::uintmax_t> found;
    for (const auto& entry : fs::recursive_directory_iterator(path_))
        found[fs::relative(entry.path(), path_).string()] = entry.is_regular_file() ? entry.file_size() : 0;
    return found;
}

pid_t Folder::start(const Arguments& arguments, std::size_t largest_file) const {
    const pid_t process = ::fork();
    if (process == 0) become_program(path_, said_, arguments, largest_file);
    return process;
}

Outcome Folder::end_of(pid_t process) const {
    int status = 0;
    ::waitpid(process, &status, 0);
    return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_all(said_.string() + ".out"),
            read_all(said_.string() + ".err")};
}

Outcome Folder::abut(const Arguments& arguments, std::size_t largest_file) const {
    return end_of(start(arguments, largest_file));
}

Json small_scene() {
    return Json::parse(R"({
  "title": "A disk hits a block",
  "grid": { "cell": "1 mm", "lower": [0, 0], "upper": ["12 mm", "12 mm"] },
  "time": { "end": "0.4 ms" },
  "method": { "shape": "ugimp", "transfer": { "scheme": "xpic", "order": 2 } },
  "materials": { "rubber": { "model": "neo-hookean", "density": "1 g/cm^3",
                             "youngs_modulus": "10 MPa", "poissons_ratio": 0.33 } },
  "bodies": [
    { "name": "block", "material": "rubber", "box": { "lower": ["2 mm", 0], "upper": ["10 mm", "4 mm"] } },
    { "name": "ball", "material": "rubber", "disk": { "center": ["6 mm", "6.6 mm"], "radius": "2.5 mm" },
      "velocity": ["1 m/s", "-5 m/s"] }
  ],
  "contact": { "law": { "type": "friction", "coefficient": 0.2 } },
  "boundaries": [ { "name": "floor", "wall": { "axis": "y", "side": "lower", "position": 0 } } ],
  "gravity": [0, "-9.81 m/s^2"],
  "output": { "every": "0.1 ms", "history_every": "10 us" }
})");
}

Json small_scene(const std::vector<std::string>& patches) {
    Json scene = small_scene();
    for (const std::string& patch : patches) scene.merge_patch(Json::parse(patch));
    return scene;
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

std::vector<std::vector<std::string>> table(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : lines(csv)) {
        std::vector<std::string>& row = rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    }
    return rows;
}

std::map<std::string, std::string> results_in(const Folder& folder, const std::string& results) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / results)) {
        const std::string name = std::filesystem::relative(entry.path(), folder / results).string();
        if (entry.is_regular_file() && name != "timing.json" && name != "checkpoint-previous.h5")
            files[name] = folder.read(results + "/" + name);
    }
    return files;
}

void expect_same_results(const Folder& folder, const std::string& a, const std::string& b, const std::string& what) {
    const auto first = results_in(folder, a);
    const auto second = results_in(folder, b);
    EXPECT_GT(first.size(), 5U) << what;
    for (const auto& [name, bytes] : first) {
        const auto found = second.find(name);
        if (found == second.end())
            ADD_FAILURE() << what << ": " << name << " is not in " << b;
        else
            EXPECT_TRUE(found->second == bytes) << what << ": " << name << " differs";
    }
    EXPECT_EQ(first.size(), second.size()) << what;
}

} // namespace abut::app_test

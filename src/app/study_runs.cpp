#include "app/study_runs.h"

#include "app/child_process.h"
#include "io/results/checksum.h"
#include "io/results/write_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

namespace abut {

namespace {

volatile std::sig_atomic_t stopped = 0; // NOLINT: all that a signal handler may set

void on_signal(int) {
    stopped = 1;
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Host name and processor.
std::string this_machine() {
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return fmt::format("{}, {}", host, line.substr(line.find(':') + 2));
    return host;
}

/// The first line of what a run said that is a complaint.
std::string complaint(const std::filesystem::path& log) {
    std::ifstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line.find(": advice: ") != std::string::npos) continue;
        return line.starts_with("abut: ") ? line.substr(6) : line;
    }
    return "it said nothing";
}

/// A run under way.
struct Running {
    StudyTask task;
    std::filesystem::path results;
    std::filesystem::path log;
    bool alone = true;
    ChildProcess process;
};

Running start(const Study& study, const Variant& variant, const StudyFolder& folder, const StudyTask& task,
              bool alone) {
    const std::filesystem::path results =
        task.repeat == 0 ? folder.results(variant) : folder.repeat(variant, task.repeat);
    const std::filesystem::path log =
        task.repeat == 0 ? folder.log(variant) : std::filesystem::path(results.string() + ".txt");
    for (const std::filesystem::path& file : {results, log, folder.scene(variant), folder.record(variant)})
        std::filesystem::create_directories(file.parent_path());
    write_text_atomically(folder.scene(variant), variant.scene.resolved);
    std::filesystem::remove_all(results); // of an earlier run, which may have had other files
    const std::vector<std::string> arguments{
        "run",       folder.scene(variant).string(),  "-o",      results.string(),
        "--threads", std::to_string(variant.threads), "--quiet", "--count-instructions"};
    return {task, results, log, alone, ChildProcess(arguments, log, study.time_limit)};
}

/// Enters what a run has left into the record of its variant.
void enter(const Running& run, const ChildEnd& end, const Study& study, const std::string& machine, RunRecord& record) {
    const std::string timing = read_text(run.results / "timing.json");
    if (end.exit_code == 0) {
        try {
            Cost cost = cost_of(timing);
            cost.alone = run.alone;
            cost.machine = machine;
            const std::string history = checksum_of_file(run.results / "history.csv");
            if (record.history.empty()) record.history = history;
            record.repeats_agree = record.repeats_agree && record.history == history;
            record.costs.push_back(std::move(cost));
            record.status = Status::done;
        } catch (const std::exception& error) {
            record.status = Status::failed;
            record.cause = fmt::format("its results can't be read: {}", error.what());
        }
        return;
    }
    const bool trouble = timing.find("\"trouble\"") != std::string::npos;
    record.status = end.exit_code == 1 && trouble ? Status::unstable : Status::failed;
    record.cause = end.over_time ? fmt::format("over its time limit of {:g} s", *study.time_limit)
                   : end.signal  ? fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal))
                                 : complaint(run.log);
}

/// Catches SIGINT and SIGTERM while it lives.
class Signals {
public:
    Signals() {
        stopped = 0;
        struct sigaction action {};
        action.sa_handler = on_signal;
        for (std::size_t i = 0; i < 2; ++i) ::sigaction(numbers[i], &action, &before_[i]);
    }
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;
    ~Signals() {
        for (std::size_t i = 0; i < 2; ++i) ::sigaction(numbers[i], &before_[i], nullptr);
    }

private:
    static constexpr int numbers[2] = {SIGINT, SIGTERM};
    struct sigaction before_[2];
};

/// Sleeps until something may have happened: long enough to cost the runs nothing, short against their times.
void wait_a_little(std::chrono::steady_clock::time_point since) {
    using namespace std::chrono;
    const auto passed = duration_cast<milliseconds>(steady_clock::now() - since);
    std::this_thread::sleep_for(std::clamp<milliseconds>(passed / 50, 1ms, 50ms));
}

} // namespace

std::filesystem::path StudyFolder::repeat(const Variant& variant, int repeat) const {
    return path / "repeats" / fmt::format("{}-{}", variant.folder, repeat + 1);
}

RunRecord StudyFolder::known(const Variant& variant) const {
    std::optional<RunRecord> known = read_record(record(variant));
    const bool usable = known && known->key == variant.key && known->status != Status::failed &&
                        (known->status != Status::done || std::filesystem::exists(results(variant) / "history.csv"));
    if (usable) return *known;
    RunRecord fresh;
    fresh.key = variant.key;
    return fresh;
}

std::vector<StudyTask> tasks_left(const std::vector<RunRecord>& records, int repeats,
                                  const std::function<bool(std::size_t)>& mine) {
    std::vector<StudyTask> tasks;
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (std::size_t v = 0; v < records.size(); ++v)
            if (mine(v) && !records[v].complete(repeats) && repeat >= static_cast<int>(records[v].costs.size()))
                tasks.push_back({v, repeat});
    return tasks;
}

bool do_tasks(const Study& study, const std::vector<Variant>& variants, const StudyFolder& folder,
              const std::vector<StudyTask>& tasks, int jobs, std::vector<RunRecord>& records, const RunDone& done) {
    const Signals signals;
    const std::string machine = this_machine();
    std::vector<Running> running;
    auto last_change = std::chrono::steady_clock::now();
    std::size_t next = 0, finished = 0;
    const auto out_of_order = [&](const StudyTask& task) {
        const Status status = records[task.variant].status;
        return status == Status::unstable || status == Status::failed;
    };
    while (!stopped && (next < tasks.size() || !running.empty())) {
        while (next < tasks.size() && static_cast<int>(running.size()) < jobs) {
            const StudyTask& task = tasks[next++];
            if (out_of_order(task)) { // by an earlier repeat
                done(++finished, task);
                continue;
            }
            running.push_back(start(study, variants[task.variant], folder, task, jobs == 1));
            last_change = std::chrono::steady_clock::now();
        }
        bool ended = false;
        for (std::size_t i = 0; i < running.size(); ++i) {
            const std::optional<ChildEnd> end = running[i].process.poll();
            if (!end) continue;
            const StudyTask task = running[i].task;
            if (end->exit_code == 130) { // someone has told it to stop
                stopped = 1;
                break;
            }
            enter(running[i], *end, study, machine, records[task.variant]);
            write_record(folder.record(variants[task.variant]), records[task.variant]);
            if (task.repeat > 0) {
                std::filesystem::remove_all(running[i].results);
                std::filesystem::remove(running[i].log);
            }
            running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
            ended = true;
            done(++finished, task);
            break;
        }
        if (!ended && !running.empty()) wait_a_little(last_change);
    }
    for (Running& run : running) run.process.stop();
    std::error_code ignored;
    std::filesystem::remove_all(folder.path / "repeats", ignored);
    return !stopped;
}

} // namespace abut

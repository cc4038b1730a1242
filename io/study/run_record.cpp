#include "io/study/run_record.h"

#include "io/results/write_text.h"
#include "io/scene/json.h"

#include <fstream>
#include <iterator>

namespace abut {

void write_record(const std::filesystem::path& file, const RunRecord& record) {
    Json costs = Json::array();
    for (const Cost& cost : record.costs) costs.push_back(Json::parse(cost_text(cost)));
    const Json json = {{"key", record.key},         {"status", status_word(record.status)},  {"cause", record.cause},
                       {"history", record.history}, {"repeats_agree", record.repeats_agree}, {"costs", costs}};
    write_text_atomically(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<RunRecord> read_record(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        const Json json = Json::parse(text);
        RunRecord record;
        record.key = json.at("key");
        record.cause = json.at("cause");
        record.history = json.at("history");
        record.repeats_agree = json.at("repeats_agree");
        for (const Json& cost : json.at("costs")) record.costs.push_back(cost_of(cost.dump()));
        for (const Status status : {Status::done, Status::unstable, Status::failed})
            if (json.at("status") == status_word(status)) record.status = status;
        return record;
    } catch (const std::exception&) { // then it is run again
        return {};
    }
}

} // namespace abut

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "core/bag_import/bag_plan.h"

namespace handmap {

namespace {

struct InfoArguments {
  std::string file;
  bool json = false;
};

double rateOf(const BagTopic& topic) {
  const double seconds = topic.last_s - topic.first_s;
  return topic.messages < 2 || seconds <= 0.0 ? 0.0
                                              : static_cast<double>(topic.messages - 1) / seconds;
}

double beginOf(const Bag& bag) {
  double begin_s = 0.0;
  for (const BagTopic& topic : bag.topics()) {
    if (topic.messages > 0 && (begin_s == 0.0 || topic.first_s < begin_s)) begin_s = topic.first_s;
  }
  return begin_s;
}

void printJson(const Bag& bag, const BagPlan& plan) {
  nlohmann::ordered_json topics = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"first_s", topic.first_s},
                      {"last_s", topic.last_s},
                      {"serves_as", plan.roleOf(i, bag)}});
  }
  const nlohmann::ordered_json json = {{"kind", bag.kind()}, {"topics", topics}};
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void printTable(const Bag& bag, const BagPlan& plan) {
  std::size_t name_width = 5;
  std::size_t type_width = 4;
  std::size_t messages = 0;
  double last_s = 0.0;
  for (const BagTopic& topic : bag.topics()) {
    name_width = std::max(name_width, topic.name.size());
    type_width = std::max(type_width, topic.type.size());
    messages += topic.messages;
    if (topic.messages > 0) last_s = std::max(last_s, topic.last_s);
  }
  const double begin_s = beginOf(bag);
  fmt::print("{}: {} of {} messages in {:.1f} s\n", bag.path().string(), bag.kind(), messages,
             messages > 0 ? last_s - begin_s : 0.0);
  const auto line = [&](auto... cells) {
    fmt::print("{:{}}  {:{}}  {:>8}  {:>7}  {:>8}  {:>8}  {}\n", cells...);
  };
  if (bag.topics().empty()) return;
  line("topic", name_width, "type", type_width, "messages", "rate_hz", "first_s", "last_s",
       "serves_as");
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    const bool any = topic.messages > 0;
    const std::string role = plan.roleOf(i, bag);
    line(topic.name, name_width, topic.type, type_width, topic.messages,
         any ? fmt::format("{:.1f}", rateOf(topic)) : "-",
         any ? fmt::format("{:.2f}", topic.first_s - begin_s) : "-",
         any ? fmt::format("{:.2f}", topic.last_s - begin_s) : "-", role.empty() ? "-" : role);
  }
}

int info(const InfoArguments& arguments) {
  const auto bag = openBag(arguments.file);
  const BagPlan plan = planOf(*bag, {});
  for (const std::string& note : bag->notes()) fmt::print(stderr, "handmap-cli: note: {}\n", note);
  if (arguments.json) {
    printJson(*bag, plan);
    return 0;
  }
  printTable(*bag, plan);
  fmt::print("{}\n", plan.seesAnything()
                         ? "import: what serves as something makes a recording"
                         : "import: nothing in it sees: no scans, no points, no pair of images "
                           "with camera infos");
  return 0;
}

}  // namespace

void addInfoCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand("info", "List what a bag of ROS 1 or ROS 2 holds");
  command->callback([&chosen, arguments] { chosen = [arguments] { return info(*arguments); }; });
  command
      ->add_option("file", arguments->file,
                   "A .bag, .mcap or .db3 file, or the folder of a ROS 2 bag")
      ->required()
      ->option_text("FILE");
  command->add_flag("--json", arguments->json, "As JSON; times as they are, not from the first");
}

}  // namespace handmap

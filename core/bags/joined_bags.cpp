#include "core/bags/bag_kinds.h"

namespace handmap {

namespace {

class JoinedBags : public Bag {
 public:
  JoinedBags(const std::filesystem::path& folder, std::vector<std::unique_ptr<Bag>> parts)
      : Bag(folder, parts.front()->kind()), parts_(std::move(parts)) {
    for (const auto& part : parts_) {
      std::vector<std::size_t> topics;
      for (const BagTopic& topic : part->topics()) {
        topics.push_back(topicOf(topic.name, topic.type, topic.encoding));
        if (topic.messages == 0) continue;
        count(topics.back(), topic.first_s, topic.messages);
        count(topics.back(), topic.last_s, 0);
      }
      topics_of_.push_back(std::move(topics));
      for (const std::string& text : part->notes()) note(text);
    }
  }

  void read(const std::vector<bool>& wanted, const Take& take,
            const std::stop_token& stop) const override {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::vector<std::size_t>& topics = topics_of_[i];
      std::vector<bool> of_part;
      for (const std::size_t topic : topics) of_part.push_back(wanted[topic]);
      const auto pass_on = [&](const BagMessage& message) {
        take({topics[message.topic], message.time_s, message.bytes});
      };
      parts_[i]->read(of_part, pass_on, stop);
    }
  }

 private:
  std::vector<std::unique_ptr<Bag>> parts_;
  std::vector<std::vector<std::size_t>> topics_of_;
};

}  // namespace

std::unique_ptr<Bag> joinedBags(const std::filesystem::path& folder,
                                std::vector<std::unique_ptr<Bag>> parts) {
  return std::make_unique<JoinedBags>(folder, std::move(parts));
}

}  // namespace handmap

#include "drivers/rosbridge/fragments.h"

#include <algorithm>
#include <numeric>

#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr std::size_t kMostUnderWay = 8;
constexpr std::int64_t kMostPieces = 100'000;
constexpr std::size_t kLongestId = 200;

}  // namespace

Fragments::Message& Fragments::messageOf(const std::string& id, std::size_t total) {
  const auto found = std::find_if(messages_.begin(), messages_.end(),
                                  [&](const Message& message) { return message.id == id; });
  if (found != messages_.end()) {
    if (found->pieces.size() == total) return *found;
    messages_.erase(found);
    ++abandoned_;
  }
  if (messages_.size() == kMostUnderWay) {
    messages_.pop_front();
    ++abandoned_;
  }
  Message message{id, {}, total, 0};
  message.pieces.resize(total);
  messages_.push_back(std::move(message));
  return messages_.back();
}

std::optional<QByteArray> Fragments::add(const RosValue& fragment) {
  const RosValue id_value = fragment.at("id");
  const std::string id = id_value.text(kLongestId);
  const std::int64_t total = fragment.at("total").integer(1, kMostPieces);
  const std::int64_t number = fragment.at("num").integer(0, total - 1);
  const QByteArray data =
      QByteArray::fromStdString(fragment.at("data").text(static_cast<std::size_t>(most_bytes_)));
  Message& message = messageOf(id, static_cast<std::size_t>(total));
  auto& piece = message.pieces[static_cast<std::size_t>(number)];
  if (piece) return std::nullopt;  // it came twice
  piece = data;
  message.bytes += data.size();
  --message.missing;
  const qsizetype kept =
      std::accumulate(messages_.begin(), messages_.end(), qsizetype{0},
                      [](qsizetype sum, const Message& each) { return sum + each.bytes; });
  if (kept > most_bytes_) {
    messages_.clear();
    ++abandoned_;
    fragment.fail(phrase("{} bytes in pieces", kept), phrase("at most {}", most_bytes_));
  }
  if (message.missing > 0) return std::nullopt;
  QByteArray whole;
  whole.reserve(message.bytes);
  for (const auto& each : message.pieces) whole += *each;
  messages_.remove_if([&](const Message& each) { return &each == &message; });
  return whole;
}

}  // namespace handmap

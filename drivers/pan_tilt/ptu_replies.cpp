#include "drivers/pan_tilt/ptu_replies.h"

#include <utility>

#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::size_t kLongest = 200;  // the version is the longest that a head says

}  // namespace

std::optional<double> PtuReply::number() const {
  std::optional<double> number;
  for (const std::string_view word : splitWords(text)) {
    const std::optional<double> value = parseFinite(word);
    if (value && number) return std::nullopt;
    if (value) number = value;
  }
  return number;
}

std::vector<PtuReply> PtuReplies::feed(std::string_view bytes) {
  std::vector<PtuReply> replies;
  for (const char byte : bytes) take(byte, replies);
  return replies;
}

void PtuReplies::clear() {
  place_ = Place::BeforeReply;
  exclaimed_ = false;
  text_.clear();
}

void PtuReplies::take(char byte, std::vector<PtuReply>& replies) {
  if (std::exchange(exclaimed_, false)) {
    if (byte == 'P' || byte == 'T') {
      replies.push_back({byte == 'P' ? PtuReply::Kind::PanLimit : PtuReply::Kind::TiltLimit, {}});
      return;
    }
    if (place_ == Place::BeforeReply) {
      place_ = Place::InReply;
      kind_ = PtuReply::Kind::Refused;
    }
  }
  if (byte == '\r' || byte == '\n') {
    endLine(replies);
  } else if (byte == '!') {
    exclaimed_ = true;
  } else if (byte == '*' && place_ == Place::BeforeReply) {
    place_ = Place::InReply;
    kind_ = PtuReply::Kind::Done;
  } else if (place_ == Place::InReply) {
    text_ += byte;
    if (text_.size() > kLongest) place_ = Place::TooLong;
  }
}

void PtuReplies::endLine(std::vector<PtuReply>& replies) {
  if (place_ == Place::InReply) replies.push_back({kind_, std::string(trimmed(text_))});
  clear();
}

}  // namespace handmap

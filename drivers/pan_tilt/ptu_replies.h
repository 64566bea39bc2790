// What a PTU-D46 sends, taken apart.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handmap {

struct PtuReply {
  enum class Kind {
    Done,      ///< "*", with the text behind it
    Refused,   ///< "! text"
    PanLimit,  ///< "!P", at any moment, also in the middle of a reply
    TiltLimit  ///< "!T"
  };
  Kind kind;
  std::string text;

  /// Of a query's reply, "* -120", also in the verbose form: the only word that is a number.
  std::optional<double> number() const;
};

/// Bytes in, replies out. An echo in front of a reply is passed over; a line without a reply, or
/// longer than any, is dropped.
class PtuReplies {
 public:
  std::vector<PtuReply> feed(std::string_view bytes);
  void clear();

 private:
  void take(char byte, std::vector<PtuReply>& replies);
  void endLine(std::vector<PtuReply>& replies);

  enum class Place { BeforeReply, InReply, TooLong };
  Place place_ = Place::BeforeReply;
  PtuReply::Kind kind_ = PtuReply::Kind::Done;
  bool exclaimed_ = false;  ///< the byte before was a '!', of which the next byte tells the meaning
  std::string text_;
};

}  // namespace handmap

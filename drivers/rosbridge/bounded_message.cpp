#include "drivers/rosbridge/bounded_message.h"

#include <QCborStreamReader>
#include <QCborValue>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

std::string source() { return phrase("message from the network"); }

void checkSize(const QByteArray& message, const MessageLimits& limits) {
  if (message.size() > limits.bytes) {
    throwBadInput(source(), "", phrase("{} bytes", message.size()),
                  phrase("at most {}", limits.bytes));
  }
}

void checkDepth(int depth, const MessageLimits& limits) {
  if (depth > limits.depth) {
    throwBadInput(source(), "", phrase("more than {} levels of nesting", limits.depth),
                  phrase("fewer"));
  }
}

void checkCount(int values, const MessageLimits& limits) {
  if (values > limits.values) {
    throwBadInput(source(), "", phrase("more than {} values", limits.values), phrase("fewer"));
  }
}

/// Counts brackets and separators outside of strings; whether it is JSON, the parser tells.
void checkJson(const QByteArray& text, const MessageLimits& limits) {
  int depth = 0;
  int values = 0;
  bool in_string = false;
  bool escaped = false;
  for (const char c : text) {
    if (in_string) {
      in_string = escaped || c != '"';
      escaped = !escaped && c == '\\';
      continue;
    }
    in_string = c == '"';
    if (c == '[' || c == '{') checkDepth(++depth, limits);
    if (c == ']' || c == '}') --depth;
    if (c == ',' || c == ':') checkCount(++values, limits);
  }
}

/// Goes through the whole message without keeping any of it.
class CborCheck {
 public:
  explicit CborCheck(const QByteArray& bytes, const MessageLimits& limits)
      : reader_(bytes), limits_(limits) {}

  void operator()() {
    pass(1);
    if (reader_.lastError() != QCborError::NoError) {
      throwBadInput(source(), phrase("byte {}", reader_.currentOffset()),
                    reader_.lastError().toString().toStdString(), "CBOR");
    }
  }

 private:
  void pass(int depth) {
    while (reader_.isTag()) next();  // what is tagged follows
    if (!reader_.isContainer()) return next();
    checkDepth(depth, limits_);
    checkCount(++values_, limits_);
    reader_.enterContainer();
    while (reader_.lastError() == QCborError::NoError && reader_.hasNext()) pass(depth + 1);
    if (reader_.lastError() == QCborError::NoError) reader_.leaveContainer();
  }
  void next() {
    checkCount(++values_, limits_);
    reader_.next();
  }

  QCborStreamReader reader_;
  const MessageLimits& limits_;
  int values_ = 0;
};

}  // namespace

QCborMap parseJsonMessage(const QByteArray& text, const MessageLimits& limits) {
  checkSize(text, limits);
  checkJson(text, limits);
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(text, &error);
  if (!document.isObject()) {
    const std::string found = error.error == QJsonParseError::NoError
                                  ? phrase("another value")
                                  : error.errorString().toStdString();
    throwBadInput(source(), phrase("byte {}", error.offset), found, phrase("a JSON object"));
  }
  return QCborMap::fromJsonObject(document.object());
}

QCborMap parseCborMessage(const QByteArray& bytes, const MessageLimits& limits) {
  checkSize(bytes, limits);
  CborCheck(bytes, limits)();
  QCborParserError error;
  const QCborValue value = QCborValue::fromCbor(bytes, &error);
  if (error.error != QCborError::NoError || !value.isMap()) {
    throwBadInput(source(), phrase("byte {}", error.offset),
                  error.error == QCborError::NoError ? phrase("another value")
                                                     : error.errorString().toStdString(),
                  phrase("a CBOR map"));
  }
  return value.toMap();
}

}  // namespace handmap

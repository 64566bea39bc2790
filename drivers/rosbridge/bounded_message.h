// Messages from the network, JSON or CBOR, taken apart only after it is known how deep and how
// large they are.
#pragma once

#include <QByteArray>
#include <QCborMap>

namespace handmap {

struct MessageLimits {
  qsizetype bytes = 32 << 20;  ///< a cloud of a million points as JSON is larger, as CBOR it is not
  int depth = 24;              ///< nested lists and maps
  int values = 4'000'000;
};

/// A JSON object. Throws BadInput.
QCborMap parseJsonMessage(const QByteArray& text, const MessageLimits& limits = {});

/// A CBOR map. Throws BadInput.
QCborMap parseCborMessage(const QByteArray& bytes, const MessageLimits& limits = {});

}  // namespace handmap

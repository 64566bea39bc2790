#include "widgets/editing/typed_numbers.h"

#include <algorithm>

namespace handmap {

namespace {

constexpr qsizetype kMostCharacters = 9;

}  // namespace

void TypedNumbers::setCount(std::size_t count) {
  texts_.resize(count);
  current_ = count == 0 ? 0 : std::min(current_, count - 1);
}

void TypedNumbers::clear() {
  for (QString& text : texts_) text.clear();
  current_ = 0;
}

bool TypedNumbers::type(QChar character) {
  if (current_ >= texts_.size()) return false;
  QString& text = texts_[current_];
  if (character == u',') character = u'.';
  if (character == u'-') {
    text = text.startsWith(u'-') ? text.mid(1) : u'-' + text;
    return true;
  }
  const bool is_digit = character >= u'0' && character <= u'9';
  const bool is_point = character == u'.' && !text.contains(u'.');
  if (!is_digit && !is_point) return false;
  if (text.size() < kMostCharacters) text += character;
  return true;
}

bool TypedNumbers::next() {
  if (texts_.size() < 2) return false;
  current_ = (current_ + 1) % texts_.size();
  return true;
}

bool TypedNumbers::takeBack() {
  if (current_ >= texts_.size()) return false;
  if (texts_[current_].isEmpty() && current_ > 0 && !isEmpty()) --current_;
  if (texts_[current_].isEmpty()) return false;
  texts_[current_].chop(1);
  return true;
}

bool TypedNumbers::isEmpty() const {
  return std::ranges::all_of(texts_, [](const QString& text) { return text.isEmpty(); });
}

std::optional<double> TypedNumbers::value(std::size_t i) const {
  bool ok = false;
  const double value = text(i).toDouble(&ok);
  return ok ? std::optional(value) : std::nullopt;
}

}  // namespace handmap

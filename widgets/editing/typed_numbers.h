// Numbers that are typed while something is drawn: `40 <Tab> 15`.
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace handmap {

class TypedNumbers {
 public:
  /// How many numbers there are to type; what is typed of others is forgotten.
  void setCount(std::size_t count);
  void clear();

  /// A digit, a decimal point (a comma is one too) or a minus, which turns the sign wherever it is
  /// typed; false when it is none or has no place.
  bool type(QChar character);
  bool next();      ///< on to the next number, from the last to the first
  bool takeBack();  ///< the last character

  bool isEmpty() const;
  std::size_t current() const { return current_; }
  QString text(std::size_t i) const { return i < texts_.size() ? texts_[i] : QString(); }
  /// Nothing for what is not typed, or not yet a number.
  std::optional<double> value(std::size_t i) const;

 private:
  std::vector<QString> texts_;
  std::size_t current_ = 0;
};

}  // namespace handmap

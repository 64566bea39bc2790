// A table of numbers in a text: separated by commas, semicolons, tabs or blanks.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/logs/log.h"

namespace handmap {

struct Table {
  std::string file;
  std::vector<std::string> names;  ///< of the columns; "1", "2" … without a header
  bool has_header = false;
  std::vector<double> values;  ///< row by row; not finite where a field is empty or says so
  std::vector<int> lines;      ///< of the rows

  std::size_t width() const { return names.size(); }
  std::size_t rows() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const { return values[row * width() + column]; }
};

/// Lines that begin with '#' are passed over. Throws BadInput "FILE: line 3: …".
Table parseTable(std::string_view content, const std::string& file,
                 const std::stop_token& stop = {});

/// Which columns have a role. By what a person said, else by their names.
class Columns {
 public:
  /// Throws BadInput for a role or a column that there is none of.
  Columns(const Table& table, const LogOptions& options);

  std::optional<std::size_t> of(const std::string& role) const;
  const std::vector<std::size_t>& ranges() const { return ranges_; }
  /// What the name says of the unit, as a factor: "_ms", "_deg", "_mm"; nullopt: nothing.
  std::optional<double> unitOf(const std::string& role) const;
  std::optional<double> unitOfRanges() const;
  /// Names that say nothing to anybody, where nobody said which column is which.
  const std::vector<std::string>& unknown() const { return unknown_; }

 private:
  std::optional<double> unitAt(std::size_t column) const;
  std::vector<std::size_t> told(const std::string& role, const std::string& column) const;

  const Table& table_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::size_t> ranges_;
  std::vector<std::string> unknown_;
};

}  // namespace handmap

#include "core/recording/frame_table.h"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/recording/as_written.h"
#include "core/recording/points_part.h"
#include "core/recording/time_limits.h"

namespace handmap {

namespace {

constexpr std::uintmax_t kMaxTableBytes = 256u << 20;
constexpr std::size_t kMaxPathBytes = 1024;
constexpr double kMaxPanDeg = 3600.0;
constexpr int kMaxNumber = 1'000'000'000;

enum Column { Frame, Time, Stop, Pan, Left, Right, Points, RightTime };
constexpr std::array<std::string_view, 8> kColumns = {"frame", "time_s", "stop",   "pan_deg",
                                                      "left",  "right",  "points", "right_time_s"};
constexpr std::string_view kHeader = "frame,time_s,stop,pan_deg,left,right,points";

/// Reads the rows of one table, remembering what the next row has to be checked against.
class TableReader {
 public:
  TableReader(std::string file, const TextLine& header) : file_(std::move(file)) {
    line_ = header.number;
    const auto names = splitFields(header.text, ',');
    width_ = names.size();
    index_.fill(width_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t c = 0; c < kColumns.size(); ++c) {
        if (names[i] != kColumns[c]) continue;
        if (index_[c] != width_) fail(names[i], phrase("this column twice"), phrase("it once"));
        index_[c] = i;
      }
    }
    for (const Column needed : {Column::Frame, Column::Time}) {
      if (index_[needed] == width_) {
        fail("", phrase("no column {}", kColumns[needed]), phrase("a header with {}", kHeader));
      }
    }
  }

  FrameRow read(const TextLine& line) {
    line_ = line.number;
    fields_ = splitFields(line.text, ',');
    if (fields_.size() != width_) {
      fail("", phrase("{} fields", fields_.size()), fmt::format("{}", width_));
    }
    FrameRow row;
    row.frame = integer(Column::Frame);
    row.time_s = number(Column::Time, kMaxTime_s);
    if (!field(Column::Stop).empty()) row.stop = integer(Column::Stop);
    if (!field(Column::Pan).empty()) row.pan = toRadians(number(Column::Pan, kMaxPanDeg));
    row.left = file(Column::Left);
    row.right = file(Column::Right);
    row.points = file(Column::Points);
    if (!field(Column::RightTime).empty()) row.right_time_s = number(Column::RightTime, kMaxTime_s);
    if (row.left.empty() != row.right.empty()) {
      fail("", phrase("one image of a pair"), phrase("both or none"));
    }
    if (row.left.empty() && row.points.empty()) {
      fail("", phrase("neither images nor points"), phrase("some"));
    }
    checkOrder(row);
    previous_ = row;
    return row;
  }

 private:
  [[noreturn]] void fail(std::string_view column, const std::string& found,
                         const std::string& expected) const {
    const std::string line = phrase("line {}", line_);
    throwBadInput(file_, column.empty() ? line : fmt::format("{}: {}", line, column), found,
                  expected);
  }

  std::string_view field(Column column) const {
    return index_[column] < width_ ? fields_[index_[column]] : std::string_view{};
  }

  std::string found(Column column) const {
    return fmt::format("\"{}\"", field(column).substr(0, 40));
  }

  int integer(Column column) const {
    const auto value = parseInteger(field(column));
    if (!value || *value < 0 || *value > kMaxNumber) {
      fail(kColumns[column], found(column), phrase("a whole number from 0 to {}", kMaxNumber));
    }
    return static_cast<int>(*value);
  }

  double number(Column column, double limit) const {
    const auto value = parseFinite(field(column));
    if (!value || std::abs(*value) > limit) {
      const bool is_time = column == Column::Time || column == Column::RightTime;
      if (value && is_time && !likelyUnitOfTime(*value).empty()) {
        fail(kColumns[column], found(column),
             phrase("seconds; this looks like {}", likelyUnitOfTime(*value)));
      }
      fail(kColumns[column], found(column),
           phrase("a finite number, at most {}", formatNumber(limit)));
    }
    return *value;
  }

  std::string file(Column column) const {
    const std::string_view path = field(column);
    if (path.size() > kMaxPathBytes || !staysInside(path)) {
      fail(kColumns[column], found(column), phrase("a path inside the folder"));
    }
    return std::string(path);
  }

  void checkOrder(const FrameRow& row) {
    const bool same_stop = previous_ && row.stop && row.stop == previous_->stop;
    rows_of_stop_ = same_stop ? rows_of_stop_ + 1 : 1;
    if (rows_of_stop_ > kMaxRowsOfStop) {
      fail(kColumns[Column::Stop], phrase("stop {} in one more row", *row.stop),
           phrase("at most {}", kMaxRowsOfStop));
    }
    if (row.stop && !same_stop && !stops_.insert(*row.stop).second) {
      fail(kColumns[Column::Stop], phrase("stop {} a second time", *row.stop),
           phrase("the rows of one stop together"));
    }
    if (!previous_) return;
    const bool later = same_stop ? row.time_s >= previous_->time_s : row.time_s > previous_->time_s;
    if (!later) {
      fail(kColumns[Column::Time],
           phrase("{} after {}", formatNumber(row.time_s), formatNumber(previous_->time_s)),
           phrase("times that increase"));
    }
    const bool next = same_stop ? row.frame >= previous_->frame : row.frame > previous_->frame;
    if (!next) {
      fail(kColumns[Column::Frame], phrase("{} after {}", row.frame, previous_->frame),
           phrase("frame numbers that increase"));
    }
  }

  std::string file_;
  int line_ = 0;
  std::size_t width_ = 0;
  std::array<std::size_t, kColumns.size()> index_{};
  std::vector<std::string_view> fields_;
  std::optional<FrameRow> previous_;
  std::set<int> stops_;
  int rows_of_stop_ = 0;
};

}  // namespace

std::vector<FrameRow> readFrameTable(const std::filesystem::path& path,
                                     const std::stop_token& stop) {
  const std::string content = readFile(path, kMaxTableBytes);
  const std::string file = path.string();
  ContentLines lines(content);
  const auto header = lines.next();
  auto line = header ? lines.next() : std::nullopt;
  if (!line) throwBadInput(file, "", phrase("no rows"), phrase("a header line and rows"));
  TableReader reader(file, *header);
  std::vector<FrameRow> rows;
  for (; line; line = lines.next()) {
    throwIfStopped(stop);
    try {
      FrameRow row = reader.read(*line);
      const bool may_lack_digits = partOf(row.points) && isCutOff(*line, content);
      if (may_lack_digits && !rows.empty()) break;
      rows.push_back(std::move(row));
    } catch (const Error&) {
      if (rows.empty() || !isCutOff(*line, content)) throw;
      break;
    }
    if (rows.size() > kMaxRows) {
      throwBadInput(file, phrase("line {}", line->number), phrase("one more row"),
                    phrase("at most {}", kMaxRows));
    }
  }
  return rows;
}

std::string frameTableHeader() { return fmt::format("{}\n", kHeader); }

std::string formatFrameRow(const FrameRow& row) {
  return fmt::format("{},{},{},{},{},{},{}\n", row.frame, formatNumber(row.time_s),
                     row.stop ? std::to_string(*row.stop) : "",
                     row.pan != 0.0 || row.stop ? formatNumber(toDegrees(row.pan)) : "", row.left,
                     row.right, row.points);
}

}  // namespace handmap

// SCIP 2.0, the language of Hokuyo's laser scanners, without any port: lines in, answers out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

/// The character behind a text: its sum, folded to six bits.
char scipSum(std::string_view text);
/// Six bits a character, the highest first; nullopt for characters that cannot be.
std::optional<std::uint32_t> scipDecode(std::string_view characters);
std::string scipEncode(std::uint32_t value, int characters);

/// What a scanner says of itself (PP). Steps count counter-clockwise seen from above.
struct ScipParameters {
  std::string model;
  int least_mm = 20;    ///< nearer values are codes of errors
  int most_mm = 30000;  ///< farther ones as well
  int steps_a_turn = 1440;
  int first_step = 0;
  int last_step = 1080;
  int front_step = 540;
  int turns_a_minute = 2400;

  /// From the first step to the last.
  double scanTime_s() const {
    return 60.0 / turns_a_minute * (last_step - first_step) / steps_a_turn;
  }
};

/// One answer: the command as the scanner repeats it, its status, and the lines behind, without
/// the sums, which were right.
struct ScipAnswer {
  std::string echo;
  std::string status;
  std::vector<std::string> lines;
};

/// Collects the lines of an answer up to the empty one that ends it. An answer with a wrong sum is
/// dropped and counted, as is one with more lines than any scanner sends.
class ScipReader {
 public:
  /// `line` without its LF.
  std::optional<ScipAnswer> take(std::string_view line);
  void clear();
  int damaged() const { return damaged_; }

 private:
  bool takeStatus(std::string_view line);
  bool takeData(std::string_view line);

  ScipAnswer answer_;
  int lines_ = 0;
  bool bad_ = false;
  int damaged_ = 0;
};

/// nullopt where something is missing or cannot be.
std::optional<ScipParameters> parseScipParameters(const ScipAnswer& answer);

struct ScipScan {
  std::uint32_t stamp_ms = 0;  ///< 24 bits of the scanner's clock
  std::vector<int> ranges_mm;  ///< by step from the first that was asked for; some are codes
};
/// Of an answer to MD with the status 99; nullopt where it is not whole.
std::optional<ScipScan> parseScipScan(const ScipAnswer& answer, const ScipParameters& parameters);

/// x forward, y left, z = 0, w = 1; the steps where nothing was measured are left out.
std::vector<RangePoint> scipPoints(const ScipScan& scan, const ScipParameters& parameters);

/// Seconds since the first stamp, of stamps that begin anew after 2²⁴ ms (4.66 h).
class ScipClock {
 public:
  double seconds(std::uint32_t stamp_ms);

 private:
  bool begun_ = false;
  std::uint32_t last_ms_ = 0;
  std::int64_t passed_ms_ = 0;
};

}  // namespace handmap

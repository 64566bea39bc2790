// Errors of core. Thrown at the edges, where a number or a file from outside is first read.
#pragma once

#include <stdexcept>
#include <stop_token>
#include <string>

namespace handmap {

/// The values are the exit statuses of handmap-cli.
enum class ErrorCode { Usage = 1, BadInput = 2, RunFailed = 3 };

/// what() names the file, the line or key, what was found and what was expected; hint() says how to
/// mend it, where there is something to say.
class Error : public std::runtime_error {
 public:
  explicit Error(ErrorCode code, const std::string& message, std::string hint = {})
      : std::runtime_error(message), code_(code), hint_(std::move(hint)) {}

  ErrorCode code() const { return code_; }
  const std::string& hint() const { return hint_; }

 private:
  ErrorCode code_;
  std::string hint_;
};

/// Throws BadInput as "FILE: PLACE: found FOUND, expected EXPECTED". An empty `place` is left out.
[[noreturn]] void throwBadInput(const std::string& file, const std::string& place,
                                const std::string& found, const std::string& expected);

/// Throws RunFailed once `stop` is requested: for long work whose result then nobody waits for.
void throwIfStopped(const std::stop_token& stop);

}  // namespace handmap

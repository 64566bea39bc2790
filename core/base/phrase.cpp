#include "core/base/phrase.h"

namespace handmap {

namespace {

Translator installed = nullptr;

}  // namespace

void translatePhrases(Translator translator) { installed = translator; }

std::string formatPhrase(fmt::string_view english, fmt::format_args arguments) {
  if (installed != nullptr) {
    try {
      return fmt::vformat(installed(std::string(english.data(), english.size()).c_str()),
                          arguments);
    } catch (const fmt::format_error&) {
    }
  }
  return fmt::vformat(english, arguments);
}

}  // namespace handmap

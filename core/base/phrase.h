// What is said to a person, written in English where it is said and translated where a window has
// installed a translator. What goes into results or files is no phrase.
#pragma once

#include <string>

#include <fmt/format.h>

namespace handmap {

/// The translation of an English text; the text itself where there is none.
using Translator = std::string (*)(const char* english);

/// From now on phrases are translated. Before there are threads.
void translatePhrases(Translator translator);

/// As phrase(), with what fmt::make_format_args() makes.
std::string formatPhrase(fmt::string_view english, fmt::format_args arguments);

/// As fmt::format(), translated. A translation may take the places in another order ("{1} {0}");
/// one that does not fit what is filled in is passed over: then the English is said. `./dev
/// translate` finds a text that is written as a literal right behind the bracket.
template <class... Arguments>
std::string phrase(fmt::format_string<Arguments...> english, Arguments&&... arguments) {
  return formatPhrase(english, fmt::make_format_args(arguments...));
}

}  // namespace handmap

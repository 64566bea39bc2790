// Expects an Error of a code whose message holds given words.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap::test {

template <typename Action>
void expectError(ErrorCode code, Action action, const std::vector<std::string>& words) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    const std::string text = std::string(error.what()) + "\n" + error.hint();
    for (const std::string& word : words) {
      EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" not in: " << text;
    }
    return;
  }
  ADD_FAILURE() << "no error was thrown";
}

template <typename Action>
void expectBadInput(Action action, const std::vector<std::string>& words) {
  expectError(ErrorCode::BadInput, action, words);
}

}  // namespace handmap::test

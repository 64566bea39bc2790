// Events for tools without a window: a pointer, keys and typing.
#pragma once

#include "widgets/canvas/tool.h"

namespace handmap {

inline constexpr double kScale = 0.1;  // metres per pixel

inline ToolEvent at(const Vec2& position, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  ToolEvent event;
  event.position = event.snapped = position;
  event.metres_per_pixel = kScale;
  event.modifiers = modifiers;
  return event;
}

inline void click(Tool& tool, const Vec2& position) {
  tool.press(at(position));
  tool.release(at(position));
}

inline void drag(Tool& tool, const Vec2& from, const Vec2& to,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  tool.press(at(from, modifiers));
  tool.move(at((from + to) / 2.0, modifiers));
  tool.move(at(to, modifiers));
  tool.release(at(to, modifiers));
}

inline bool key(Tool& tool, int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
                const QString& text = {}) {
  ToolKey pressed{code, modifiers};
  pressed.step_m = 0.1;
  pressed.stride_m = 1.0;
  pressed.metres_per_pixel = kScale;
  pressed.text = text;
  return tool.key(pressed);
}

inline void type(Tool& tool, const QString& text) {
  for (const QChar character : text) {
    if (character == u'\t')
      key(tool, Qt::Key_Tab);
    else if (character == u'\n')
      key(tool, Qt::Key_Return);
    else
      key(tool, character.unicode(), {}, character);
  }
}

}  // namespace handmap

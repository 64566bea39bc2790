// Every action of the program, declared once: menus, toolbars and the sheet of shortcuts are made
// from this table.
#pragma once

#include <span>

namespace handmap {

enum class Menu { File, Edit, Arrange, View, Draw, Run, Help };

enum class ToolBar { None, Main, Tools, Transport };

enum class ActionKind { Push, Check, Tool };  ///< Tool: one of an exclusive group

struct ActionSpec {
  const char* id;    ///< "menu.name"
  const char* text;  ///< with mnemonic
  const char* icon;  ///< of resources/icons; empty: none
  const char* keys;  ///< portable text, several joined by "; "; empty: none
  const char* hint;  ///< one sentence
  Menu menu;
  ToolBar tool_bar = ToolBar::None;
  ActionKind kind = ActionKind::Push;
  bool separated = false;  ///< a separator before it
};

std::span<const ActionSpec> actionTable();  ///< in the order of the menus
const char* menuTitle(Menu menu);

}  // namespace handmap

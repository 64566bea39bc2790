#include "widgets/actions/action_table.h"

#include <array>

namespace handmap {

namespace {

using enum ActionKind;

constexpr std::array kActions = {
    ActionSpec{"file.new", "&New", "new", "Ctrl+N", "Start an empty drawing.", Menu::File,
               ToolBar::Main},
    ActionSpec{"file.open", "&Open…", "open", "Ctrl+O", "Open a drawing.", Menu::File,
               ToolBar::Main},
    ActionSpec{"file.save", "&Save", "save", "Ctrl+S", "Save the drawing.", Menu::File,
               ToolBar::Main},
    ActionSpec{"file.save_as", "Save &As…", "", "Ctrl+Shift+S",
               "Save the drawing under another name.", Menu::File},
    ActionSpec{"file.export_map", "Export &Refined Map…", "export", "Ctrl+E",
               "Save the map that the run has corrected.", Menu::File, ToolBar::None, Push, true},
    ActionSpec{"file.export_geojson", "Export &GeoJSON…", "", "",
               "Save the map for geographic programs; it must be georeferenced.", Menu::File},
    ActionSpec{"file.export_png", "Export &Picture…", "", "", "Save what the canvas shows as PNG.",
               Menu::File},
    ActionSpec{"file.export_trajectory", "Export &Trajectory…", "", "",
               "Save the way of the robot in TUM form.", Menu::File},
    ActionSpec{"file.quit", "&Quit", "", "Ctrl+Q", "Leave the program.", Menu::File, ToolBar::None,
               Push, true},

    ActionSpec{"edit.undo", "&Undo", "undo", "Ctrl+Z", "Take back the last change.", Menu::Edit,
               ToolBar::Main, Push, true},
    ActionSpec{"edit.redo", "&Redo", "redo", "Ctrl+Shift+Z; Ctrl+Y",
               "Do again what was taken back.", Menu::Edit, ToolBar::Main},
    ActionSpec{"edit.delete", "&Delete", "delete", "Del", "Remove what is selected.", Menu::Edit,
               ToolBar::Main, Push, true},
    ActionSpec{"edit.select_all", "Select &All", "", "Ctrl+A", "Select everything drawn.",
               Menu::Edit},
    ActionSpec{"edit.settings", "&Settings…", "settings", "Ctrl+,",
               "How a run localizes and corrects.", Menu::Edit, ToolBar::None, Push, true},

    ActionSpec{"view.zoom_in", "Zoom &In", "zoom-in", "Ctrl++; Ctrl+=; +", "Show it larger.",
               Menu::View, ToolBar::Main, Push, true},
    ActionSpec{"view.zoom_out", "Zoom &Out", "zoom-out", "Ctrl+-; -", "Show more of the map.",
               Menu::View, ToolBar::Main},
    ActionSpec{"view.zoom_fit", "Zoom to &Fit", "zoom-fit", "Ctrl+0; F", "Show the whole map.",
               Menu::View, ToolBar::Main},
    ActionSpec{"view.grid", "&Grid", "grid", "G", "Show the metric grid.", Menu::View,
               ToolBar::Main, Check, true},
    ActionSpec{"view.snap", "&Snap to Half Metres", "", "Shift+G",
               "Keep points on a grid of half a metre while drawing.", Menu::View, ToolBar::None,
               Check},

    ActionSpec{"draw.select", "&Select", "select", "S", "Select, move, resize and turn.",
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.rectangle", "&Rectangle", "rectangle", "R", "Draw a rectangular building.",
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.polygon", "&Polygon", "polygon", "P", "Draw a building of any shape.",
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.start", "S&tart", "start", "T", "Say where the robot starts and looks.",
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.route", "R&oute", "route", "O", "Draw the way that the robot shall take.",
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.landmark", "&Landmark", "landmark", "L", "Mark a place by name.", Menu::Draw,
               ToolBar::Tools, Tool},

    ActionSpec{"run.open_recording", "Open Re&cording…", "record", "Ctrl+Shift+O",
               "Take the robot's observations from a recording.", Menu::Run, ToolBar::Transport},
    ActionSpec{"run.connect", "C&onnect a Robot…", "", "Ctrl+Shift+R",
               "Put a live robot together: camera or scanner, head, wheels.", Menu::Run},
    ActionSpec{"run.simulator", "Si&mulator", "", "Ctrl+Shift+M",
               "Take the robot's observations from the built-in simulator.", Menu::Run},
    ActionSpec{"run.run", "&Run", "run", "F5", "Localize on the drawing and correct it.", Menu::Run,
               ToolBar::Transport, Push, true},
    ActionSpec{"run.pause", "&Pause", "pause", "F6", "Hold after this observation.", Menu::Run,
               ToolBar::Transport},
    ActionSpec{"run.step", "S&tep", "step", "F7", "Work in one observation, then hold.", Menu::Run,
               ToolBar::Transport},
    ActionSpec{"run.back", "Step &Back", "back", "Shift+F7", "Look at the observation before.",
               Menu::Run, ToolBar::Transport},
    ActionSpec{"run.newest", "To the Ne&west", "newest", "Ctrl+End",
               "Look at how it is now, no longer at the past.", Menu::Run, ToolBar::Transport},
    ActionSpec{"run.stop", "&Stop", "stop", "Shift+F5", "End the run.", Menu::Run,
               ToolBar::Transport},
    ActionSpec{"run.accept", "&Accept Refinement", "accept", "Ctrl+Return",
               "Take the corrected shapes into the drawing, as one step that can be undone.",
               Menu::Run, ToolBar::Transport, Push, true},
    ActionSpec{"run.bookmark", "Boo&kmark This Moment", "", "Ctrl+B",
               "Mark it on the timeline, or take the mark away.", Menu::Run, ToolBar::None, Push,
               true},
    ActionSpec{"run.next_bookmark", "Ne&xt Bookmark", "", "Ctrl+Shift+B",
               "Look at the next moment that is marked.", Menu::Run},
    ActionSpec{"run.recompute", "Recomp&ute with the Drawing", "", "Ctrl+F5",
               "Do the run again, so far as it has come, with the drawing as it is now.", Menu::Run,
               ToolBar::None, Push, true},
    ActionSpec{"run.give_pose", "Robot Is &Here…", "", "H",
               "Say where the robot is at the moment that is shown; the run is done again with it.",
               Menu::Run, ToolBar::None, Tool},
    ActionSpec{"run.forget_poses", "&Forget Given Poses", "", "",
               "Do the run again without the poses that you gave.", Menu::Run},
    ActionSpec{"run.right", "Building Is Ri&ght", "", "Ctrl+G",
               "Hold the selected buildings where the run shows them, and do it again with that.",
               Menu::Run},
    ActionSpec{"run.not_there", "Building Is &Not There", "", "Ctrl+Del",
               "Take the selected buildings out of the drawing, and do the run again without them.",
               Menu::Run},
    ActionSpec{"run.teach", "Teach Bu&ildings…", "", "",
               "Show in your own images what is a building and what is not.", Menu::Run,
               ToolBar::None, Push, true},

    ActionSpec{"help.shortcuts", "&Keyboard Shortcuts", "", "F1", "Show every key.", Menu::Help},
    ActionSpec{"help.about", "&About Handmap", "", "", "Version and licence.", Menu::Help},
};

}  // namespace

std::span<const ActionSpec> actionTable() { return kActions; }

const char* menuTitle(Menu menu) {
  switch (menu) {
    case Menu::File:
      return "&File";
    case Menu::Edit:
      return "&Edit";
    case Menu::View:
      return "&View";
    case Menu::Draw:
      return "&Draw";
    case Menu::Run:
      return "&Run";
    case Menu::Help:
      return "&Help";
  }
  return "";
}

}  // namespace handmap

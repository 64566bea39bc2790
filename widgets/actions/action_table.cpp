#include "widgets/actions/action_table.h"

#include <QtGlobal>
#include <array>

namespace handmap {

namespace {

using enum ActionKind;

constexpr std::array kActions = {
    ActionSpec{"file.new", QT_TRANSLATE_NOOP("Actions", "&New"), "new", "Ctrl+N",
               QT_TRANSLATE_NOOP("Actions", "Start an empty drawing."), Menu::File, ToolBar::Main},
    ActionSpec{"file.new_window", QT_TRANSLATE_NOOP("Actions", "New &Window"), "", "Ctrl+Shift+N",
               QT_TRANSLATE_NOOP("Actions", "Open another window, with a drawing of its own."),
               Menu::File},
    ActionSpec{"file.open", QT_TRANSLATE_NOOP("Actions", "&Open…"), "open", "Ctrl+O",
               QT_TRANSLATE_NOOP("Actions", "Open a drawing."), Menu::File, ToolBar::Main},
    ActionSpec{"file.import_log", QT_TRANSLATE_NOOP("Actions", "&Import Log…"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Make a recording of the log of another program."),
               Menu::File},
    ActionSpec{"file.save", QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S",
               QT_TRANSLATE_NOOP("Actions", "Save the drawing."), Menu::File, ToolBar::Main},
    ActionSpec{"file.save_as", QT_TRANSLATE_NOOP("Actions", "Save &As…"), "", "Ctrl+Shift+S",
               QT_TRANSLATE_NOOP("Actions", "Save the drawing under another name."), Menu::File},
    ActionSpec{"file.keep_template", QT_TRANSLATE_NOOP("Actions", "&Keep as Template…"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Keep the drawing, to begin others with it."),
               Menu::File},
    ActionSpec{"file.export_map", QT_TRANSLATE_NOOP("Actions", "Export &Refined Map…"), "export",
               "Ctrl+E", QT_TRANSLATE_NOOP("Actions", "Save the map that the run has corrected."),
               Menu::File, ToolBar::None, Push, true},
    ActionSpec{"file.export_geojson", QT_TRANSLATE_NOOP("Actions", "Export &GeoJSON…"), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Save the map for geographic programs; it must be georeferenced."),
               Menu::File},
    ActionSpec{"file.export_png", QT_TRANSLATE_NOOP("Actions", "Export &Picture…"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Save what the canvas shows as PNG."), Menu::File},
    ActionSpec{"file.export_trajectory", QT_TRANSLATE_NOOP("Actions", "Export &Trajectory…"), "",
               "", QT_TRANSLATE_NOOP("Actions", "Save the way of the robot in TUM form."),
               Menu::File},
    ActionSpec{"file.quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), "", "Ctrl+Q",
               QT_TRANSLATE_NOOP("Actions", "Leave the program."), Menu::File, ToolBar::None, Push,
               true},

    ActionSpec{"edit.undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", "Ctrl+Z",
               QT_TRANSLATE_NOOP("Actions", "Take back the last change."), Menu::Edit,
               ToolBar::Main, Push, true},
    ActionSpec{"edit.redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
               QT_TRANSLATE_NOOP("Actions", "Do again what was taken back."), Menu::Edit,
               ToolBar::Main},
    ActionSpec{"edit.cut", QT_TRANSLATE_NOOP("Actions", "Cu&t"), "", "Ctrl+X",
               QT_TRANSLATE_NOOP("Actions", "Put what is selected on the clipboard."), Menu::Edit,
               ToolBar::None, Push, true},
    ActionSpec{"edit.copy", QT_TRANSLATE_NOOP("Actions", "&Copy"), "", "Ctrl+C",
               QT_TRANSLATE_NOOP("Actions", "Copy what is selected to the clipboard."), Menu::Edit},
    ActionSpec{"edit.paste", QT_TRANSLATE_NOOP("Actions", "&Paste"), "", "Ctrl+V",
               QT_TRANSLATE_NOOP("Actions", "Put what is on the clipboard where the pointer is."),
               Menu::Edit},
    ActionSpec{"edit.duplicate", QT_TRANSLATE_NOOP("Actions", "Dup&licate"), "", "Ctrl+D",
               QT_TRANSLATE_NOOP("Actions", "Copy what is selected beside itself."), Menu::Edit},
    ActionSpec{"edit.rename", QT_TRANSLATE_NOOP("Actions", "Re&name"), "", "F2",
               QT_TRANSLATE_NOOP("Actions", "Type the name where the building is."), Menu::Edit},
    ActionSpec{"edit.add_corner", QT_TRANSLATE_NOOP("Actions", "Add C&orner"), "", "Ins",
               QT_TRANSLATE_NOOP("Actions", "Put another corner into the wall or the route."),
               Menu::Edit},
    ActionSpec{"edit.delete", QT_TRANSLATE_NOOP("Actions", "&Delete"), "delete", "Del",
               QT_TRANSLATE_NOOP("Actions", "Remove what is selected."), Menu::Edit, ToolBar::Main,
               Push, true},
    ActionSpec{"edit.select_all", QT_TRANSLATE_NOOP("Actions", "Select &All"), "", "Ctrl+A",
               QT_TRANSLATE_NOOP("Actions", "Select everything drawn."), Menu::Edit},
    ActionSpec{"edit.settings", QT_TRANSLATE_NOOP("Actions", "&Settings…"), "settings", "Ctrl+,",
               QT_TRANSLATE_NOOP("Actions", "How a run localizes and corrects."), Menu::Edit,
               ToolBar::None, Push, true},

    ActionSpec{"arrange.lock", QT_TRANSLATE_NOOP("Actions", "&Lock"), "", "Ctrl+L",
               QT_TRANSLATE_NOOP("Actions", "Nobody moves, resizes or deletes it by hand; again unlocks it."),
               Menu::Arrange},
    ActionSpec{"arrange.square", QT_TRANSLATE_NOOP("Actions", "&Square Up"), "", "Q",
               QT_TRANSLATE_NOOP("Actions",
                                 "Make nearly right angles right, and what is nearly level level."),
               Menu::Arrange, ToolBar::None, Push, true},
    ActionSpec{"arrange.parallel", QT_TRANSLATE_NOOP("Actions", "Make &Parallel"), "", "Shift+Q",
               QT_TRANSLATE_NOOP("Actions", "Turn it to the direction of the nearest building."),
               Menu::Arrange},
    ActionSpec{"arrange.polygon", QT_TRANSLATE_NOOP("Actions", "Make P&olygon"), "", "Shift+P",
               QT_TRANSLATE_NOOP("Actions", "So that each corner can be moved alone."),
               Menu::Arrange},
    ActionSpec{"arrange.left", QT_TRANSLATE_NOOP("Actions", "Align L&eft"), "", "Alt+Shift+Left",
               QT_TRANSLATE_NOOP("Actions", "Lay the left sides on one line."), Menu::Arrange,
               ToolBar::None, Push, true},
    ActionSpec{"arrange.right", QT_TRANSLATE_NOOP("Actions", "Align &Right"), "", "Alt+Shift+Right",
               QT_TRANSLATE_NOOP("Actions", "Lay the right sides on one line."), Menu::Arrange},
    ActionSpec{"arrange.top", QT_TRANSLATE_NOOP("Actions", "Align &Top"), "", "Alt+Shift+Up",
               QT_TRANSLATE_NOOP("Actions", "Lay the upper sides on one line."), Menu::Arrange},
    ActionSpec{"arrange.bottom", QT_TRANSLATE_NOOP("Actions", "Align &Bottom"), "",
               "Alt+Shift+Down", QT_TRANSLATE_NOOP("Actions", "Lay the lower sides on one line."),
               Menu::Arrange},
    ActionSpec{"arrange.centre_x", QT_TRANSLATE_NOOP("Actions", "Align &Middles in a Column"), "",
               "Alt+Shift+C", QT_TRANSLATE_NOOP("Actions", "Lay the middles above one another."),
               Menu::Arrange},
    ActionSpec{"arrange.centre_y", QT_TRANSLATE_NOOP("Actions", "Align M&iddles in a Row"), "",
               "Alt+Shift+M", QT_TRANSLATE_NOOP("Actions", "Lay the middles beside one another."),
               Menu::Arrange},
    ActionSpec{"arrange.distribute_x", QT_TRANSLATE_NOOP("Actions", "&Distribute in a Row"), "",
               "Alt+Shift+H",
               QT_TRANSLATE_NOOP("Actions", "Make the gaps from left to right equal."),
               Menu::Arrange},
    ActionSpec{"arrange.distribute_y", QT_TRANSLATE_NOOP("Actions", "Distribute in a &Column"), "",
               "Alt+Shift+V",
               QT_TRANSLATE_NOOP("Actions", "Make the gaps from bottom to top equal."),
               Menu::Arrange},

    ActionSpec{"view.zoom_in", QT_TRANSLATE_NOOP("Actions", "Zoom &In"), "zoom-in",
               "Ctrl++; Ctrl+=; +", QT_TRANSLATE_NOOP("Actions", "Show it larger."), Menu::View,
               ToolBar::Main, Push, true},
    ActionSpec{"view.zoom_out", QT_TRANSLATE_NOOP("Actions", "Zoom &Out"), "zoom-out", "Ctrl+-; -",
               QT_TRANSLATE_NOOP("Actions", "Show more of the map."), Menu::View, ToolBar::Main},
    ActionSpec{"view.zoom_fit", QT_TRANSLATE_NOOP("Actions", "Zoom to &Fit"), "zoom-fit",
               "Ctrl+0; F", QT_TRANSLATE_NOOP("Actions", "Show the whole map."), Menu::View,
               ToolBar::Main},
    ActionSpec{"view.grid", QT_TRANSLATE_NOOP("Actions", "&Grid"), "grid", "G",
               QT_TRANSLATE_NOOP("Actions", "Show the metric grid."), Menu::View, ToolBar::Main,
               Check, true},
    ActionSpec{"view.snap", QT_TRANSLATE_NOOP("Actions", "&Snap to Half Metres"), "", "Shift+G",
               QT_TRANSLATE_NOOP("Actions", "Keep points on a grid of half a metre while drawing."),
               Menu::View, ToolBar::None, Check},
    ActionSpec{
        "view.snap_objects", QT_TRANSLATE_NOOP("Actions", "Snap &to Objects"), "", "Shift+O",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Draw points to corners, walls, their lines and right angles; Alt holds it off."),
        Menu::View, ToolBar::None, Check},
    ActionSpec{"view.snap_next", QT_TRANSLATE_NOOP("Actions", "&Next Way to Snap"), "", "N",
               QT_TRANSLATE_NOOP("Actions", "Objects, grid, both or neither in turn."), Menu::View},

    ActionSpec{"view.follow", QT_TRANSLATE_NOOP("Actions", "Follo&w the Robot"), "", "Shift+F",
               QT_TRANSLATE_NOOP("Actions",
                                 "Keep the robot in the middle; again: and turn the map as it "
                                 "looks; again: off."),
               Menu::View, ToolBar::None, Push, true},
    ActionSpec{"view.uncertainty", QT_TRANSLATE_NOOP("Actions", "&Uncertainty"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Show by soft edges how wrong the drawing may be."),
               Menu::View, ToolBar::None, Check},
    ActionSpec{"view.theme_system", QT_TRANSLATE_NOOP("Actions", "As the &System Has It"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Light or dark as the desktop is."), Menu::View,
               ToolBar::None, Check, true},
    ActionSpec{"view.theme_light", QT_TRANSLATE_NOOP("Actions", "&Light"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Dark ink on a light ground."), Menu::View,
               ToolBar::None, Check},
    ActionSpec{"view.theme_dark", QT_TRANSLATE_NOOP("Actions", "&Dark"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Light ink on a dark ground."), Menu::View,
               ToolBar::None, Check},
    ActionSpec{"view.language_system", QT_TRANSLATE_NOOP("Actions", "Language of the S&ystem"), "",
               "",
               QT_TRANSLATE_NOOP("Actions", "Speak as the desktop does, from the next start on."),
               Menu::View, ToolBar::None, Check, true},
    ActionSpec{"view.language_en", QT_TRANSLATE_NOOP("Actions", "&English"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Speak English, from the next start on."), Menu::View,
               ToolBar::None, Check},
    ActionSpec{"view.language_ja", QT_TRANSLATE_NOOP("Actions", "日本語 (&Japanese)"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Speak Japanese, from the next start on."), Menu::View,
               ToolBar::None, Check},

    ActionSpec{"draw.select", QT_TRANSLATE_NOOP("Actions", "&Select"), "select", "S",
               QT_TRANSLATE_NOOP("Actions", "Select, move, resize and turn."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.rectangle", QT_TRANSLATE_NOOP("Actions", "&Rectangle"), "rectangle", "R",
               QT_TRANSLATE_NOOP("Actions", "Draw a rectangular building."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.edge_rectangle", QT_TRANSLATE_NOOP("Actions", "Rectangle by &Edge"),
               "edge-rectangle", "E",
               QT_TRANSLATE_NOOP("Actions", "Draw one wall at any angle, then the depth."),
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.polygon", QT_TRANSLATE_NOOP("Actions", "&Polygon"), "polygon", "P",
               QT_TRANSLATE_NOOP("Actions", "Draw a building of any shape."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.freehand", QT_TRANSLATE_NOOP("Actions", "Free&hand"), "freehand", "D",
               QT_TRANSLATE_NOOP("Actions", "Draw around a building; the stroke is made straight."),
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{"draw.start", QT_TRANSLATE_NOOP("Actions", "S&tart"), "start", "T",
               QT_TRANSLATE_NOOP("Actions", "Say where the robot starts and looks."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.route", QT_TRANSLATE_NOOP("Actions", "R&oute"), "route", "O",
               QT_TRANSLATE_NOOP("Actions", "Draw the way that the robot shall take."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.landmark", QT_TRANSLATE_NOOP("Actions", "&Landmark"), "landmark", "L",
               QT_TRANSLATE_NOOP("Actions", "Mark a place by name."), Menu::Draw, ToolBar::Tools,
               Tool},

    ActionSpec{"draw.measure", QT_TRANSLATE_NOOP("Actions", "&Measure"), "measure", "M",
               QT_TRANSLATE_NOOP("Actions", "Read lengths, angles and areas."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.eraser", QT_TRANSLATE_NOOP("Actions", "Er&aser"), "eraser", "X",
               QT_TRANSLATE_NOOP("Actions", "Erase what a stroke touches."), Menu::Draw,
               ToolBar::Tools, Tool},
    ActionSpec{"draw.recognize", QT_TRANSLATE_NOOP("Actions", "&Guess Shapes of Strokes"), "",
               "Shift+D",
               QT_TRANSLATE_NOOP("Actions",
                                 "Offer a rectangle, an L or a polygon for each freehand stroke."),
               Menu::Draw, ToolBar::None, Check, true},

    ActionSpec{"draw.picture", QT_TRANSLATE_NOOP("Actions", "Ad&just Picture"), "picture", "U",
               QT_TRANSLATE_NOOP("Actions", "Move, turn and scale a picture under the drawing."),
               Menu::Draw, ToolBar::Tools, Tool},
    ActionSpec{
        "draw.add_picture", QT_TRANSLATE_NOOP("Actions", "Add Picture &Underneath…"), "",
        "Ctrl+Shift+U",
        QT_TRANSLATE_NOOP("Actions", "Draw upon an aerial photo, a plan or a photo of a sketch."),
        Menu::Draw, ToolBar::None, Push, true},

    ActionSpec{"run.open_recording", QT_TRANSLATE_NOOP("Actions", "Open Re&cording…"), "record",
               "Ctrl+Shift+O",
               QT_TRANSLATE_NOOP("Actions", "Take the robot's observations from a recording."),
               Menu::Run, ToolBar::Transport},
    ActionSpec{
        "run.connect", QT_TRANSLATE_NOOP("Actions", "C&onnect a Robot…"), "", "Ctrl+Shift+R",
        QT_TRANSLATE_NOOP("Actions", "Put a live robot together: camera or scanner, head, wheels."),
        Menu::Run},
    ActionSpec{"run.calibrate", QT_TRANSLATE_NOOP("Actions", "Ca&librate Cameras…"), "", "",
               QT_TRANSLATE_NOOP(
                   "Actions", "Hold a checkerboard before a stereo camera, so that it measures."),
               Menu::Run},
    ActionSpec{
        "run.simulator", QT_TRANSLATE_NOOP("Actions", "Si&mulator"), "", "Ctrl+Shift+M",
        QT_TRANSLATE_NOOP("Actions", "Take the robot's observations from the built-in simulator."),
        Menu::Run},
    ActionSpec{"run.run", QT_TRANSLATE_NOOP("Actions", "&Run"), "run", "F5",
               QT_TRANSLATE_NOOP("Actions", "Localize on the drawing and correct it."), Menu::Run,
               ToolBar::Transport, Push, true},
    ActionSpec{"run.pause", QT_TRANSLATE_NOOP("Actions", "&Pause"), "pause", "F6",
               QT_TRANSLATE_NOOP("Actions", "Hold after this observation."), Menu::Run,
               ToolBar::Transport},
    ActionSpec{"run.step", QT_TRANSLATE_NOOP("Actions", "S&tep"), "step", "F7",
               QT_TRANSLATE_NOOP("Actions", "Work in one observation, then hold."), Menu::Run,
               ToolBar::Transport},
    ActionSpec{
        "run.phase", QT_TRANSLATE_NOOP("Actions", "Next Phas&e"), "phase", "F8",
        QT_TRANSLATE_NOOP("Actions", "Work in one observation and go through it, phase by phase."),
        Menu::Run, ToolBar::Transport},
    ActionSpec{"run.back", QT_TRANSLATE_NOOP("Actions", "Step &Back"), "back", "Shift+F7",
               QT_TRANSLATE_NOOP("Actions", "Look at the observation before."), Menu::Run,
               ToolBar::Transport},
    ActionSpec{"run.newest", QT_TRANSLATE_NOOP("Actions", "To the Ne&west"), "newest", "Ctrl+End",
               QT_TRANSLATE_NOOP("Actions", "Look at how it is now, no longer at the past."),
               Menu::Run, ToolBar::Transport},
    ActionSpec{"run.stop", QT_TRANSLATE_NOOP("Actions", "&Stop"), "stop", "Shift+F5",
               QT_TRANSLATE_NOOP("Actions", "End the run."), Menu::Run, ToolBar::Transport},
    ActionSpec{"run.accept", QT_TRANSLATE_NOOP("Actions", "&Accept Refinement"), "accept",
               "Ctrl+Return",
               QT_TRANSLATE_NOOP(
                   "Actions",
                   "Take the corrected shapes into the drawing, as one step that can be undone."),
               Menu::Run, ToolBar::Transport, Push, true},
    ActionSpec{"run.bookmark", QT_TRANSLATE_NOOP("Actions", "Boo&kmark This Moment"), "", "Ctrl+B",
               QT_TRANSLATE_NOOP("Actions", "Mark it on the timeline, or take the mark away."),
               Menu::Run, ToolBar::None, Push, true},
    ActionSpec{"run.next_bookmark", QT_TRANSLATE_NOOP("Actions", "Ne&xt Bookmark"), "",
               "Ctrl+Shift+B",
               QT_TRANSLATE_NOOP("Actions", "Look at the next moment that is marked."), Menu::Run},
    ActionSpec{
        "run.recompute", QT_TRANSLATE_NOOP("Actions", "Recomp&ute with the Drawing"), "", "Ctrl+F5",
        QT_TRANSLATE_NOOP(
            "Actions", "Do the run again, so far as it has come, with the drawing as it is now."),
        Menu::Run, ToolBar::None, Push, true},
    ActionSpec{
        "run.give_pose", QT_TRANSLATE_NOOP("Actions", "Robot Is &Here…"), "", "H",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Say where the robot is at the moment that is shown; the run is done again with it."),
        Menu::Run, ToolBar::None, Tool},
    ActionSpec{"run.load_poses", QT_TRANSLATE_NOOP("Actions", "Open Gi&ven Poses…"), "", "",
               QT_TRANSLATE_NOOP("Actions",
                                 "Lead the way through poses of a file in TUM form, in the frame "
                                 "of the map."),
               Menu::Run},
    ActionSpec{"run.forget_poses", QT_TRANSLATE_NOOP("Actions", "&Forget Given Poses"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Do the run again without the poses that you gave."),
               Menu::Run},
    ActionSpec{
        "run.right", QT_TRANSLATE_NOOP("Actions", "Building Is Ri&ght"), "", "Ctrl+G",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Hold the selected buildings where the run shows them, and do it again with that."),
        Menu::Run},
    ActionSpec{
        "run.not_there", QT_TRANSLATE_NOOP("Actions", "Building Is &Not There"), "", "Ctrl+Del",
        QT_TRANSLATE_NOOP(
            "Actions",
            "Take the selected buildings out of the drawing, and do the run again without them."),
        Menu::Run},
    ActionSpec{"run.why", QT_TRANSLATE_NOOP("Actions", "Wh&y Is This Wall Here"), "", "Shift+W",
               QT_TRANSLATE_NOOP("Actions",
                                 "Ask what placed a corrected wall: which observations, and how "
                                 "far each pulled."),
               Menu::Run, ToolBar::None, Push, true},
    ActionSpec{
        "run.teach", QT_TRANSLATE_NOOP("Actions", "Teach Bu&ildings…"), "", "",
        QT_TRANSLATE_NOOP("Actions", "Show in your own images what is a building and what is not."),
        Menu::Run, ToolBar::None, Push, true},

    ActionSpec{"help.guide", QT_TRANSLATE_NOOP("Actions", "&Guide"), "", "F1",
               QT_TRANSLATE_NOOP("Actions", "How everything is done, with pictures."), Menu::Help},
    ActionSpec{"help.commands", QT_TRANSLATE_NOOP("Actions", "&Command Palette…"), "",
               "Ctrl+Shift+P", QT_TRANSLATE_NOOP("Actions", "Find any command by a few letters."),
               Menu::Help},
    ActionSpec{"help.shortcuts", QT_TRANSLATE_NOOP("Actions", "&Keyboard Shortcuts"), "", "Ctrl+/",
               QT_TRANSLATE_NOOP("Actions", "Show and change every key."), Menu::Help},
    ActionSpec{"help.tour", QT_TRANSLATE_NOOP("Actions", "&Tour"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Show in five steps where things are."), Menu::Help},
    ActionSpec{"help.about", QT_TRANSLATE_NOOP("Actions", "&About Handmap"), "", "",
               QT_TRANSLATE_NOOP("Actions", "Version and licence."), Menu::Help},
};

}  // namespace

std::span<const ActionSpec> actionTable() { return kActions; }

const char* menuTitle(Menu menu) {
  switch (menu) {
    case Menu::File:
      return QT_TRANSLATE_NOOP("Actions", "&File");
    case Menu::Edit:
      return QT_TRANSLATE_NOOP("Actions", "&Edit");
    case Menu::Arrange:
      return QT_TRANSLATE_NOOP("Actions", "&Arrange");
    case Menu::View:
      return QT_TRANSLATE_NOOP("Actions", "&View");
    case Menu::Draw:
      return QT_TRANSLATE_NOOP("Actions", "&Draw");
    case Menu::Run:
      return QT_TRANSLATE_NOOP("Actions", "&Run");
    case Menu::Help:
      return QT_TRANSLATE_NOOP("Actions", "&Help");
  }
  return "";
}

}  // namespace handmap

// The commands of handmap-cli. Each declares its options; one a file.
#pragma once

#include <functional>

#include <CLI/App.hpp>

namespace handmap {

/// What the command line asked for; gives the exit status.
using ChosenCommand = std::function<int()>;

void addRunCommand(CLI::App& app, ChosenCommand& chosen);
void addSimulateCommand(CLI::App& app, ChosenCommand& chosen);
void addPerturbCommand(CLI::App& app, ChosenCommand& chosen);
void addOdometryCommand(CLI::App& app, ChosenCommand& chosen);
void addCalibrateCommand(CLI::App& app, ChosenCommand& chosen);
void addCompareCommand(CLI::App& app, ChosenCommand& chosen);
void addConvertCommand(CLI::App& app, ChosenCommand& chosen);
void addEvaluateCommand(CLI::App& app, ChosenCommand& chosen);
void addFiguresCommand(CLI::App& app, ChosenCommand& chosen);
void addSketchStatsCommand(CLI::App& app, ChosenCommand& chosen);
void addTraceCommand(CLI::App& app, ChosenCommand& chosen);
void addSheetCommand(CLI::App& app, ChosenCommand& chosen);
void addInfoCommand(CLI::App& app, ChosenCommand& chosen);
void addImportCommand(CLI::App& app, ChosenCommand& chosen);
void addReportCommand(CLI::App& app, ChosenCommand& chosen);
void addTryCommand(CLI::App& app, ChosenCommand& chosen);
void addValidateCommand(CLI::App& app, ChosenCommand& chosen);
void addTrainCommand(CLI::App& app, ChosenCommand& chosen);
void addClassifyCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace handmap

// What an experiment has shown: tables to read, tables to compute with, charts.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/experiments/chart.h"
#include "core/experiments/experiment.h"

namespace handmap {

struct Report {
  std::string markdown;
  std::string csv;
  std::vector<std::pair<std::string, Chart>> charts;  ///< name of the file → chart
};

/// Of those of the experiment's trials that are there; the same for the same trials, however they
/// were run.
Report reportOf(const Experiment& experiment, const std::map<TrialKey, Trial>& trials);

/// report.md, report.csv and the charts as PNG.
void writeReport(const Report& report, const std::filesystem::path& folder);

/// Trials of one method at one σ.
struct TrialGroup {
  Method method = Method::Handmap;
  double sigma_m = 0.0;
  std::vector<const Trial*> trials;
};

SeriesLook lookOf(Method method);

// The parts that each experiment adds. Groups are in the order of σ.
void addSuccess(const std::vector<TrialGroup>& groups, Like like, Report& report);  // Table2
void addErrors(const std::vector<TrialGroup>& groups, Report& report);              // Figure8
void addWay(const std::vector<TrialGroup>& groups, Report& report);                 // Way

}  // namespace handmap

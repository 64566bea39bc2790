// The stages of an observation, as charts and tables name and draw them.
#pragma once

#include <Qt>
#include <QtGlobal>
#include <array>

#include "core/method/snapshot.h"

namespace handmap {

struct Stage {
  const char* name;
  double StageTimes::*ms;
  Qt::BrushStyle pattern;  ///< never colour alone
};

inline constexpr std::array<Stage, 5> kStages = {{
    {QT_TRANSLATE_NOOP("handmap::BudgetTable", "reading"), &StageTimes::read, Qt::Dense6Pattern},
    {QT_TRANSLATE_NOOP("handmap::BudgetTable", "stereo"), &StageTimes::stereo, Qt::BDiagPattern},
    {QT_TRANSLATE_NOOP("handmap::BudgetTable", "buildings in images"), &StageTimes::classify,
     Qt::Dense4Pattern},
    {QT_TRANSLATE_NOOP("handmap::BudgetTable", "walls around"), &StageTimes::local_map,
     Qt::FDiagPattern},
    {QT_TRANSLATE_NOOP("handmap::BudgetTable", "finding and correcting"), &StageTimes::slam,
     Qt::SolidPattern},
}};

}  // namespace handmap

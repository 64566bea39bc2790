// The phases of an observation in plain words.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/method/phase.h"

namespace handmap {

class PhaseWords {
  Q_DECLARE_TR_FUNCTIONS(handmap::PhaseWords)
 public:
  /// "Swarms 2/10"
  static QString name(const Phase& phase);
  /// "The best outlines moved by up to 0.42 m."
  static QString change(const Phase& phase);
};

}  // namespace handmap

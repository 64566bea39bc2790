// The figures of a drawing against the truth, each in a few words and told in plain ones.
#pragma once

#include <QString>
#include <string>

namespace handmap {

enum class FigureGroup { Things, Euclidean, Affine, Pairs, Count };

QString titleOf(FigureGroup group);

struct FigureWords {
  FigureGroup group = FigureGroup::Things;
  QString title;
  QString explanation;
};

/// By the name in the table of core/sketch_study; without a title where that is no figure.
FigureWords figureWords(const std::string& name);

/// To four digits and with the unit that the name says; a dash where it cannot be told.
QString figureValue(const std::string& name, const std::string& value);

}  // namespace handmap

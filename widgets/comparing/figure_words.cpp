#include "widgets/comparing/figure_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace handmap {

namespace {

struct Entry {
  std::string_view name;
  const char* title;
  const char* explanation;
};

constexpr const char* kContext = "FigureWords";

constexpr std::array kThings = {
    Entry{"true_objects", QT_TRANSLATE_NOOP("FigureWords", "In the true map"),
          QT_TRANSLATE_NOOP("FigureWords", "How many buildings and landmarks the true map has.")},
    Entry{"drawn_objects", QT_TRANSLATE_NOOP("FigureWords", "Drawn"),
          QT_TRANSLATE_NOOP("FigureWords", "How many of them are in the drawing, by the same id.")},
    Entry{"missing", QT_TRANSLATE_NOOP("FigureWords", "Missing"),
          QT_TRANSLATE_NOOP("FigureWords", "How many of them are not in the drawing.")},
    Entry{"extra", QT_TRANSLATE_NOOP("FigureWords", "Only in the drawing"),
          QT_TRANSLATE_NOOP("FigureWords", "How many are drawn that the true map does not have.")},
    Entry{"completeness_share", QT_TRANSLATE_NOOP("FigureWords", "Completeness"),
          QT_TRANSLATE_NOOP("FigureWords", "The share of the true map that is drawn: 1 is all.")},
    Entry{"amalgamated", QT_TRANSLATE_NOOP("FigureWords", "Drawn as one with others"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How many true buildings are missing where a drawn one covers their "
                            "place.")},
    Entry{"abstracted", QT_TRANSLATE_NOOP("FigureWords", "Stood for by a few"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How many true buildings a few drawn ones stand for. Only known of "
                            "sketches with an alignment file, else 0.")},
    Entry{"collapsed", QT_TRANSLATE_NOOP("FigureWords", "Drawn as a point"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How many true buildings are a mere point in the drawing. Only known "
                            "of sketches with an alignment file, else 0.")},
    Entry{"mean_overlap_share", QT_TRANSLATE_NOOP("FigureWords", "Overlap (IoU)"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far the drawn and the true outline of a building cover each "
                            "other as they lie, on average: 1 is the same outline, 0 is beside "
                            "it.")},
};

/// Of either fit.
constexpr std::array kFit = {
    Entry{"r", QT_TRANSLATE_NOOP("FigureWords", "Correlation r"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How alike the places of both maps are once the true map is laid on "
                            "the drawing: 1 is the same, 0 is nothing alike.")},
    Entry{"r_squared", QT_TRANSLATE_NOOP("FigureWords", "Explained share r²"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "The share of the spread of the drawn places that follows from the "
                            "true ones.")},
    Entry{"theta_deg", QT_TRANSLATE_NOOP("FigureWords", "Turn θ"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far the drawing as a whole is turned, counter-clockwise.")},
    Entry{"scale_x", QT_TRANSLATE_NOOP("FigureWords", "Scale along x"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "The width of the drawing as a multiple of the true one: above 1 it "
                            "is drawn too large.")},
    Entry{"scale_y", QT_TRANSLATE_NOOP("FigureWords", "Scale along y"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "The height of the drawing as a multiple of the true one: above 1 it "
                            "is drawn too large.")},
    Entry{"shear", QT_TRANSLATE_NOOP("FigureWords", "Shear"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far what is upright leans to the right in the drawing: 0 is not "
                            "at all.")},
    Entry{"shift_x_m", QT_TRANSLATE_NOOP("FigureWords", "Shift along x"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far to the right the origin of the true map comes to lie in the "
                            "drawing.")},
    Entry{"shift_y_m", QT_TRANSLATE_NOOP("FigureWords", "Shift along y"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far up the origin of the true map comes to lie in the drawing.")},
    Entry{"distortion_m", QT_TRANSLATE_NOOP("FigureWords", "Distortion D"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "What is left between both maps once one is laid on the other: the "
                            "root of the sum of all squared distances.")},
    Entry{"max_distortion_m", QT_TRANSLATE_NOOP("FigureWords", "Greatest distortion D max"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "What would be left if the drawing had nothing of the true map.")},
    Entry{"distortion_index", QT_TRANSLATE_NOOP("FigureWords", "Distortion index"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "Distortion as a share of the greatest one: 0 is none, 1 is a drawing "
                            "that has nothing of the true map.")},
    Entry{"f", QT_TRANSLATE_NOOP("FigureWords", "Test value F"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How much follows from the true map against what does not: the "
                            "larger, the less it is by chance.")},
    Entry{"f_model_df", QT_TRANSLATE_NOOP("FigureWords", "Degrees of freedom of the fit"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How many numbers lay one map on the other, beside the shift.")},
    Entry{"f_residual_df", QT_TRANSLATE_NOOP("FigureWords", "Degrees of freedom left"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How many coordinates are left to test it, once those numbers and the "
                            "shift are taken away.")},
    Entry{"p", QT_TRANSLATE_NOOP("FigureWords", "Probability p"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How likely so large an F is by chance alone: below 0.05 is usually "
                            "taken as not by chance.")},
    Entry{"aic", QT_TRANSLATE_NOOP("FigureWords", "Information criterion (AIC)"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "Whether the true map tells where things are drawn, against no "
                            "relation at all: below 0 it does.")},
};

constexpr std::array kAffineBetter = {
    Entry{"affine_better_f", QT_TRANSLATE_NOOP("FigureWords", "Gain over one scale: F"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How much more follows once the drawing may be stretched and sheared "
                            "too: the larger, the more.")},
    Entry{"affine_better_p", QT_TRANSLATE_NOOP("FigureWords", "Gain over one scale: p"),
          QT_TRANSLATE_NOOP("FigureWords", "How likely so large a gain is by chance alone.")},
    Entry{"affine_better_aic", QT_TRANSLATE_NOOP("FigureWords", "Gain over one scale: AIC"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "Whether stretch and shear are worth two more numbers: below 0 they "
                            "are.")},
};

constexpr std::array kPairs = {
    Entry{"canonical_organisation_share",
          QT_TRANSLATE_NOOP("FigureWords", "Canonical organisation"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "The share of pairs in which the right one is the northern and the "
                            "right one the eastern; what is missing counts as wrong.")},
    Entry{"canonical_organisation_sqrt",
          QT_TRANSLATE_NOOP("FigureWords", "Canonical organisation, root"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "Its square root, which can be held against the completeness.")},
    Entry{"canonical_accuracy_share", QT_TRANSLATE_NOOP("FigureWords", "Canonical accuracy"),
          QT_TRANSLATE_NOOP("FigureWords", "The same of those pairs alone that are drawn.")},
    Entry{"canonical_accuracy_sqrt", QT_TRANSLATE_NOOP("FigureWords", "Canonical accuracy, root"),
          QT_TRANSLATE_NOOP("FigureWords", "Its square root.")},
    Entry{"distance_accuracy_share", QT_TRANSLATE_NOOP("FigureWords", "Distance accuracy"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How right the distances from one to another are, whatever the scale: "
                            "1 is right.")},
    Entry{"scaling_bias_share", QT_TRANSLATE_NOOP("FigureWords", "Scaling bias"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "Above 0: short distances are drawn too long beside the longest one; "
                            "below 0: too short.")},
    Entry{"angle_accuracy_share", QT_TRANSLATE_NOOP("FigureWords", "Angle accuracy"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How right the directions from one to another are: 1 is right.")},
    Entry{"rotational_bias_deg", QT_TRANSLATE_NOOP("FigureWords", "Rotational bias"),
          QT_TRANSLATE_NOOP("FigureWords",
                            "How far directions from one to another are turned on average, "
                            "counter-clockwise.")},
};

QString said(const char* text) { return QCoreApplication::translate(kContext, text); }

template <typename Entries>
FigureWords wordsIn(const Entries& entries, FigureGroup group, std::string_view name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  if (found == entries.end()) return {};
  return {group, said(found->title), said(found->explanation)};
}

}  // namespace

QString titleOf(FigureGroup group) {
  switch (group) {
    case FigureGroup::Things:
      return said(QT_TRANSLATE_NOOP("FigureWords", "What is drawn"));
    case FigureGroup::Euclidean:
      return said(
          QT_TRANSLATE_NOOP("FigureWords", "Laid on it by shift, turn and one scale (Euclidean)"));
    case FigureGroup::Affine:
      return said(QT_TRANSLATE_NOOP("FigureWords", "Stretched and sheared too (affine)"));
    case FigureGroup::Pairs:
      return said(QT_TRANSLATE_NOOP("FigureWords", "From one to another"));
    case FigureGroup::Count:
      break;
  }
  return {};
}

FigureWords figureWords(const std::string& name) {
  const std::string_view whole = name;
  for (const FigureWords& words : {wordsIn(kThings, FigureGroup::Things, whole),
                                   wordsIn(kAffineBetter, FigureGroup::Affine, whole),
                                   wordsIn(kPairs, FigureGroup::Pairs, whole)}) {
    if (!words.title.isEmpty()) return words;
  }
  for (const auto& [kind, group] :
       {std::pair(std::string_view("euclidean_"), FigureGroup::Euclidean),
        std::pair(std::string_view("affine_"), FigureGroup::Affine)}) {
    if (whole.starts_with(kind)) return wordsIn(kFit, group, whole.substr(kind.size()));
  }
  return {};
}

QString figureValue(const std::string& name, const std::string& value) {
  QString text = QString::fromStdString(value);
  if (text.isEmpty()) return QStringLiteral("–");
  if (text.contains(u'.') || text.contains(u'e')) text = QString::number(text.toDouble(), 'g', 4);
  if (name.ends_with("_m")) return said(QT_TRANSLATE_NOOP("FigureWords", "%1 m")).arg(text);
  if (name.ends_with("_deg")) return text + QStringLiteral("°");
  return text;
}

}  // namespace handmap

// Which part of a recording a person looks at, kept for each of the last recordings: what was asked
// for of one says nothing of another.
#pragma once

#include <QSettings>
#include <QString>

#include "core/recording/recording.h"

namespace handmap {

/// As it was the last time; all of it where it is a new one, or was long ago.
ReplayOptions settingsOfRecording(const QSettings& settings, const QString& folder);
void keepSettingsOfRecording(QSettings& settings, const QString& folder,
                             const ReplayOptions& options);

}  // namespace handmap

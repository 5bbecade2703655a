// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/reason_text.h"

#include <array>

#include "engine/core/sentence.h"
#include "ui/link/texts.h"

namespace kerf::ui {

QString reasonText(const std::string& stored) {
    static constexpr std::array kOwn{KERF_TEXT("part type created"),
                                     KERF_TEXT("full"),
                                     KERF_TEXT("lot selected"),
                                     KERF_TEXT("setup changed"),
                                     KERF_TEXT("kept by a version that noted no hash"),
                                     KERF_TEXT("law chosen"),
                                     KERF_TEXT("law of before"),
                                     KERF_TEXT("changed while cutting"),
                                     KERF_TEXT("typed"),
                                     KERF_TEXT("blank profile of before"),
                                     KERF_TEXT("accepted"),
                                     KERF_TEXT("rolled back")};
    static constexpr const char* kStudy = KERF_TEXT("repeatability of gauge %1, study %2");
    for (const char* own : kOwn) {
        if (stored == own) {
            return engineText(own);
        }
    }
    const QString text = QString::fromStdString(stored);
    const QString begin = QStringLiteral("repeatability of gauge ");
    const qsizetype study = text.lastIndexOf(QLatin1String(", study "));
    if (text.startsWith(begin) && study > begin.size()) {
        return engineText(kStudy).arg(text.mid(begin.size(), study - begin.size()),
                                      text.mid(study + QLatin1String(", study ").size()));
    }
    return text;
}

}  // namespace kerf::ui

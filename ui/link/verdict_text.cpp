// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/verdict_text.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct VerdictTexts {
    Q_DECLARE_TR_FUNCTIONS(VerdictTexts)
};

}  // namespace

QString verdictText(quality::Verdict verdict) {
    switch (verdict) {
        case quality::Verdict::Good:
            return VerdictTexts::tr("good");
        case quality::Verdict::NotJudged:
            return VerdictTexts::tr("not judged");
        case quality::Verdict::Rework:
            return VerdictTexts::tr("rework possible");
        case quality::Verdict::Scrap:
            break;
    }
    return VerdictTexts::tr("scrap");
}

}  // namespace kerf::ui

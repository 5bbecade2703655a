// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/recipe_sheet.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QTableWidget>
#include <algorithm>

#include "engine/api/part_results.h"
#include "ui/dialogs/list_table.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/reason_text.h"
#include "ui/link/texts.h"
#include "ui/services/recipe_history.h"
#include "ui/shell/page.h"
#include "ui/theme/particles.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct Revisions {
    Q_DECLARE_TR_FUNCTIONS(Revisions)
};

constexpr std::size_t kChangesShown = 8;

/// A place in a list, such as a point of a curve.
bool inList(const RecipeChangeView& change) {
    const QStringList path = QString::fromStdString(change.key).split(u'.');
    return std::ranges::any_of(path, [](const QString& name) {
        return !name.isEmpty() && std::ranges::all_of(name, [](QChar c) { return c.isDigit(); });
    });
}

/// What the limits of a figure are called in a recipe: "figure_limits.surface_rms_um.upper".
struct LimitChange {
    const PartResultSpec* figure{nullptr};  ///< null: no limit of a figure that this version knows
    QString words{};
};
LimitChange limitChange(const std::string& key) {
    const QStringList path = QString::fromStdString(key).split(u'.');
    if (path.size() != 3 || path[0] != QLatin1String("figure_limits")) {
        return {};
    }
    LimitChange change;
    for (const ProcessId process : allProcesses()) {
        if (change.figure == nullptr) {
            change.figure = findPartResult(process, path[1].toStdString());
        }
    }
    if (change.figure != nullptr) {
        const QString name = engineText(change.figure->label);
        change.words = path[2] == QLatin1String("lower")   ? Revisions::tr("%1, lower limit").arg(name)
                       : path[2] == QLatin1String("upper") ? Revisions::tr("%1, upper limit").arg(name)
                                                           : QString();
    }
    return change;
}

/// What differs is told in these.
struct Words {
    RecipeSpecOf specOf{};
    RecipeWordOf wordOf{};
};

QString valueText(const std::string& key, const std::string& stored, const Words& words, const UnitSystem& units) {
    if (stored.empty()) {
        return QStringLiteral("–");
    }
    const ParamSpec* spec = words.specOf ? words.specOf(key) : nullptr;
    if (stored.size() >= 2 && stored.front() == '"') {
        const QString text = QString::fromStdString(stored.substr(1, stored.size() - 2));
        const QString word = words.wordOf ? words.wordOf(key, text) : QString();
        return word.isEmpty() ? text : word;
    }
    bool isNumber = false;
    const double value = QString::fromStdString(stored).toDouble(&isNumber);
    if (spec != nullptr && (stored == "true" || stored == "false")) {
        return stored == "true" ? Revisions::tr("yes") : Revisions::tr("no");
    }
    return spec != nullptr && isNumber ? units.withUnit(value, spec->unit, spec->decimals)
                                       : QString::fromStdString(stored);
}

QString differenceText(std::vector<RecipeChangeView> changes, const Words& words, const UnitSystem& units) {
    const RecipeSpecOf& specOf = words.specOf;
    // Which side can be cut again goes with the limit.
    std::erase_if(changes, [](const RecipeChangeView& change) {
        const LimitChange limit = limitChange(change.key);
        return limit.figure != nullptr && limit.words.isEmpty();
    });
    std::ranges::stable_partition(changes, [](const RecipeChangeView& change) { return !inList(change); });
    // What has a name in the shop is named; the rest, where there is such, is only counted.
    const auto unnamed = std::ranges::stable_partition(changes, [&specOf](const RecipeChangeView& change) {
        return !specOf || specOf(change.key) != nullptr || limitChange(change.key).figure != nullptr;
    });
    const auto named = changes.size() - unnamed.size();
    const std::size_t shown = std::min(named > 0 ? named : changes.size(), kChangesShown);
    QStringList lines;
    for (std::size_t i = 0; i < shown; ++i) {
        const RecipeChangeView& change = changes[i];
        if (const LimitChange limit = limitChange(change.key); limit.figure != nullptr) {
            const auto limitText = [&](const std::string& stored) {
                bool isNumber = false;
                const double value = QString::fromStdString(stored).toDouble(&isNumber);
                return isNumber ? units.withUnit(value, limit.figure->unit, limit.figure->decimals)
                                : Revisions::tr("none", "limit");
            };
            lines << QStringLiteral("%1: %2 → %3").arg(limit.words, limitText(change.before), limitText(change.after));
            continue;
        }
        const ParamSpec* spec = specOf ? specOf(change.key) : nullptr;
        lines << QStringLiteral("%1: %2 → %3")
                     .arg(spec != nullptr ? engineText(spec->label) : QString::fromStdString(change.key),
                          valueText(change.key, change.before, words, units),
                          valueText(change.key, change.after, words, units));
    }
    if (changes.size() > shown) {
        lines << Revisions::tr("and %1 more values").arg(changes.size() - shown);
    }
    return lines.isEmpty() ? Revisions::tr("The same values as now.") : lines.join(u'\n');
}

QTableWidget* makeTable(Look& look, const std::vector<RecipeRevisionView>& known, QWidget* parent) {
    QList<QStringList> rows;
    for (const RecipeRevisionView& one : known) {
        const QString when =
            QDateTime::fromMSecsSinceEpoch(one.createdUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        const QString why = one.restoredFrom ? withParticles(Revisions::tr("back to %1: %2", "revision, reason")
                                                                 .arg(*one.restoredFrom)
                                                                 .arg(reasonText(one.reason)))
                                             : reasonText(one.reason);
        rows << QStringList{QString::number(one.revision), when + u' ' + QString::fromStdString(one.author), why};
    }
    return makeListTable(look, "recipeRevisions",
                         {Revisions::tr("Rev."), Revisions::tr("When, by"), Revisions::tr("Why")}, rows, {2}, parent);
}

/// Over a form that was open, which comes back as it was; or alone, once what stood in the form is no longer what
/// holds.
enum class Place : std::uint8_t { Over, Alone };

void showRevisions(const PageContext& context, RecipeHistory& history, Deed deed, const RecipeSpecOf& specOf,
                   const RecipeWordOf& wordOf, Place place) {
    Look& look = context.look;
    const auto read = history.revisions();
    const std::vector<RecipeRevisionView> known = read ? *read : std::vector<RecipeRevisionView>{};
    const QString title = Revisions::tr("Revisions of %1").arg(QString::fromStdString(history.partType()));
    const QString text = !read           ? sentenceText(read.error(), look.units())
                         : known.empty() ? Revisions::tr("Nothing was changed yet.")
                                         : Revisions::tr("The first one holds. Touch an older one to compare it.");
    Sheet* sheet = place == Place::Over ? context.sheets.openOver(title, text) : context.sheets.open(title, text);
    sheet->setWide();
    QTableWidget* table = makeTable(look, known, sheet);
    auto* difference = makeLabel(TextRole::Body, sheet, true);
    difference->setObjectName(QStringLiteral("recipeDifference"));
    auto* reason = new QLineEdit(sheet);
    reason->setObjectName(QStringLiteral("recipeReason"));
    reason->setPlaceholderText(Revisions::tr("Reason for the change"));
    reason->setMinimumHeight(look.metrics().touch());
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("recipeMessage"));
    auto* restore = new ActionButton(look);
    restore->setObjectName(QStringLiteral("recipeRestore"));
    restore->setText(Revisions::tr("Roll back to it"));
    const auto chosen = [table, known]() -> const RecipeRevisionView* {
        const int row = table->currentRow();
        return row > 0 && row < static_cast<int>(known.size()) ? &known[static_cast<std::size_t>(row)] : nullptr;
    };
    restore->setPredicate([chosen, reason] {
        return chosen() == nullptr                  ? Revisions::tr("touch an older revision")
               : reason->text().trimmed().isEmpty() ? Revisions::tr("give a reason")
                                                    : QString();
    });
    allowOnly(restore, context.session, deed);
    QObject::connect(reason, &QLineEdit::textChanged, restore, [restore] { restore->reconsider(); });
    QObject::connect(table, &QTableWidget::itemSelectionChanged, restore,
                     [chosen, known, difference, restore, &history, words = Words{specOf, wordOf}, &look] {
                         restore->reconsider();
                         const RecipeRevisionView* one = chosen();
                         if (one == nullptr) {
                             return difference->clear();
                         }
                         const auto changes = history.compare(known.front().revision, one->revision);
                         difference->setText(changes ? differenceText(*changes, words, look.units())
                                                     : sentenceText(changes.error(), look.units()));
                     });
    sheet->body()->addWidget(table, 1);
    sheet->body()->addWidget(difference);
    sheet->body()->addWidget(reason);
    sheet->body()->addWidget(message);
    sheet->addButton(Revisions::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    // It may come when another sheet is open: then only the bottom line says so.
    const auto answered = [context, open = QPointer<Sheet>(sheet), message = QPointer<QLabel>(message), &history, deed,
                           specOf, wordOf](const Result<void>& done) {
        const QString words =
            done ? Revisions::tr("The revision is back.") : sentenceText(done.error(), context.look.units());
        if (!context.sheets.isOpen(open)) {
            context.notify(words);
        } else if (!done) {
            message->setText(words);
        } else {
            context.notify(words);
            if (open->taken()) showRevisions(context, history, deed, specOf, wordOf, Place::Alone);
        }
    };
    sheet->addButton(
        restore,
        [context, &history, deed, chosen, reason, answered] {
            const RecipeRevisionView* one = chosen();
            if (one == nullptr) {
                return;
            }
            context.withPermission(
                deed, [context, &history, revision = one->revision, why = reason->text().trimmed().toStdString(),
                       answered, open = QPointer<Sheet>(context.sheets.current())] {
                    if (open) open->sent();
                    history.restore(revision, context.session.author(), why, answered);
                });
        },
        false);
}

}  // namespace

void openRecipeSheet(const PageContext& context, RecipeHistory& history, Deed deed, const RecipeSpecOf& specOf,
                     const RecipeWordOf& wordOf) {
    showRevisions(context, history, deed, specOf, wordOf, Place::Over);
}

void offerRecipeSheet(const PageContext& context, RecipeHistory* history, Deed deed, const RecipeSpecOf& specOf,
                      const RecipeWordOf& wordOf) {
    Sheet* sheet = context.sheets.current();
    if (history == nullptr || sheet == nullptr) {
        return;
    }
    QPushButton* button = sheet->addButton(
        Revisions::tr("Earlier revisions"),
        [context, history, deed, specOf, wordOf] { openRecipeSheet(context, *history, deed, specOf, wordOf); }, false);
    button->setObjectName(QStringLiteral("recipeHistory"));
}

}  // namespace kerf::ui

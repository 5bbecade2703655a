// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/lot_sheet.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QTableWidget>
#include <memory>

#include "ui/dialogs/list_table.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/services/lot_service.h"
#include "ui/shell/page.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct Lots {
    Q_DECLARE_TR_FUNCTIONS(Lots)
};

constexpr std::uint32_t kLargestLot = 100'000;

QString nowText(const LotService& lots) {
    const auto now = lots.current();
    const QString type = QString::fromStdString(lots.partType());
    return now ? Lots::tr("The next parts are of lot %1 of %2.").arg(QString::fromStdString(now->name), type)
               : Lots::tr("The next parts of %1 are of no lot.").arg(type);
}

QString whenText(const LotView& lot) {
    const auto text = [](std::int64_t utc_ms) {
        return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    };
    const QString opened = text(lot.openedUtc_ms) + u' ' + QString::fromStdString(lot.openedBy);
    return lot.closedUtc_ms
               ? opened + QStringLiteral(" – ") + text(*lot.closedUtc_ms) + u' ' + QString::fromStdString(lot.closedBy)
               : opened;
}

QTableWidget* makeTable(Look& look, const LotService& lots, const std::vector<LotView>& known, QWidget* parent) {
    const auto now = lots.current();
    QList<QStringList> rows;
    int open = -1;
    for (const LotView& lot : known) {
        if (now && lot.id == now->id) {
            open = static_cast<int>(rows.size());
        }
        rows << QStringList{QString::fromStdString(lot.name),
                            QString::fromStdString(lot.partType),
                            QString::number(lot.recipeRevision),
                            lot.size > 0 ? QString::number(lot.size) : QStringLiteral("–"),
                            QString::fromStdString(lot.tool),
                            QString::fromStdString(lot.gauge),
                            whenText(lot)};
    }
    return makeListTable(look, "lotTable",
                         {Lots::tr("Lot"), Lots::tr("Part type"), Lots::tr("Rev."), Lots::tr("Parts"),
                          Lots::tr("Tool or insert"), Lots::tr("Gauge"), Lots::tr("When, by")},
                         rows, {4, 5}, parent, open);
}

QLineEdit* makeField(const PageContext& context, const char* name, const QString& words, Sheet* sheet) {
    auto* field = new QLineEdit(sheet);
    field->setObjectName(QLatin1String(name));
    field->setPlaceholderText(words);
    field->setMinimumHeight(context.look.metrics().touch());
    return field;
}

/// Empty or a number of parts.
bool usableSize(const QString& text, std::uint32_t& size) {
    bool isNumber = text.isEmpty();
    size = text.isEmpty() ? 0 : text.toUInt(&isNumber);
    return isNumber && size <= kLargestLot;
}

/// Says which lot the next parts are of, whatever sheet or page is shown.
class LotLine final : public QLabel {
 public:
    explicit LotLine(LotService& lots) : m_lots(lots) {
        setObjectName(QStringLiteral("lotLine"));
        setTextRole(this, TextRole::Small);
        m_changes = m_lots.onChanged([this] { show(); });
        show();
    }

 protected:
    void changeEvent(QEvent* event) override {
        QLabel::changeEvent(event);
        if (event->type() == QEvent::LanguageChange) {
            show();
        }
    }

 private:
    void show() {
        const auto lot = m_lots.current();
        setText(lot ? Lots::tr("lot %1").arg(QString::fromStdString(lot->name)) : QString());
        setVisible(lot.has_value());
    }

    LotService& m_lots;
    std::unique_ptr<Subscription> m_changes;
};

}  // namespace

void openLotSheet(const PageContext& context, LotService& lots) {
    const auto read = lots.lots();
    const std::vector<LotView> known = read ? *read : std::vector<LotView>{};
    Sheet* sheet = context.sheets.openOver(Lots::tr("Lots of %1").arg(QString::fromStdString(lots.partType())),
                                           read ? nowText(lots) : sentenceText(read.error(), context.look.units()));
    sheet->setWide();
    QTableWidget* table = makeTable(context.look, lots, known, sheet);
    QLineEdit* name = makeField(context, "lotName", Lots::tr("Name of a new lot"), sheet);
    QLineEdit* size = makeField(context, "lotSize", Lots::tr("Parts, if known"), sheet);
    QLineEdit* tool = makeField(context, "lotTool", Lots::tr("Tool or insert"), sheet);
    QLineEdit* gauge = makeField(context, "lotGauge", Lots::tr("Gauge"), sheet);
    QLineEdit* reason = makeField(context, "lotReason", Lots::tr("Reason to close the lot"), sheet);
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("lotMessage"));
    sheet->body()->addWidget(table, 1);
    auto* fields = new QHBoxLayout;
    for (QLineEdit* field : {name, size, tool, gauge}) {
        fields->addWidget(field);
    }
    sheet->body()->addLayout(fields);
    sheet->body()->addWidget(reason);
    sheet->body()->addWidget(message);
    sheet->addButton(Lots::tr("Close the sheet"), {})->setObjectName(QStringLiteral("sheetSafe"));

    // It may come when another sheet is open: then only the bottom line says so.
    const auto answered = [context, open = QPointer<Sheet>(sheet), message = QPointer<QLabel>(message),
                           &lots](const Result<void>& done) {
        const QString words = done ? nowText(lots) : sentenceText(done.error(), context.look.units());
        if (!context.sheets.isOpen(open)) {
            context.notify(words);
        } else if (!done) {
            message->setText(words);
        } else {
            context.notify(words);
            open->close();
            openLotSheet(context, lots);
        }
    };
    const auto add = [&](const char* object, const QString& words, Deed deed, std::function<QString()> whyNot,
                         std::function<void(const std::string& author)> run) {
        auto* button = new ActionButton(context.look);
        button->setObjectName(QLatin1String(object));
        button->setText(words);
        button->setPredicate(std::move(whyNot));
        allowOnly(button, context.session, deed);
        for (QLineEdit* field : {name, size, reason}) {
            QObject::connect(field, &QLineEdit::textChanged, button, [button] { button->reconsider(); });
        }
        QObject::connect(table, &QTableWidget::itemSelectionChanged, button, [button] { button->reconsider(); });
        sheet->addButton(
            button,
            [context, deed, run = std::move(run)] {
                context.withPermission(deed, [context, run] { run(context.session.author()); });
            },
            false);
    };
    const auto chosen = [table, known]() -> const LotView* {
        const int row = table->currentRow();
        return row >= 0 && row < static_cast<int>(known.size()) ? &known[static_cast<std::size_t>(row)] : nullptr;
    };
    const auto noLot = [&lots] { return lots.current() ? QString() : Lots::tr("no lot is open"); };
    add(
        "lotClose", Lots::tr("Close the lot"), Deed::BoringLotEnd,
        [noLot, reason] {
            const QString none = noLot();
            return !none.isEmpty() ? none : reason->text().trimmed().isEmpty() ? Lots::tr("give a reason") : QString();
        },
        [&lots, reason = QPointer<QLineEdit>(reason), answered](const std::string& author) {
            lots.close(author, reason ? reason->text().trimmed().toStdString() : std::string(), answered);
        });
    add("lotLeave", Lots::tr("Parts of no lot"), Deed::BoringLot, noLot,
        [&lots, answered](const std::string& author) { lots.leave(author, answered); });
    add(
        "lotChoose", Lots::tr("Go on with it"), Deed::BoringLot,
        [chosen] {
            const LotView* lot = chosen();
            return lot == nullptr ? Lots::tr("touch a lot") : lot->closedUtc_ms ? Lots::tr("it is closed") : QString();
        },
        [&lots, chosen, open = QPointer<Sheet>(sheet), answered](const std::string& author) {
            if (const LotView* lot = open ? chosen() : nullptr) {
                lots.choose(lot->id, author, answered);
            }
        });
    add(
        "lotOpen", Lots::tr("Open the lot"), Deed::BoringLot,
        [name, size] {
            std::uint32_t parts = 0;
            return name->text().trimmed().isEmpty()             ? Lots::tr("type a name")
                   : !usableSize(size->text().trimmed(), parts) ? Lots::tr("0 to 100000 parts")
                                                                : QString();
        },
        [&lots, name, size, tool, gauge, open = QPointer<Sheet>(sheet), answered](const std::string& author) {
            NewLot lot;
            if (!open || !usableSize(size->text().trimmed(), lot.size)) {
                return;
            }
            lot.name = name->text().trimmed().toStdString();
            lot.tool = tool->text().trimmed().toStdString();
            lot.gauge = gauge->text().trimmed().toStdString();
            lots.open(lot, author, answered);
        });
}

void offerLotSheet(const PageContext& context, LotService* lots) {
    Sheet* sheet = context.sheets.current();
    if (lots == nullptr || sheet == nullptr) {
        return;
    }
    QPushButton* button = sheet->addButton(
        Lots::tr("Lots"), [context, lots] { openLotSheet(context, *lots); }, false);
    button->setObjectName(QStringLiteral("processLots"));
}

void addLotLine(const PageContext&, LotService* lots, QBoxLayout* header) {
    if (lots != nullptr) {
        header->addWidget(new LotLine(*lots));
    }
}

}  // namespace kerf::ui

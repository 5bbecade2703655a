// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/lot_form.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScroller>
#include <QTableWidget>
#include <algorithm>

#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/pages/boring/recipe_form.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kLotsShown = 100;

const ParamSpec& sizeSpec() {
    static const ParamSpec kSize{
        "boring.lot_size",      KERF_TEXT("Parts in the lot"), "", 1.0, BoringLots::kMostParts, 30.0, 0,
        KERF_TEXT("work order")};
    return kSize;
}

/// 12 → 13, A → A-2.
QString nextName(const std::vector<BoringLotView>& lots, PartTypeId partType) {
    qlonglong highest = 0;
    QString newest;
    QStringList taken;
    for (const BoringLotView& lot : lots) {
        if (lot.partType != partType) {
            continue;
        }
        const QString name = QString::fromStdString(lot.name);
        taken << name;
        newest = newest.isEmpty() ? name : newest;
        bool number = false;
        const qlonglong value = name.toLongLong(&number);
        highest = number ? qMax(highest, value) : highest;
    }
    bool number = false;
    (void)newest.toLongLong(&number);
    if (newest.isEmpty() || number) {
        return QString::number(highest + 1);
    }
    for (int i = 2;; ++i) {
        const QString name = QStringLiteral("%1-%2").arg(newest).arg(i);
        if (!taken.contains(name)) {
            return name;
        }
    }
}

bool ofOtherMachine(const BoringMemoryLotView& lot) {
    return !lot.console.empty();
}

void setRow(QTableWidget& table, int row, const QStringList& cells) {
    for (int c = 0; c < cells.size(); ++c) {
        table.setItem(row, c, new QTableWidgetItem(cells[c]));
    }
}

}  // namespace

LotForm* LotForm::open(const PageContext& context) {
    Sheet* sheet = context.sheets.open({});
    sheet->setWide();
    auto* form = new LotForm(context, sheet);
    sheet->body()->addWidget(form, 1);
    form->show();
    return form;
}

LotForm::LotForm(const PageContext& context, Sheet* sheet)
    : FaceWidget(context.look, sheet),
      m_context(context),
      m_lots(*context.services.boringLots),
      m_sheet(sheet),
      m_now(makeLabel(TextRole::Body, this, true)),
      m_partTypeLabel(makeLabel(TextRole::Small, this)),
      m_partType(new QComboBox(this)),
      m_nameLabel(makeLabel(TextRole::Small, this)),
      m_name(new QLineEdit(this)),
      m_grade(new QLineEdit(this)),
      m_material(new QLineEdit(this)),
      m_size(new ValueField(context.look, sizeSpec(), this)),
      m_estimator(new QButtonGroup(this)),
      m_kalman(new QPushButton(this)),
      m_perturbation(new QPushButton(this)),
      m_keypad(new Keypad(context.look, Keypad::Shape::Wide, this)),
      m_table(new QTableWidget(this)),
      m_reason(new QLineEdit(this)),
      m_leaveOut(new ActionButton(context.look, this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_cancel(new QPushButton),
      m_close(new ActionButton(context.look)),
      m_recipe(new QPushButton),
      m_newPartType(new ActionButton(context.look)),
      m_choose(new ActionButton(context.look)),
      m_open(new ActionButton(context.look)),
      m_fields(new QGridLayout),
      m_columns(new QHBoxLayout) {
    setObjectName(QStringLiteral("lotForm"));
    m_now->setObjectName(QStringLiteral("lotNow"));
    m_partType->setObjectName(QStringLiteral("lotPartType"));
    m_name->setObjectName(QStringLiteral("lotName"));
    m_size->setObjectName(QStringLiteral("lotSize"));
    m_grade->setObjectName(QStringLiteral("lotGrade"));
    m_material->setObjectName(QStringLiteral("lotMaterial"));
    m_leaveOut->setObjectName(QStringLiteral("lotLeaveOut"));
    m_kalman->setObjectName(QStringLiteral("lotKalman"));
    m_perturbation->setObjectName(QStringLiteral("lotPerturbation"));
    m_keypad->setObjectName(QStringLiteral("lotKeypad"));
    m_table->setObjectName(QStringLiteral("lotTable"));
    m_reason->setObjectName(QStringLiteral("lotReason"));
    m_message->setObjectName(QStringLiteral("lotMessage"));
    m_cancel->setObjectName(QStringLiteral("lotCancel"));
    m_close->setObjectName(QStringLiteral("lotClose"));
    m_recipe->setObjectName(QStringLiteral("lotRecipe"));
    m_newPartType->setObjectName(QStringLiteral("lotNewPartType"));
    m_choose->setObjectName(QStringLiteral("lotChoose"));
    m_open->setObjectName(QStringLiteral("lotOpen"));
    for (QPushButton* button : {m_kalman, m_perturbation}) {
        button->setCheckable(true);
        m_estimator->addButton(button);
    }
    m_open->setPrimary(true);
    m_partType->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    QScroller::grabGesture(m_table->viewport(), QScroller::TouchGesture);

    m_fields->addWidget(m_partTypeLabel, 0, 0, 1, 4);
    m_fields->addWidget(m_partType, 1, 0, 1, 4);
    m_fields->addWidget(m_nameLabel, 2, 0, 1, 2);
    m_fields->addWidget(m_name, 3, 0, 1, 2);
    m_fields->addWidget(m_size, 2, 2, 2, 2);
    int place = 0;
    for (QWidget* one : std::initializer_list<QWidget*>{m_kalman, m_perturbation, m_grade, m_material}) {
        m_fields->setColumnStretch(place, 1);
        m_fields->addWidget(one, 4, place++);  // in one row: the table below needs the room
    }
    m_columns->addLayout(m_fields, 1);
    m_columns->addWidget(m_keypad);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_now);
    column->addLayout(m_columns);
    column->addWidget(m_table, 1);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    column->addWidget(m_message);
    auto* reasonRow = new QHBoxLayout;
    reasonRow->addWidget(m_reason, 1);
    reasonRow->addWidget(m_leaveOut);
    column->addLayout(reasonRow);
    connect(m_leaveOut, &QPushButton::clicked, this, &LotForm::leaveOut);

    sheet->addButton(m_cancel, {});
    sheet->addButton(
        m_close, [this] { closeLot(); }, false);
    sheet->addButton(
        m_recipe, [this] { openRecipe(partType()); }, false);
    sheet->addButton(
        m_newPartType, [this] { openRecipe(std::nullopt); }, false);
    sheet->addButton(
        m_choose, [this] { chooseLot(); }, false);
    sheet->addButton(
        m_open, [this] { openLot(); }, false);
    m_close->setPredicate([this] { return whyNoClose(); });
    m_leaveOut->setPredicate([this] { return whyNoLeaveOut(); });
    m_newPartType->setPredicate([this] { return m_context.session.whyNot(Role::Engineer); });
    m_choose->setPredicate([this] { return whyNoChoice(); });
    m_open->setPredicate([this] { return whyNoOpen(); });
    connect(m_partType, &QComboBox::currentIndexChanged, this, [this] {
        propose();
        reconsider();
    });
    connect(m_name, &QLineEdit::textChanged, this, [this] { reconsider(); });
    connect(m_reason, &QLineEdit::textChanged, this, [this] { reconsider(); });
    connect(m_size, &ValueField::edited, this, [this] { reconsider(); });
    connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] { reconsider(); });
    connect(&m_context.session, &OperatorSession::changed, this, [this] { reconsider(); });
    connect(&m_context.client, &EngineClient::statusChanged, this, [this] { reconsider(); });
    read();
    refresh();
}

void LotForm::read() {
    const auto types = m_lots.partTypes();
    const auto lots = m_lots.lots();
    m_trouble = !types  ? sentenceText(types.error(), look().units())
                : !lots ? sentenceText(lots.error(), look().units())
                        : QString();
    if (!types || !lots) {
        return;
    }
    m_types = *types;
    m_known = *lots;
    const auto memory = m_lots.memory();
    m_memory = memory ? *memory : std::vector<BoringMemoryLotView>{};
    const QSignalBlocker quiet(m_partType);
    m_partType->clear();
    PartTypeId current = 0;
    for (const BoringLotView& lot : m_known) {
        current = lot.current ? lot.partType : current;
    }
    for (std::size_t i = 0; i < m_types.size(); ++i) {
        m_partType->addItem(QString::fromStdString(m_types[i].name));
        if (m_types[i].id == current) {
            m_partType->setCurrentIndex(static_cast<int>(i));
        }
    }
    propose();
}

void LotForm::choosePartType(PartTypeId type) {
    for (std::size_t i = 0; i < m_types.size(); ++i) {
        if (m_types[i].id == type) {
            m_partType->setCurrentIndex(static_cast<int>(i));
        }
    }
}

PartTypeId LotForm::partType() const {
    const int index = m_partType->currentIndex();
    return index >= 0 && index < static_cast<int>(m_types.size()) ? m_types[static_cast<std::size_t>(index)].id : 0;
}

// The next lot is like the one before it.
void LotForm::propose() {
    m_name->setText(nextName(m_known, partType()));
    double size = sizeSpec().fallback;
    // The law of the lot that is open, unless this part type has been bored by another one.
    std::string estimator = m_context.services.boringService->view().estimator;
    for (const BoringLotView& lot : m_known) {
        if (lot.partType == partType()) {
            size = lot.size > 0 ? lot.size : size;
            estimator = lot.estimator;
            m_grade->setText(QString::fromStdString(lot.insertGrade));
            m_material->setText(QString::fromStdString(lot.material));
            break;  // newest first
        }
    }
    m_size->setValue(size);
    (estimator == "perturbation" ? m_perturbation : m_kalman)->setChecked(true);
}

void LotForm::refresh() {
    if (m_sheet) {
        m_sheet->setTitle(tr("Lots"));
    }
    m_partTypeLabel->setText(tr("Next lot of part type"));
    m_nameLabel->setText(tr("Lot"));
    m_kalman->setText(tr("Estimator kalman"));
    m_perturbation->setText(tr("perturbation (paper)"));
    m_reason->setPlaceholderText(tr("Reason, when the lot is closed before it is full"));
    m_grade->setPlaceholderText(tr("Insert grade"));
    m_material->setPlaceholderText(tr("Material"));
    m_leaveOut->setText(remembered() != nullptr && remembered()->leftOut ? tr("Take in again") : tr("Leave out"));
    m_cancel->setText(tr("Back"));
    m_close->setText(tr("Close this lot"));
    m_recipe->setText(tr("Recipe"));
    m_newPartType->setText(tr("New part type"));
    m_choose->setText(tr("Go on with it"));
    m_open->setText(tr("Open the lot"));
    const int gap = look().metrics().touchGap();
    m_fields->setHorizontalSpacing(gap);
    m_fields->setVerticalSpacing(look().space(Space::Small));
    m_columns->setSpacing(2 * gap);
    layout()->setSpacing(look().space(Space::Medium));
    m_table->setMinimumHeight(look().metrics().touch());
    m_table->verticalHeader()->setDefaultSectionSize(look().metrics().touch());
    m_table->verticalHeader()->setMinimumSectionSize(look().metrics().touch());
    fillTable();
    reconsider();
    FaceWidget::refresh();
}

void LotForm::fillTable() {
    const BoringServiceView& view = m_context.services.boringService->view();
    const std::uint32_t cut = view.parts.empty() ? 0 : view.parts.back().number;
    QString state = view.lotClosed ? tr("It is closed.") : lotFull(view) ? tr("It is full.") : tr("It goes on.");
    m_now->setText(tr("Now: %1, lot %2, %3 of %4 parts cut, recipe revision %5. %6", "part type, lot, counts, state")
                       .arg(QString::fromStdString(view.partType), QString::fromStdString(view.lot))
                       .arg(cut)
                       .arg(view.lotSize)
                       .arg(view.recipeRevision)
                       .arg(state));
    const int row = m_table->currentRow();
    m_table->clear();
    m_table->setColumnCount(6);
    m_table->setHorizontalHeaderLabels({tr("Lot"), tr("Part type"), tr("Parts"), tr("Opened"), tr("State"),
                                        tr("Counts", "share of a lot in what this one began from")});
    m_table->setRowCount(ownRows() + static_cast<int>(std::ranges::count_if(m_memory, ofOtherMachine)));
    for (int i = 0; i < ownRows(); ++i) {
        const BoringLotView& lot = m_known[static_cast<std::size_t>(i)];
        const BoringMemoryLotView* memory = rememberedIn(i);
        const QStringList cells{
            QString::fromStdString(lot.name),
            QString::fromStdString(lot.partTypeName),
            QString::number(lot.size),
            QDateTime::fromMSecsSinceEpoch(lot.openedUtc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm")),
            lot.current            ? tr("current")
            : lot.partsWaiting > 0 ? tr("%n bores wait for diameters", nullptr, static_cast<int>(lot.partsWaiting))
            : lot.closed           ? tr("closed")
                                   : tr("open"),
            counts(memory)};
        setRow(*m_table, i, cells);
    }
    for (int i = ownRows(); i < m_table->rowCount(); ++i) {
        const BoringMemoryLotView& lot = *rememberedIn(i);
        setRow(*m_table, i,
               {QString::fromStdString(lot.name), QString::fromStdString(lot.partType), QString(), QString(),
                tr("on machine %1").arg(QString::fromStdString(lot.machine)), counts(&lot)});
    }
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    if (row >= 0) {
        m_table->selectRow(row);
    }
}

QString LotForm::counts(const BoringMemoryLotView* memory) {
    if (memory == nullptr) {
        return {};
    }
    return memory->leftOut ? tr("left out") : QStringLiteral("%1 %").arg(qRound(100.0 * memory->share));
}

int LotForm::ownRows() const {
    return qMin(kLotsShown, static_cast<int>(m_known.size()));
}

// Below the lots of this machine stand those of other machines that the current lot begins from.
const BoringMemoryLotView* LotForm::rememberedIn(int row) const {
    int place = row - ownRows();
    for (const BoringMemoryLotView& memory : m_memory) {
        const bool here = ofOtherMachine(memory)
                              ? place-- == 0
                              : row >= 0 && row < ownRows() && memory.lot == m_known[static_cast<std::size_t>(row)].id;
        if (here) {
            return &memory;
        }
    }
    return nullptr;
}

const BoringLotView* LotForm::chosen() const {
    const int row = m_table->currentRow();
    return row >= 0 && row < ownRows() ? &m_known[static_cast<std::size_t>(row)] : nullptr;
}

void LotForm::reconsider() {
    for (ActionButton* button : {m_close, m_newPartType, m_choose, m_open, m_leaveOut}) {
        button->reconsider();
    }
    m_leaveOut->setText(remembered() != nullptr && remembered()->leftOut ? tr("Take in again") : tr("Leave out"));
    const BoringServiceView& view = m_context.services.boringService->view();
    const BorePartView* waiting = view.awaiting ? findPart(view, *view.awaiting) : nullptr;
    const Sentence shop = m_lots.shopAnswer();
    const QString text = !m_trouble.isEmpty() ? m_trouble
                         : !shop.empty()      ? sentenceText(shop, look().units())
                         : waiting != nullptr
                             ? tr("Part %1 of this lot waits for its diameter. It is kept when another lot is opened; "
                                  "go on with this lot to enter it.")
                                   .arg(waiting->number)
                             : tr("The newest recipe of the part type holds for a new lot, and stays with it.");
    if (m_message->text() != text) {
        m_message->setText(text);
    }
}

QString LotForm::whyNoChange() const {
    if (m_pending) {
        return tr("being stored");
    }
    if (const QString why = m_context.session.whyNot(Role::Setter); !why.isEmpty()) {
        return why;
    }
    const auto busy = m_lots.whyNoOther();
    return busy ? sentenceText(*busy, look().units()) : QString();
}

QString LotForm::whyNoOpen() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    if (m_name->text().trimmed().isEmpty()) {
        return tr("a lot needs a name");
    }
    return m_size->value() ? QString() : m_size->whyInvalid();
}

QString LotForm::whyNoChoice() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    if (chosen() == nullptr) {
        return tr("touch a lot in the list");
    }
    return chosen()->current ? tr("this lot is current") : QString();
}

QString LotForm::whyNoClose() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    const BoringServiceView& view = m_context.services.boringService->view();
    if (view.lotClosed) {
        return tr("it is closed");
    }
    return !lotFull(view) && m_reason->text().trimmed().isEmpty() ? tr("give a reason: it is not full") : QString();
}

const BoringMemoryLotView* LotForm::remembered() const {
    return rememberedIn(m_table->currentRow());
}

QString LotForm::whyNoLeaveOut() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    if (remembered() == nullptr) {
        return tr("touch a lot that the current one begins from");
    }
    return m_reason->text().trimmed().isEmpty() ? tr("give a reason") : QString();
}

void LotForm::leaveOut() {
    const BoringMemoryLotView* lot = remembered();
    if (lot == nullptr) {
        return;
    }
    const QString done = lot->leftOut ? tr("Lot %1 counts again.") : tr("Lot %1 is left out of what lots begin from.");
    change(done.arg(QString::fromStdString(lot->name)),
           [key = BoringMemoryKey{lot->lot, lot->console}, out = !lot->leftOut,
            reason = m_reason->text().trimmed().toStdString()](const PageContext& context, BoringLots::Done answer) {
               context.services.boringLots->leaveOut(key, out, context.session.author(), reason, std::move(answer));
           });
}

// The name is asked for first: what is typed into the recipe must not be lost to that question.
void LotForm::openRecipe(std::optional<PartTypeId> type) {
    m_context.withOperator([context = m_context, type] { RecipeForm::open(context, type); });
}

void LotForm::openLot() {
    BoringLotOrder order;
    order.partType = partType();
    order.name = m_name->text().trimmed().toStdString();
    order.size = static_cast<std::uint32_t>(m_size->value().value_or(0.0));
    order.insertGrade = m_grade->text().trimmed().toStdString();
    order.material = m_material->text().trimmed().toStdString();
    order.estimator = m_perturbation->isChecked() ? "perturbation" : "kalman";
    QString done =
        withParticles(tr("Lot %1 is open. Its first part is started by hand.").arg(m_name->text().trimmed()));
    const BoringServiceView& view = m_context.services.boringService->view();
    const BorePartView* waiting = view.awaiting ? findPart(view, *view.awaiting) : nullptr;
    if (waiting != nullptr) {
        done = tr("Lot %1 is open. Part %2 of lot %3 still waits for its diameter: Lots, Go on with it.")
                   .arg(m_name->text().trimmed())
                   .arg(waiting->number)
                   .arg(QString::fromStdString(view.lot));
    }
    change(done, [order](const PageContext& context, BoringLots::Done answer) mutable {
        order.author = context.session.author();
        context.services.boringLots->open(order, std::move(answer));
    });
}

void LotForm::chooseLot() {
    const BoringLotView* lot = chosen();
    if (lot == nullptr) {
        return;
    }
    const QString done = withParticles(tr("Lot %1 goes on.").arg(QString::fromStdString(lot->name)));
    change(done, [id = lot->id](const PageContext& context, BoringLots::Done answer) {
        context.services.boringLots->choose(id, context.session.author(), std::move(answer));
    });
}

void LotForm::closeLot() {
    const QString words = m_reason->text().trimmed();
    const std::string reason = words.isEmpty() ? "full" : words.toStdString();
    change(tr("The lot is closed."), [reason](const PageContext& context, BoringLots::Done answer) {
        context.services.boringLots->close(context.session.author(), reason, std::move(answer));
    });
}

// The question who is there takes the place of this sheet; the change goes on without it.
void LotForm::change(const QString& done, std::function<void(const PageContext&, BoringLots::Done)> act) {
    const QPointer<LotForm> self(this);
    m_context.withRole(Role::Setter, [self, context = m_context, done, act = std::move(act)] {
        if (LotForm* form = self.data()) {
            form->m_pending = true;
            form->reconsider();
            if (form->m_sheet) form->m_sheet->sent();
        }
        act(context, [self, context, done](const Result<void>& result) {
            if (LotForm* form = self.data()) {
                form->answered(result, done);
            } else {
                context.notify(result ? done : sentenceText(result.error(), context.look.units()));
            }
        });
    });
}

void LotForm::answered(const Result<void>& result, const QString& done) {
    m_pending = false;
    if (result) {
        m_context.notify(done);
        if (m_sheet && !m_sheet->taken()) {
            reconsider();
        }
        return;
    }
    m_trouble = sentenceText(result.error(), look().units());
    reconsider();
}

}  // namespace kerf::ui

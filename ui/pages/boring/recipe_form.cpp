// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/recipe_form.h"

#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollArea>
#include <QScroller>
#include <QTableWidget>
#include <algorithm>

#include "ui/link/reason_text.h"
#include "ui/link/texts.h"
#include "ui/pages/boring/lot_form.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kColumns = 2;

const ParamSpec& depthSpec() {
    static const ParamSpec kDepth{"boring.depth_mm",
                                  KERF_TEXT("Overhang where the bore is measured"),
                                  "mm",
                                  1.0,
                                  5000.0,
                                  40.0,
                                  1,
                                  KERF_TEXT("drawing of the part")};
    return kDepth;
}

/// The first is the top, the last the bottom, one between them the middle; more are counted.
std::string depthNameOf(std::size_t index, std::size_t count) {
    if (index == 0) {
        return "top";
    }
    if (index + 1 == count) {
        return "bottom";
    }
    return count == 3 ? "middle" : std::to_string(index + 1);
}

}  // namespace

RecipeForm* RecipeForm::open(const PageContext& context, std::optional<PartTypeId> partType) {
    Sheet* sheet = context.sheets.open({});
    sheet->setWide();
    auto* form = new RecipeForm(context, partType, sheet);
    sheet->body()->addWidget(form, 1);
    form->show();
    return form;
}

RecipeForm::RecipeForm(const PageContext& context, std::optional<PartTypeId> partType, Sheet* sheet)
    : FaceWidget(context.look, sheet),
      m_context(context),
      m_lots(*context.services.boringLots),
      m_partType(partType),
      m_sheet(sheet),
      m_name(new QLineEdit(this)),
      m_area(new QScrollArea(this)),
      m_grid(new QGridLayout),
      m_depthGrid(new QGridLayout),
      m_depthTitle(makeLabel(TextRole::Body, this, true)),
      m_add(new ActionButton(context.look, this)),
      m_revisions(new QTableWidget(this)),
      m_difference(makeLabel(TextRole::Body, this, true)),
      m_reason(new QLineEdit(this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_keypad(new Keypad(context.look, Keypad::Shape::Wide, this)),
      m_cancel(new QPushButton),
      m_restore(new ActionButton(context.look)),
      m_save(new ActionButton(context.look)),
      m_columns(new QHBoxLayout(this)),
      m_side(new QVBoxLayout) {
    setObjectName(QStringLiteral("recipeForm"));
    build(sheet);
    read();
    showForm(m_known.empty() ? m_lots.standardRecipe() : m_known.front().form);
    refresh();
}

void RecipeForm::build(Sheet* sheet) {
    m_name->setObjectName(QStringLiteral("recipeName"));
    m_add->setObjectName(QStringLiteral("recipeDepthAdd"));
    m_revisions->setObjectName(QStringLiteral("recipeRevisions"));
    m_difference->setObjectName(QStringLiteral("recipeDifference"));
    m_reason->setObjectName(QStringLiteral("recipeReason"));
    m_message->setObjectName(QStringLiteral("recipeMessage"));
    m_keypad->setObjectName(QStringLiteral("recipeKeypad"));
    m_cancel->setObjectName(QStringLiteral("recipeCancel"));
    m_restore->setObjectName(QStringLiteral("recipeRestore"));
    m_save->setObjectName(QStringLiteral("recipeSave"));
    m_area->setObjectName(QStringLiteral("recipeArea"));
    m_save->setPrimary(true);
    auto* list = new QWidget;
    list->setProperty("role", QStringLiteral("scrolled"));
    auto* column = new QVBoxLayout(list);
    column->addLayout(m_grid);
    column->addWidget(m_depthTitle);
    column->addLayout(m_depthGrid);
    column->addWidget(m_add);
    column->addStretch(1);
    int cell = 0;
    for (const ParamSpec& spec : m_lots.recipeSpecs()) {
        auto* field = new ValueField(look(), spec, list);
        field->setObjectName(QStringLiteral("recipeField%1").arg(cell));
        auto* hint = makeLabel(TextRole::Small, list, true);
        const int row = 2 * (cell / kColumns);
        m_grid->addWidget(field, row, cell % kColumns);
        m_grid->addWidget(hint, row + 1, cell % kColumns);
        m_grid->setColumnStretch(cell % kColumns, 1);
        connect(field, &ValueField::edited, this, [this] { showDifference(); });
        m_fields.push_back(field);
        m_hints.push_back(hint);
        ++cell;
    }
    m_area->setWidgetResizable(true);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setWidget(list);
    QScroller::grabGesture(m_area->viewport(), QScroller::TouchGesture);
    m_revisions->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_revisions->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_revisions->setSelectionMode(QAbstractItemView::SingleSelection);
    m_revisions->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_revisions->verticalHeader()->hide();
    m_revisions->setShowGrid(false);
    QScroller::grabGesture(m_revisions->viewport(), QScroller::TouchGesture);

    m_name->setVisible(!m_partType);
    m_revisions->setVisible(m_partType.has_value());
    m_reason->setVisible(m_partType.has_value());
    m_restore->setVisible(m_partType.has_value());
    m_side->addWidget(m_name);
    m_side->addWidget(m_revisions, 1);
    m_side->addWidget(m_difference);
    m_side->addStretch(m_partType ? 0 : 1);
    m_side->addWidget(m_reason);
    m_side->addWidget(m_message);
    m_side->addWidget(m_keypad);
    m_columns->setContentsMargins(0, 0, 0, 0);
    m_columns->addWidget(m_area, 1);
    m_columns->addLayout(m_side);

    sheet->addButton(
        m_cancel, [this] { LotForm::open(m_context); }, false);
    if (m_partType) {
        sheet->addButton(
            m_restore, [this] { restore(); }, false);
    } else {
        m_restore->setParent(this);  // on no sheet, and it must not outlive the form that its predicate asks
        m_restore->hide();
    }
    sheet->addButton(
        m_save, [this] { save(); }, false);
    m_restore->setPredicate([this] { return whyNoRestore(); });
    m_save->setPredicate([this] { return whyNoSave(); });
    m_add->setPredicate(
        [this] { return m_depths.size() < kMaxBoreDepths ? QString() : tr("at most %1 depths").arg(kMaxBoreDepths); });
    connect(m_add, &QPushButton::clicked, this, [this] {
        addDepth(depthSpec().fallback);
        layDepths();
        m_depths.back().field->clear();
        showDifference();
    });
    connect(m_name, &QLineEdit::textChanged, this, [this] { reconsider(); });
    connect(m_reason, &QLineEdit::textChanged, this, [this] { reconsider(); });
    connect(m_revisions, &QTableWidget::itemSelectionChanged, this,
            [this] { showRevision(m_revisions->currentRow()); });
    connect(&m_context.session, &OperatorSession::changed, this, [this] { reconsider(); });
}

void RecipeForm::read() {
    if (!m_partType) {
        return;
    }
    const auto revisions = m_lots.recipes(*m_partType);
    if (revisions) {
        m_known = *revisions;
    } else {
        m_trouble = sentenceText(revisions.error(), look().units());
    }
}

void RecipeForm::showForm(const BoringRecipeForm& form) {
    for (std::size_t i = 0; i < m_fields.size() && i < form.values.size(); ++i) {
        m_fields[i]->setValue(form.values[i]);
    }
    while (m_depths.size() > form.depths.size()) {
        delete m_depths.back().field;
        delete m_depths.back().remove;
        m_depths.pop_back();
    }
    for (std::size_t i = 0; i < form.depths.size(); ++i) {
        if (i >= m_depths.size()) {
            addDepth(form.depths[i].overhang_mm);
        }
        m_depths[i].field->setValue(form.depths[i].overhang_mm);
    }
    layDepths();
    showDifference();
}

void RecipeForm::addDepth(double overhang_mm) {
    auto* field = new ValueField(look(), depthSpec(), m_area->widget());
    auto* remove = new QPushButton(tr("Remove"), m_area->widget());
    field->setValue(overhang_mm);
    m_depths.push_back({field, remove});
    field->show();
    remove->show();
    connect(field, &ValueField::edited, this, [this] { showDifference(); });
    connect(remove, &QPushButton::clicked, this, [this, remove] {
        const auto found = std::ranges::find(m_depths, remove, &Depth::remove);
        found->field->deleteLater();
        found->remove->deleteLater();
        found->field->hide();
        found->remove->hide();
        m_depths.erase(found);
        layDepths();
        showDifference();
    });
}

void RecipeForm::layDepths() {
    for (std::size_t i = 0; i < m_depths.size(); ++i) {
        const Depth& depth = m_depths[i];
        depth.field->setObjectName(QStringLiteral("recipeDepth%1").arg(i));
        depth.remove->setObjectName(QStringLiteral("recipeDepthRemove%1").arg(i));
        depth.field->setLabel(tr("Depth %1, overhang").arg(i + 1));
        depth.remove->setText(tr("Remove"));
        depth.remove->setEnabled(m_depths.size() > 1);
        m_depthGrid->addWidget(depth.field, static_cast<int>(i), 0);
        m_depthGrid->addWidget(depth.remove, static_cast<int>(i), 1, Qt::AlignBottom);
    }
    m_depthGrid->setColumnStretch(0, 1);
    m_add->reconsider();
}

std::optional<BoringRecipeForm> RecipeForm::typed() const {
    BoringRecipeForm form;
    for (const ValueField* field : m_fields) {
        const auto value = field->value();
        if (!value) {
            return std::nullopt;
        }
        form.values.push_back(*value);
    }
    for (std::size_t i = 0; i < m_depths.size(); ++i) {
        const auto value = m_depths[i].field->value();
        if (!value) {
            return std::nullopt;
        }
        form.depths.push_back({depthNameOf(i, m_depths.size()), *value});
    }
    return form;
}

const BoringRecipeView* RecipeForm::shownRevision() const {
    const int row = m_revisions->currentRow();
    return row >= 0 && row < static_cast<int>(m_known.size()) ? &m_known[static_cast<std::size_t>(row)] : nullptr;
}

void RecipeForm::showRevision(int row) {
    if (row >= 0 && row < static_cast<int>(m_known.size())) {
        showForm(m_known[static_cast<std::size_t>(row)].form);
    }
}

QString RecipeForm::valueText(const ParamSpec* spec, const std::optional<double>& value) const {
    const ParamSpec& shown = spec != nullptr ? *spec : depthSpec();
    return value ? look().units().number(*value, shown.unit, shown.decimals) : QStringLiteral("–");
}

// What the fields hold against the newest revision.
void RecipeForm::showDifference() {
    QStringList lines;
    const auto now = typed();
    if (!m_known.empty() && now) {
        for (const BoringRecipeChange& change : m_lots.compare(m_known.front().form, *now)) {
            lines << tr("%1: %2 → %3", "name of a number, newest revision, shown")
                         .arg(
                             change.spec != nullptr ? engineText(change.spec->label) : tr("Depth %1").arg(change.depth),
                             valueText(change.spec, change.before), valueText(change.spec, change.after));
        }
        const QString than = (lines.isEmpty() ? tr("As revision %1, the newest.") : tr("Against revision %1:"))
                                 .arg(m_known.front().revision);
        lines.prepend(withParticles(than));
        m_difference->setText(lines.join(u'\n'));
    } else {
        m_difference->clear();
    }
    reconsider();
}

void RecipeForm::reconsider() {
    for (ActionButton* button : {m_restore, m_save}) {
        button->reconsider();
    }
    QString text = m_trouble;
    if (text.isEmpty()) {
        const auto now = typed();
        const auto why = now ? m_lots.whyUnusable(*now) : std::nullopt;
        text = !now  ? tr("A number is missing or out of its range.")
               : why ? sentenceText(*why, look().units())
                     : tr("Lots that are open keep their own revision.");
    }
    m_message->setText(text);
}

QString RecipeForm::whyNoChange() const {
    if (m_pending) {
        return tr("being stored");
    }
    return m_context.session.signedOn() ? m_context.session.whyNot(Role::Engineer) : tr("sign on first");
}

QString RecipeForm::whyNoSave() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    const auto now = typed();
    if (!now || m_lots.whyUnusable(*now)) {
        return tr("a number does not fit");
    }
    if (!m_partType) {
        return m_name->text().trimmed().isEmpty() ? tr("a part type needs a name") : QString();
    }
    if (!m_known.empty() && m_lots.compare(m_known.front().form, *now).empty()) {
        return tr("nothing is changed");
    }
    return m_reason->text().trimmed().isEmpty() ? tr("give a reason") : QString();
}

QString RecipeForm::whyNoRestore() const {
    if (const QString why = whyNoChange(); !why.isEmpty()) {
        return why;
    }
    const BoringRecipeView* shown = shownRevision();
    if (shown == nullptr || m_known.empty() || shown->revision == m_known.front().revision) {
        return tr("touch an older revision");
    }
    return m_reason->text().trimmed().isEmpty() ? tr("give a reason") : QString();
}

void RecipeForm::save() {
    const auto now = typed();
    if (!now || !whyNoSave().isEmpty()) {
        return;
    }
    const std::string author = m_context.session.author();
    beginWaiting();
    const auto self = QPointer<RecipeForm>(this);
    if (m_partType) {
        m_lots.saveRecipe(*m_partType, *now, author, m_reason->text().trimmed().toStdString(),
                          [self](const Result<void>& result) {
                              if (RecipeForm* form = self.data()) {
                                  form->answered(result, tr("The recipe has a new revision."));
                              }
                          });
        return;
    }
    if (m_sheet) m_sheet->sent();
    m_lots.addPartType(m_name->text().trimmed().toStdString(), *now, author, [self](const Result<PartTypeId>& made) {
        RecipeForm* form = self.data();
        if (form == nullptr) {
            return;
        }
        if (!made) {
            form->answered(tl::unexpected(made.error()), {});
            return;
        }
        const PageContext context = form->m_context;
        context.notify(tr("The part type is there."));
        form->m_pending = false;
        if (context.sheets.isOpen(form->m_sheet) && form->m_sheet->taken()) {
            LotForm::open(context)->choosePartType(*made);
        }
    });
}

void RecipeForm::beginWaiting() {
    m_pending = true;
    m_trouble.clear();
    m_sent = typed();
    m_sentReason = m_reason->text();
}

void RecipeForm::restore() {
    const BoringRecipeView* shown = shownRevision();
    if (shown == nullptr || !whyNoRestore().isEmpty()) {
        return;
    }
    beginWaiting();
    m_lots.restoreRecipe(*m_partType, shown->revision, m_context.session.author(),
                         m_reason->text().trimmed().toStdString(),
                         [self = QPointer<RecipeForm>(this), revision = shown->revision](const Result<void>& result) {
                             if (RecipeForm* form = self.data()) {
                                 form->answered(result, withParticles(tr("Revision %1 is back.").arg(revision)));
                             }
                         });
}

void RecipeForm::answered(const Result<void>& result, const QString& done) {
    m_pending = false;
    if (!result) {
        m_trouble = sentenceText(result.error(), look().units());
        reconsider();
        return;
    }
    m_context.notify(done);
    if (m_reason->text() == m_sentReason) {
        m_reason->clear();
    }
    read();
    m_revisions->setCurrentItem(nullptr);
    // What was typed while the answer was awaited stays, with its field.
    const auto now = typed();
    if (now && m_sent && m_lots.compare(*m_sent, *now).empty() && !m_lots.compare(m_known.front().form, *now).empty()) {
        showForm(m_known.front().form);
    } else {
        showDifference();
    }
    refresh();
}

void RecipeForm::refresh() {
    if (m_sheet) {
        QString name;
        if (const auto types = m_lots.partTypes(); types && m_partType) {
            for (const BoringPartTypeView& type : *types) {
                name = type.id == *m_partType ? QString::fromStdString(type.name) : name;
            }
        }
        m_sheet->setTitle(m_partType ? tr("Recipe of %1").arg(name) : tr("New part type"));
    }
    const UnitSystem& units = look().units();
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const ParamSpec& spec = m_lots.recipeSpecs()[i];
        m_hints[i]->setText(tr("%1 to %2; default %3, %4", "range, default, source of the default")
                                .arg(units.number(spec.min, spec.unit, spec.decimals),
                                     units.withUnit(spec.max, spec.unit, spec.decimals),
                                     units.number(spec.fallback, spec.unit, spec.decimals), engineText(spec.source)));
    }
    m_name->setPlaceholderText(tr("Name of the part type"));
    m_reason->setPlaceholderText(tr("Reason for the change"));
    m_depthTitle->setText(tr("Depths, in measuring order"));
    m_add->setText(tr("Add a depth"));
    m_cancel->setText(tr("Back"));
    m_restore->setText(tr("Roll back to it"));
    m_save->setText(m_partType ? tr("Save as a new revision") : tr("Make the part type"));
    const int gap = look().metrics().touchGap();
    m_grid->setHorizontalSpacing(2 * gap);
    m_columns->setSpacing(2 * gap);
    m_side->setSpacing(look().space(Space::Medium));
    m_area->widget()->layout()->setContentsMargins(0, 0, gap, 0);
    m_revisions->setFixedWidth(m_keypad->sizeHint().width());
    m_name->setFixedWidth(m_keypad->sizeHint().width());
    m_revisions->verticalHeader()->setDefaultSectionSize(look().metrics().touch());
    const int row = m_revisions->currentRow();
    const QSignalBlocker quiet(m_revisions);
    m_revisions->clear();
    m_revisions->setColumnCount(3);
    m_revisions->setHorizontalHeaderLabels({tr("Rev."), tr("When, by"), tr("Why")});
    m_revisions->setRowCount(static_cast<int>(m_known.size()));
    for (int i = 0; i < m_revisions->rowCount(); ++i) {
        const BoringRecipeView& known = m_known[static_cast<std::size_t>(i)];
        const QString when =
            QDateTime::fromMSecsSinceEpoch(known.createdUtc_ms).toString(QStringLiteral("MM-dd HH:mm"));
        const QString why =
            known.restoredFrom
                ? withParticles(
                      tr("back to %1: %2", "revision, reason").arg(*known.restoredFrom).arg(reasonText(known.reason)))
                : reasonText(known.reason);
        const QStringList cells{QString::number(known.revision), when + u' ' + QString::fromStdString(known.author),
                                why};
        for (int c = 0; c < cells.size(); ++c) {
            m_revisions->setItem(i, c, new QTableWidgetItem(cells[c]));
        }
    }
    m_revisions->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_revisions->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    if (row >= 0) {
        m_revisions->selectRow(row);
    }
    layDepths();
    showDifference();
    FaceWidget::refresh();
}

}  // namespace kerf::ui

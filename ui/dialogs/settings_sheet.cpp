// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/settings_sheet.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <array>

#include "ui/dialogs/sheet.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct Settings {
    Q_DECLARE_TR_FUNCTIONS(Settings)
};

/// One row: a name and its choices, exactly one of which is down.
class ChoiceRow {
 public:
    ChoiceRow(Look& look, QGridLayout* grid, int row, QWidget* parent)
        : m_look(look), m_grid(grid), m_row(row), m_parent(parent) {
        m_name = makeLabel(TextRole::Body, parent);
        grid->addWidget(m_name, row, 0);
    }
    void setName(const QString& name) { m_name->setText(name); }
    QPushButton* add(const char* objectName, std::function<void(Preferences&)> apply,
                     std::function<bool(const Preferences&)> is) {
        auto* button = new QPushButton(m_parent);
        button->setCheckable(true);
        button->setObjectName(QLatin1String(objectName));
        m_grid->addWidget(button, m_row, 1 + m_count++);
        Look& look = m_look;
        const auto show = [button, is, &look] { button->setChecked(is(look.preferences())); };
        QObject::connect(button, &QPushButton::clicked, m_parent, [apply, show, &look] {
            Preferences preferences = look.preferences();
            apply(preferences);
            look.apply(preferences);
            show();
        });
        QObject::connect(&look, &Look::changed, button, show);
        show();
        return button;
    }

 private:
    Look& m_look;
    QGridLayout* m_grid;
    int m_row;
    int m_count{0};
    QWidget* m_parent;
    QLabel* m_name;
};

}  // namespace

void openSettings(Look& look, SheetHost& host) {
    Sheet* sheet = host.open({});
    sheet->followLanguage();
    auto* grid = new QGridLayout;
    sheet->body()->addLayout(grid);
    const auto rows = std::make_shared<std::vector<ChoiceRow>>();
    for (int i = 0; i < 6; ++i) {
        rows->emplace_back(look, grid, i, sheet);
    }
    auto& r = *rows;
    using P = Preferences;
    QPushButton* english = r[0].add(
        "languageEnglish", [](P& p) { p.language = Language::English; },
        [](const P& p) { return p.language == Language::English; });
    QPushButton* korean = r[0].add(
        "languageKorean", [](P& p) { p.language = Language::Korean; },
        [](const P& p) { return p.language == Language::Korean; });
    english->setText(QStringLiteral("English"));  // each in its own language
    korean->setText(QStringLiteral("한국어"));
    QPushButton* mm = r[1].add(
        "unitMillimetre", [](P& p) { p.length = LengthUnit::Millimetre; },
        [](const P& p) { return p.length == LengthUnit::Millimetre; });
    QPushButton* inch = r[1].add(
        "unitInch", [](P& p) { p.length = LengthUnit::Inch; }, [](const P& p) { return p.length == LengthUnit::Inch; });
    QPushButton* celsius = r[2].add(
        "unitCelsius", [](P& p) { p.temperature = TemperatureUnit::Celsius; },
        [](const P& p) { return p.temperature == TemperatureUnit::Celsius; });
    QPushButton* fahrenheit = r[2].add(
        "unitFahrenheit", [](P& p) { p.temperature = TemperatureUnit::Fahrenheit; },
        [](const P& p) { return p.temperature == TemperatureUnit::Fahrenheit; });
    celsius->setText(QStringLiteral("°C"));
    fahrenheit->setText(QStringLiteral("°F"));
    QPushButton* light = r[3].add(
        "themeLight", [](P& p) { p.brightness = Brightness::Light; },
        [](const P& p) { return p.brightness == Brightness::Light; });
    QPushButton* dark = r[3].add(
        "themeDark", [](P& p) { p.brightness = Brightness::Dark; },
        [](const P& p) { return p.brightness == Brightness::Dark; });
    constexpr std::array kScales{0.8, 1.0, 1.25, 1.5, 2.0};
    for (const double scale : kScales) {
        const QByteArray name = "scale" + QByteArray::number(static_cast<int>(scale * 100));
        r[4].add(
                name.constData(), [scale](P& p) { p.scale = scale; }, [scale](const P& p) { return p.scale == scale; })
            ->setText(QStringLiteral("%1\u00a0%").arg(static_cast<int>(scale * 100)));
    }
    // Each role has its own; changed is that of the one who is signed on.
    const auto addWording = [&](const char* name, Wording wording) {
        return r[5].add(
            name, [wording, &look](P& p) { p.wordings[look.role()] = wording; },
            [wording, &look](const P& p) { return p.wordings[look.role()] == wording; });
    };
    QPushButton* shop = addWording("wordingShop", Wording::Shop);
    QPushButton* symbols = addWording("wordingSymbols", Wording::Symbols);
    QPushButton* close = sheet->addButton(QString(), {});
    close->setObjectName(QStringLiteral("sheetSafe"));
    const auto retext = [=, &look] {
        sheet->setTitle(Settings::tr("Settings"));
        (*rows)[0].setName(Settings::tr("Language"));
        (*rows)[1].setName(Settings::tr("Length"));
        (*rows)[2].setName(Settings::tr("Temperature"));
        (*rows)[3].setName(Settings::tr("Theme"));
        (*rows)[4].setName(Settings::tr("Size"));
        (*rows)[5].setName(Settings::tr("Figures in"));
        shop->setText(Settings::tr("Shop words"));
        symbols->setText(Settings::tr("Symbols"));
        mm->setText(QStringLiteral("mm"));
        inch->setText(Settings::tr("inch"));
        light->setText(Settings::tr("Light"));
        dark->setText(Settings::tr("Dark"));
        close->setText(Settings::tr("Close"));
        grid->setHorizontalSpacing(look.metrics().touchGap());
        grid->setVerticalSpacing(look.metrics().touchGap());
    };
    QObject::connect(&look, &Look::changed, sheet, retext);
    retext();
}

}  // namespace kerf::ui

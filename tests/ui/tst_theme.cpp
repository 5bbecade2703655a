// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QFontInfo>
#include <QFontMetrics>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <vector>

#include "tests/support/color_vision.h"
#include "ui/theme/look.h"

using namespace kerf::ui;
using kerf::test::distance;
using kerf::test::Vision;

class TestTheme : public QObject {
    Q_OBJECT
 private slots:
    void textStandsOutOnEverySurface() {
        for (const Brightness brightness : {Brightness::Light, Brightness::Dark}) {
            const Palette palette(brightness);
            for (const Token surface : {Token::Ground, Token::Panel, Token::Raised}) {
                const double text = Palette::contrast(palette.color(Token::Text), palette.color(surface));
                const double dim = Palette::contrast(palette.color(Token::Dim), palette.color(surface));
                QVERIFY2(text >= 7.0, qPrintable(QString::number(text)));
                QVERIFY2(dim >= 4.5, qPrintable(QString::number(dim)));
            }
        }
    }
    void curvesAndAlarmsStandOutFromTheirSurface() {
        for (const Brightness brightness : {Brightness::Light, Brightness::Dark}) {
            const Palette palette(brightness);
            for (const Token token : {Token::Measured, Token::Predicted, Token::Limit, Token::Alarm1, Token::Acting}) {
                const double c = Palette::contrast(palette.color(token), palette.color(Token::Panel));
                QVERIFY2(c >= 3.0, qPrintable(QStringLiteral("%1: %2").arg(int(token)).arg(c)));
            }
        }
    }
    void redGreenBlindEyesTellTheColoursApart() {
        // Colours that meet in one place. Shape and word come on top; dash and width separate the limit lines.
        const std::vector<std::pair<Token, Token>> pairs{
            {Token::Measured, Token::Predicted}, {Token::Measured, Token::Limit},  {Token::Measured, Token::Past},
            {Token::Measured, Token::Wanted},    {Token::Predicted, Token::Limit}, {Token::Alarm1, Token::Alarm2},
            {Token::Alarm2, Token::Alarm3},      {Token::Alarm1, Token::Alarm3},   {Token::Alarm1, Token::Acting},
            {Token::Alarm2, Token::Acting},      {Token::Alarm3, Token::Acting},   {Token::Alarm1, Token::Measured},
            {Token::Limit, Token::Alarm2},       {Token::Acting, Token::Dim},      {Token::Acting, Token::Past},
            {Token::Alarm1, Token::Dim}};
        for (const Brightness brightness : {Brightness::Light, Brightness::Dark}) {
            const Palette palette(brightness);
            for (const auto& [a, b] : pairs) {
                for (const Vision vision : {Vision::Normal, Vision::Protan, Vision::Deutan}) {
                    const double d = distance(palette.color(a), palette.color(b), vision);
                    QVERIFY2(d >= 10.0, qPrintable(QStringLiteral("%1 %2, vision %3, %4: %5")
                                                       .arg(int(a))
                                                       .arg(int(b))
                                                       .arg(int(vision))
                                                       .arg(brightness == Brightness::Light ? "light" : "dark")
                                                       .arg(d)));
                }
            }
        }
    }
    void theSimulationKnowsRedFromGreenOnlyForNormalEyes() {
        const QColor red = QColor::fromRgbF(0.60F, 0.35F, 0.1F);
        const QColor green = QColor::fromRgbF(0.40F, 0.45F, 0.1F);
        QVERIFY(distance(red, green, Vision::Normal) > 2.0 * distance(red, green, Vision::Deutan));
    }
    void alarmsAreNamedByPriority() {
        QCOMPARE(Palette::alarm(1), Token::Alarm1);
        QCOMPARE(Palette::alarm(2), Token::Alarm2);
        QCOMPARE(Palette::alarm(3), Token::Alarm3);
    }
    void sizesFollowDpiAndScale() {
        const Metrics normal(96.0);
        const Metrics fine(192.0);
        QVERIFY(std::abs(fine.touch() - 2 * normal.touch()) <= 1);
        QCOMPARE(Metrics(96.0, 2.0).touch(), fine.touch());
        QVERIFY(normal.touch() >= 15.0 * normal.pxPerMm());
        QVERIFY(normal.text(TextSize::Label) >= 2.8 * normal.pxPerMm());
        QCOMPARE(normal.space(Space::Hair), 2);
        QCOMPARE(normal.space(Space::Large), 16);
        QCOMPARE(Metrics(96.0, 99.0).scale(), Metrics::kMaxScale);
    }
    void figuresAreOfOneWidth() {
        const Look look(96.0);
        for (const TextSize size : {TextSize::Label, TextSize::Body, TextSize::Card, TextSize::Page}) {
            const QFontMetrics metrics(look.font(size));
            for (const char digit : std::string("0123456789")) {
                QCOMPARE(metrics.horizontalAdvance(QLatin1Char(digit)), metrics.horizontalAdvance(QLatin1Char('0')));
            }
        }
        QCOMPARE(QFontInfo(look.font(TextSize::Body)).family(), QStringLiteral("Noto Sans"));
    }
    void everythingSwitchesLiveAndOnce() {
        Look look(96.0);
        QSignalSpy changed(&look, &Look::changed);
        Preferences preferences = look.preferences();
        look.apply(preferences);
        QCOMPARE(changed.count(), 0);
        const QString light = qApp->styleSheet();
        preferences.brightness = Brightness::Dark;
        preferences.length = LengthUnit::Inch;
        preferences.language = Language::Korean;
        look.apply(preferences);
        QCOMPARE(changed.count(), 1);
        QVERIFY(qApp->styleSheet() != light);
        QCOMPARE(look.units().length(), LengthUnit::Inch);
        QCOMPARE(QApplication::palette().color(QPalette::Window), Palette(Brightness::Dark).color(Token::Ground));
    }
    void aPlainButtonIsATouchTarget() {
        const Look look(96.0);
        QPushButton button(QStringLiteral("x"));
        button.ensurePolished();
        QVERIFY(button.sizeHint().height() >= look.metrics().touch());
        QVERIFY(button.sizeHint().width() >= look.metrics().touch());
    }
};

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"

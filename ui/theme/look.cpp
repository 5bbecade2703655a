// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/look.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPalette>
#include <QScreen>

namespace kerf::ui {

Look::Look(double dpi, QObject* parent) : QObject(parent), m_dpi(dpi) {
    if (m_dpi <= 0.0) {
        const QScreen* screen = QGuiApplication::primaryScreen();
        m_dpi = screen != nullptr ? screen->logicalDotsPerInch() : 96.0;
    }
    setLanguage(m_preferences.language);
    refresh();
}

Look::Look(Look& content) : QObject(nullptr), m_content(&content), m_dpi(content.m_dpi) {
    const auto follow = [this] {
        m_preferences = m_content->m_preferences;
        m_role = m_content->m_role;
        m_units = m_content->m_units;
        refresh();
        emit changed();
    };
    connect(m_content, &Look::changed, this, follow);
    follow();
}

void Look::limitScale(double most) {
    if (most != m_most) {
        m_most = most;
        const double before = m_metrics.scale();
        refresh();
        if (m_metrics.scale() != before) {
            emit changed();
        }
    }
}

Look::~Look() {
    QCoreApplication::removeTranslator(&m_texts);
    QCoreApplication::removeTranslator(&m_qtTexts);
}

void Look::apply(const Preferences& preferences) {
    if (m_content != nullptr) {
        m_content->apply(preferences);
        return;
    }
    if (preferences == m_preferences) {
        return;
    }
    const bool otherLanguage = preferences.language != m_preferences.language;
    const bool otherStyle =
        preferences.brightness != m_preferences.brightness || preferences.scale != m_preferences.scale;
    m_preferences = preferences;
    m_units = UnitSystem(preferences.length, preferences.temperature);
    if (otherStyle) {
        refresh();
    }
    if (otherLanguage) {
        setLanguage(preferences.language);
    }
    emit changed();
}

void Look::setRole(std::size_t role) {
    if (m_content != nullptr) {
        m_content->setRole(role);
        return;
    }
    const Wording before = wording();
    m_role = qMin(role, Preferences::kRoles - 1);
    if (wording() != before) {
        emit changed();
    }
}

QFont Look::font(TextSize size, QFont::Weight weight) const {
    QFont font;
    font.setFamilies({QStringLiteral("Noto Sans"), QStringLiteral("Noto Sans CJK KR")});
    font.setPixelSize(m_metrics.text(size));
    font.setWeight(weight);
    font.setHintingPreference(QFont::PreferNoHinting);  // hinted Hangul is as heavy as bold at these sizes
    return font;
}

QPen Look::pen(Token token, Stroke stroke, Qt::PenStyle style) const {
    QPen pen(color(token), m_metrics.stroke(stroke), style, Qt::FlatCap, Qt::MiterJoin);
    return pen;
}

void Look::refresh() {
    m_palette = Palette(m_preferences.brightness);
    m_metrics = Metrics(m_dpi, qMin(m_preferences.scale, m_most));
    if (m_content != nullptr) {
        return;
    }
    QPalette p;
    p.setColor(QPalette::Window, color(Token::Ground));
    p.setColor(QPalette::WindowText, color(Token::Text));
    p.setColor(QPalette::Base, color(Token::Raised));
    p.setColor(QPalette::AlternateBase, color(Token::Panel));
    p.setColor(QPalette::Text, color(Token::Text));
    p.setColor(QPalette::PlaceholderText, color(Token::Dim));
    p.setColor(QPalette::Button, color(Token::Raised));
    p.setColor(QPalette::ButtonText, color(Token::Text));
    p.setColor(QPalette::Highlight, color(Token::Measured));
    p.setColor(QPalette::HighlightedText, Palette::on(color(Token::Measured)));
    p.setColor(QPalette::ToolTipBase, color(Token::Raised));
    p.setColor(QPalette::ToolTipText, color(Token::Text));
    p.setColor(QPalette::Disabled, QPalette::Text, color(Token::Dim));
    p.setColor(QPalette::Disabled, QPalette::WindowText, color(Token::Dim));
    p.setColor(QPalette::Disabled, QPalette::ButtonText, color(Token::Dim));
    QApplication::setPalette(p);
    QApplication::setFont(font(TextSize::Body));
    if (qApp != nullptr) {
        qApp->setStyleSheet(styleSheet(*this));
    }
}

void Look::setLanguage(Language language) {
    QCoreApplication::removeTranslator(&m_texts);
    QCoreApplication::removeTranslator(&m_qtTexts);
    const QString name = language == Language::Korean ? QStringLiteral("ko") : QStringLiteral("en");
    if (m_texts.load(QStringLiteral(":/translations/kerf_%1.qm").arg(name))) {
        QCoreApplication::installTranslator(&m_texts);
    }
    if (m_qtTexts.load(QStringLiteral("qtbase_%1").arg(name), QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(&m_qtTexts);
    }
    QLocale::setDefault(QLocale::c());  // the same digits in every language
}

}  // namespace kerf::ui

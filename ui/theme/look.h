// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QObject>
#include <QPen>
#include <QTranslator>
#include <array>
#include <cstddef>

#include "ui/theme/metrics.h"
#include "ui/theme/palette.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

enum class Language { English, Korean };

/// Whose words figures are named in (ui/link/vocabulary.h): the shop's, or symbols with formulas and papers.
enum class Wording { Shop, Symbols };

/// What an operator chooses about the face. A plain value: the application stores it, Look applies it.
struct Preferences {
    static constexpr std::size_t kRoles = 3;  ///< operator, setter, process engineer

    Language language{Language::English};
    LengthUnit length{LengthUnit::Millimetre};
    TemperatureUnit temperature{TemperatureUnit::Celsius};
    Brightness brightness{Brightness::Light};
    double scale{1.0};  ///< Metrics::kMinScale … kMaxScale
    std::array<Wording, kRoles> wordings{Wording::Shop, Wording::Shop, Wording::Symbols};  ///< by role

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// How everything looks: colours, sizes, fonts, units, language. One object, handed to every widget by reference.
///
/// A widget draws with look.color(), look.px(), look.font(), look.units() and connects changed() to its own
/// refresh; texts are set again in changeEvent(LanguageChange).
class Look : public QObject {
    Q_OBJECT
 public:
    /// @param dpi logical dots per inch; 0: the primary screen's
    explicit Look(double dpi = 0.0, QObject* parent = nullptr);
    /// The look of the frame around `content`: the same in everything, but never larger than limitScale() allows. What
    /// is applied to it is applied to `content`, which outlives it; it has no effect on the application's own style
    /// sheet.
    explicit Look(Look& content);
    ~Look() override;

    /// Of a frame's look: the largest scale at which it fits its window.
    void limitScale(double most);
    [[nodiscard]] double dpi() const { return m_dpi; }
    [[nodiscard]] const Preferences& preferences() const { return m_preferences; }
    /// Switch whatever differs, live: style sheet, fonts, translator, units. Emits changed() once.
    void apply(const Preferences& preferences);
    /// Who looks: an index of Preferences::wordings; 0 also while nobody is signed on.
    void setRole(std::size_t role);
    [[nodiscard]] std::size_t role() const { return m_role; }
    [[nodiscard]] Wording wording() const { return m_preferences.wordings[m_role]; }

    [[nodiscard]] const Palette& palette() const { return m_palette; }
    [[nodiscard]] const Metrics& metrics() const { return m_metrics; }
    [[nodiscard]] const UnitSystem& units() const { return m_units; }

    [[nodiscard]] QColor color(Token token) const { return m_palette.color(token); }
    [[nodiscard]] int px(double size_mm) const { return m_metrics.px(size_mm); }
    [[nodiscard]] int space(Space step) const { return m_metrics.space(step); }
    /// Noto Sans with Korean behind it; its figures are all of one width.
    [[nodiscard]] QFont font(TextSize size, QFont::Weight weight = QFont::Normal) const;
    [[nodiscard]] QPen pen(Token token, Stroke stroke = Stroke::Normal, Qt::PenStyle style = Qt::SolidLine) const;

 signals:
    void changed();

 private:
    void refresh();
    void setLanguage(Language language);

    Look* m_content{nullptr};  ///< this is the look of the frame around it
    double m_most{Metrics::kMaxScale};
    double m_dpi;
    Preferences m_preferences;
    std::size_t m_role{0};
    Palette m_palette;
    Metrics m_metrics;
    UnitSystem m_units;
    QTranslator m_texts;
    QTranslator m_qtTexts;
};

/// The style sheet of the standard widgets, made from tokens.
[[nodiscard]] QString styleSheet(const Look& look);

}  // namespace kerf::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBoxLayout>
#include <functional>
#include <optional>
#include <vector>

#include "engine/core/process.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/alarm_list.h"
#include "ui/link/engine_client.h"
#include "ui/shell/operator_session.h"
#include "ui/shell/services.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/face_widget.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

struct PageEntry;

/// What a page works with. All references live as long as the page.
struct PageContext {
    Look& look;
    Services& services;
    EngineClient& client;      ///< statusChanged, samplesArrived, send(): refusals are told by the shell
    OperatorSession& session;  ///< who signs entries
    AlarmList& alarms;
    SheetHost& sheets;                                    ///< questions over the page area
    std::function<void(const char* key)> showPage;        ///< go to another page
    std::function<void(const QString& sentence)> notify;  ///< a sentence on the bottom line
    /// Run an action that needs a name: asks who is there first when nobody is signed on.
    std::function<void(std::function<void()> action)> withOperator;
    /// The same for what only some may do: asks who is there when nobody is, and says why not when it is refused.
    std::function<void(Role least, std::function<void()> action)> withRole{};
    const std::vector<PageEntry>* pages{nullptr};  ///< of this console; null: a page alone
    void withPermission(Deed deed, std::function<void()> action) const {
        withRole ? withRole(permissionOf(deed).least, std::move(action)) : withOperator(std::move(action));
    }
};

/// The one look of what somebody may not do: the button is off and says who may. With nobody signed on it stays on, and
/// asks who is there.
inline void allowOnly(ActionButton* button, OperatorSession& session, Deed deed) {
    button->setPermission([&session, deed] { return session.whyNot(deed); });
    QObject::connect(&session, &OperatorSession::changed, button, &ActionButton::reconsider);
}

/// A page of the console. Derive, build widgets in the constructor, set every text, size and colour in refresh(), call
/// refresh() at the constructor's end, connect to context().client for live values. A page is only alive when visible:
/// skip drawing work while !isVisible().
class Page : public FaceWidget {
    Q_OBJECT
 public:
    explicit Page(const PageContext& context, QWidget* parent = nullptr)
        : FaceWidget(context.look, parent), m_context(context) {
        setObjectName(QStringLiteral("page"));
    }

 protected:
    [[nodiscard]] const PageContext& context() const { return m_context; }
    /// Instead of everything else where the console lacks what the page shows: one sentence in its middle.
    QLabel* addNotice(QBoxLayout* in) {
        QLabel* notice = makeLabel(TextRole::Body, this, true);
        notice->setAlignment(Qt::AlignCenter);
        in->addWidget(notice, 1);
        return notice;
    }

 private:
    PageContext m_context;
};

/// The number that matters of one loop, for its card on Overview.
struct KeyFigure {
    QString label{};       ///< translated
    const char* unit{""};  ///< stored unit
    int decimals{1};
    std::optional<double> value{};
    std::optional<double> half95{};
    bool limited{false};
    /// Course for the sparkline, oldest first; empty: the card remembers `value` over the last minute itself.
    std::vector<double> course{};
    /// What the course should stay within, where that is known.
    std::optional<double> lower{};
    std::optional<double> upper{};
};

/// One row of the navigation. A process hands in its own with its room (app/console/rooms).
struct PageEntry {
    const char* key{""};                 ///< "boring": object name, settings, screenshots
    std::function<QString()> title{};    ///< translated, asked again when the language changes
    std::optional<ProcessId> process{};  ///< the navigation then shows the loop's lamp and state
    std::function<Page*(const PageContext&)> make{};
    std::function<KeyFigure(const Services&, const Status&)> keyFigure{};  ///< process pages: Overview's card
};

using PageList = std::vector<PageEntry>;
/// All pages in the order of the navigation: Overview, those of the processes, and what they have in common.
[[nodiscard]] PageList standardPages(PageList ofProcesses);

}  // namespace kerf::ui

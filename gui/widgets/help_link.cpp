#include "gui/widgets/help_link.h"

#include "gui/text/help_anchors.h"

#include <QDesktopServices>
#include <QUrl>

#include <utility>

namespace unprojector::gui {
namespace {

/// Only compared, because it may be deleted already.
const HelpOpener *current = nullptr;

} // namespace

HelpLink::HelpLink(const QString &anchor, QWidget *parent) : QToolButton(parent), m_anchor(anchor)
{
    setText(QStringLiteral("?"));
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setToolTip(tr("Its formulas in Help"));
    setAccessibleName(toolTip());
    connect(this, &QToolButton::clicked, this, [this] { openHelp(m_anchor); });
}

void openHelp(const QString &anchor)
{
    QDesktopServices::openUrl(QUrl(helpAddress(anchor)));
}

HelpOpener::HelpOpener(std::function<void(const QString &)> open, QObject *parent)
    : QObject(parent), m_open(std::move(open))
{
    QDesktopServices::setUrlHandler(QUrl(helpAddress({})).scheme(), this, "openUrl");
    current = this;
}

HelpOpener::~HelpOpener()
{
    if (current == this) // else another one has replaced it
        QDesktopServices::unsetUrlHandler(QUrl(helpAddress({})).scheme());
}

void HelpOpener::openUrl(const QUrl &url)
{
    m_open(url.path());
}

} // namespace unprojector::gui

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

void openManual(const QString &place)
{
    QDesktopServices::openUrl(QUrl(manualAddress(place)));
}

HelpOpener::HelpOpener(Open open, Open openManual, QObject *parent)
    : QObject(parent), m_open(std::move(open)), m_openManual(std::move(openManual))
{
    for (const QString &address : {helpAddress({}), manualAddress({})})
        QDesktopServices::setUrlHandler(QUrl(address).scheme(), this, "openUrl");
    current = this;
}

HelpOpener::~HelpOpener()
{
    if (current != this) // another one has taken over
        return;
    for (const QString &address : {helpAddress({}), manualAddress({})})
        QDesktopServices::unsetUrlHandler(QUrl(address).scheme());
}

void HelpOpener::openUrl(const QUrl &url)
{
    if (url.scheme() == QUrl(manualAddress({})).scheme())
        m_openManual(url.path() + (url.hasFragment() ? u'#' + url.fragment() : QString()));
    else
        m_open(url.path());
}

} // namespace unprojector::gui

#include "gui/overlay_bars.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

#include <cmath>

namespace unprojector {
namespace {

void makeOverlay(QFrame *frame, const char *background, const char *border)
{
    frame->setObjectName(QStringLiteral("overlay"));
    frame->setAttribute(Qt::WA_StyledBackground);
    frame->setStyleSheet(QStringLiteral("#overlay { background: %1; border: 1px solid %2; border-radius: 4px; } "
                                        "#overlay QLabel { color: #2b2b2b; }")
                             .arg(QLatin1String(background), QLatin1String(border)));
    frame->hide();
}

} // namespace

MessageBar::MessageBar(QWidget *parent) : QFrame(parent), m_text(new QLabel), m_close(new QToolButton)
{
    makeOverlay(this, "#fdeeda", "#d9a35b");
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setAccessibleName(tr("Message"));
    m_close->setIcon(style()->standardIcon(QStyle::SP_DialogCloseButton));
    m_close->setAutoRaise(true);
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_close, 0, Qt::AlignTop);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
}

void MessageBar::showMessage(const QString &text)
{
    m_text->setText(text);
    show();
    raise();
}

QString MessageBar::text() const
{
    return m_text->text();
}

LoadingBar::LoadingBar(QWidget *parent)
    : QFrame(parent), m_text(new QLabel), m_progress(new QProgressBar), m_delay(new QTimer(this))
{
    makeOverlay(this, "#f4f6f8", "#a9b3bd");
    m_progress->setRange(0, 100);
    m_progress->setAccessibleName(tr("Opening"));
    m_progress->setMinimumWidth(180);
    auto *cancel = new QPushButton(tr("Cancel"));
    cancel->setToolTip(tr("Stop opening and keep the scene as it is"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_text);
    layout->addWidget(m_progress, 1);
    layout->addWidget(cancel);
    connect(cancel, &QPushButton::clicked, this, &LoadingBar::cancelRequested);
    m_delay->setSingleShot(true);
    m_delay->setInterval(150);
    connect(m_delay, &QTimer::timeout, this, [this] {
        show();
        raise();
    });
}

void LoadingBar::start()
{
    m_text->setText(tr("Opening …"));
    m_progress->setValue(0);
    m_delay->start();
}

void LoadingBar::setProgress(const QString &fileName, double share)
{
    m_text->setText(tr("Opening %1").arg(fileName));
    m_progress->setValue(static_cast<int>(std::lround(share * 100.0)));
}

void LoadingBar::finish()
{
    m_delay->stop();
    hide();
}

} // namespace unprojector

#include "gui/shell/overlay_bars.h"

#include "gui/document/recovery_file.h"
#include "gui/text/error_text.h"
#include "gui/widgets/contrast.h"
#include "gui/widgets/plain_text_box.h"

#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

QString dateText(const QDateTime &time)
{
    return time.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")); // the same in every language
}

/// The colours of a bar over the view, with light and dark window colours.
class OverlayColours : public QObject {
public:
    OverlayColours(QFrame &frame, const QColor &background, const QColor &border)
        : QObject(&frame), m_frame(frame), m_background(background), m_border(border)
    {
        frame.installEventFilter(this);
        colour();
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        // A frame with a style sheet does not always take the window's palette.
        if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationPaletteChange)
            colour();
        return QObject::eventFilter(watched, event);
    }

private:
    void colour()
    {
        constexpr double kShare = 0.2; // of the border's colour in a dark bar
        const QPalette colors = QApplication::palette();
        const QColor window = colors.color(QPalette::Window);
        const bool isDark = window.lightnessF() < 0.5F;
        const QColor background = isDark ? mixed(window, m_border, kShare) : m_background;
        const QColor ink = isDark ? colors.color(QPalette::WindowText) : QColor(0x2b, 0x2b, 0x2b);
        const QString style =
            QStringLiteral("#overlay { background: %1; border: 1px solid %2; border-radius: 4px; } "
                           "#overlay QLabel, #overlay QPlainTextEdit, #overlay QToolButton { color: %3; } "
                           "#overlay QPlainTextEdit { background: transparent; border: none; }")
                .arg(background.name(), m_border.name(), ink.name());
        if (style != m_frame.styleSheet()) // our own change comes back as an event
            m_frame.setStyleSheet(style);
    }

    QFrame &m_frame;
    QColor m_background, m_border;
};

} // namespace

void makeOverlay(QFrame &frame, const char *background, const char *border)
{
    frame.setObjectName(QStringLiteral("overlay"));
    frame.setAttribute(Qt::WA_StyledBackground);
    new OverlayColours(frame, QColor(QLatin1String(background)), QColor(QLatin1String(border)));
    frame.hide();
}

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent), m_text(new QLabel), m_all(new PlainTextBox), m_more(new QToolButton), m_close(new QToolButton)
{
    makeOverlay(*this, "#fdeeda", "#d9a35b");
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setAccessibleName(tr("Message"));
    m_close->setText(QStringLiteral("×")); // loading the desktop's icon is slow
    m_close->setAutoRaise(true);
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    m_all->setReadOnly(true);
    m_all->setAccessibleName(tr("The whole message"));
    constexpr int kLines = 10;
    m_all->setFixedHeight(kLines * fontMetrics().lineSpacing());
    m_more->setAutoRaise(true);
    m_more->setCheckable(true);
    m_more->setFocusPolicy(Qt::StrongFocus);
    connect(m_more, &QToolButton::toggled, this, &MessageBar::unfold);
    auto *texts = new QVBoxLayout;
    texts->addWidget(m_text);
    texts->addWidget(m_all);
    texts->addWidget(m_more, 0, Qt::AlignLeft);
    layout->addLayout(texts, 1);
    layout->addWidget(m_close, 0, Qt::AlignTop);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
}

void MessageBar::showMessage(const QString &text)
{
    m_full = text;
    m_all->setPlainText(text);
    m_more->setChecked(false);
    unfold(false);
    show();
    raise();
}

void MessageBar::addMessage(const QString &text)
{
    const bool joins = m_isOfThisMoment && !isHidden();
    if (!std::exchange(m_isOfThisMoment, true))
        QTimer::singleShot(0, this, [this] { m_isOfThisMoment = false; });
    if (!joins)
        showMessage(text);
    else if (!m_full.split(u'\n').contains(text))
        showMessage(m_full + u'\n' + text);
}

void MessageBar::unfold(bool isUnfolded)
{
    constexpr qsizetype kFolded = 3;
    const QStringList lines = m_full.split(u'\n');
    const bool isLong = lines.size() > kFolded + 1; // one line more takes no more room than the button's text
    m_text->setText(isLong ? lines.mid(0, kFolded).join(u'\n') : m_full);
    m_text->setVisible(!isUnfolded);
    m_all->setVisible(isUnfolded);
    m_more->setVisible(isLong);
    m_more->setText(isUnfolded ? tr("Show less") : tr("Show all %1 lines").arg(lines.size()));
    m_more->setToolTip(m_more->text());
}

RecoveryBar::RecoveryBar(QWidget *parent) : QFrame(parent), m_text(new QLabel), m_choice(new QComboBox)
{
    makeOverlay(*this, "#e9f1fa", "#7f9fc4");
    setAccessibleName(tr("Unsaved changes of an earlier session"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_choice->setAccessibleName(tr("Kept scene"));
    m_choice->setToolTip(tr("The kept scenes, the last one first"));
    // A long name must not widen the window.
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(16);
    const auto button = [](const QString &text, const QString &tip) {
        auto *widget = new QPushButton(text);
        widget->setToolTip(tip);
        return widget;
    };
    QPushButton *recover =
        button(tr("&Recover"), tr("Open the scene with these changes; its file stays as it is until you save"));
    QPushButton *discard = button(tr("&Discard"), tr("Delete these changes for good"));
    QPushButton *later = button(tr("&Later"), tr("Keep the changes and ask again at the next start"));

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_choice, 1);
    buttons->addStretch();
    for (QPushButton *each : {recover, discard, later})
        buttons->addWidget(each);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 8, 8);
    layout->addWidget(m_text);
    layout->addLayout(buttons);
    connect(recover, &QPushButton::clicked, this, [this] { emit recoverRequested(m_choice->currentIndex()); });
    connect(discard, &QPushButton::clicked, this, [this] { emit discardRequested(m_choice->currentIndex()); });
    connect(later, &QPushButton::clicked, this, &RecoveryBar::laterRequested);
}

void RecoveryBar::offer(const std::vector<RecoveryInfo> &kept)
{
    m_choice->clear();
    for (const RecoveryInfo &info : kept) {
        m_choice->addItem(tr("%1, %2").arg(info.shownName(), dateText(info.time)));
        m_choice->setItemData(m_choice->count() - 1, plainToolTip(pathText(info.sceneFile)), Qt::ToolTipRole);
    }
    if (kept.empty()) {
        hide();
        return;
    }
    m_choice->setVisible(kept.size() > 1);
    if (kept.size() == 1) {
        const QString name =
            fontMetrics().elidedText(kept.front().shownName(), Qt::ElideMiddle, 60 * fontMetrics().averageCharWidth());
        m_text->setText(tr("The program ended unexpectedly on %1. The unsaved changes to %2 were kept.")
                            .arg(dateText(kept.front().time), name));
        m_text->setToolTip(plainToolTip(pathText(kept.front().sceneFile)));
    } else {
        m_text->setText(tr("The program ended unexpectedly. The unsaved changes to %n scenes were kept:", nullptr,
                           static_cast<int>(kept.size())));
        m_text->setToolTip({});
    }
    show();
    // It takes no focus from the view; screen readers announce it.
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

LoadingBar::LoadingBar(QWidget *parent)
    : QFrame(parent), m_text(new QLabel), m_progress(new QProgressBar), m_cancel(new QPushButton(tr("Cancel"))),
      m_delay(new QTimer(this)), m_emptyDelay(new QTimer(this))
{
    makeOverlay(*this, "#f4f6f8", "#a9b3bd");
    m_text->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, 100);
    constexpr int kDigits = 26;
    m_progress->setMinimumWidth(kDigits * fontMetrics().horizontalAdvance(u'0'));
    m_cancel->setShortcut(Qt::Key_Escape);
    m_cancel->setToolTip(tr("Stop opening and keep the scene as it is (Esc)"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_text);
    layout->addWidget(m_progress, 1);
    layout->addWidget(m_cancel);
    connect(m_cancel, &QPushButton::clicked, this, &LoadingBar::cancelRequested);
    m_delay->setSingleShot(true);
    m_delay->setInterval(150);
    connect(m_delay, &QTimer::timeout, this, [this] {
        show();
        raise();
    });
    constexpr int kHandMilliseconds = 700; // a click already under way cannot be stopped sooner
    m_emptyDelay->setSingleShot(true);
    m_emptyDelay->setInterval(kHandMilliseconds);
    connect(m_emptyDelay, &QTimer::timeout, this, [this] { m_emptyPlace->hide(); });
}

void LoadingBar::start()
{
    m_isOpening = true;
    m_text->setText(tr("Opening …"));
    m_progress->setAccessibleName(tr("Opening"));
    m_progress->setValue(0);
    keepPlaceOfCancel(true);
    m_cancel->show();
    m_delay->start();
}

void LoadingBar::setProgress(const QString &fileName, double share)
{
    m_text->setText(tr("Opening %1").arg(fileName));
    m_progress->setValue(static_cast<int>(std::lround(share * 100.0)));
}

void LoadingBar::finish(bool isDrawn)
{
    m_isOpening = false;
    setDrawn(isDrawn ? 1.0 : 0.0);
}

void LoadingBar::goAway()
{
    m_delay->stop();
    if (isVisible() && parentWidget()) {
        if (!m_emptyPlace)
            m_emptyPlace = new QWidget(parentWidget());
        m_emptyPlace->setGeometry(geometry());
        m_emptyPlace->show();
        m_emptyPlace->raise();
        m_emptyDelay->start();
    }
    hide();
    setMinimumWidth(0);
    keepPlaceOfCancel(false);
}

void LoadingBar::keepPlaceOfCancel(bool isKept)
{
    QSizePolicy policy = m_cancel->sizePolicy();
    policy.setRetainSizeWhenHidden(isKept);
    m_cancel->setSizePolicy(policy);
}

void LoadingBar::setDrawn(double share)
{
    if (m_isOpening)
        return;
    if (share >= 1.0) {
        goAway();
        return;
    }
    if (isVisible())
        setMinimumWidth(width()); // shorter texts don't shrink it under the pointer
    m_text->setText(tr("Drawing …"));
    m_progress->setAccessibleName(tr("Drawing"));
    m_progress->setValue(static_cast<int>(std::lround(share * 100.0)));
    m_cancel->hide(); // a file that is already open cannot be cancelled
    if (isHidden() && !m_delay->isActive())
        m_delay->start();
}

} // namespace unprojector::gui

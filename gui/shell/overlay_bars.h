#pragma once

#include <QFrame>

#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;
class QToolButton;

namespace unprojector::gui {

class PlainTextBox;
struct RecoveryInfo;

/// Makes a frame a bar over the view, hidden at first. It is dark where the window's colours
/// are dark.
/// @param background  with light window colours, "#f4f6f8"
/// @param border      "#a9b3bd"; it tints a dark background
void makeOverlay(QFrame &frame, const char *background, const char *border);

/// A message over the top of the view that stays until it is closed: it reports an error without
/// blocking. Of many lines it shows the first, so that the view stays visible, and the rest on
/// demand.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    void showMessage(const QString &text);
    /// Adds a message to those of the same moment: opening a scan may report its mesh and its
    /// landmarks. Messages of an earlier moment go.
    void addMessage(const QString &text);
    /// The whole text.
    QString text() const { return m_full; }

private:
    void unfold(bool isUnfolded);

    QString m_full;
    bool m_isOfThisMoment = false; ///< whether the shown message was added since the last event
    QLabel *m_text;
    PlainTextBox *m_all; ///< scrolls; shows all lines on demand
    QToolButton *m_more;
    QToolButton *m_close;
};

/// Asks over the top of the view, without blocking, what to do with unsaved changes after an
/// unexpected end.
class RecoveryBar : public QFrame {
    Q_OBJECT
public:
    explicit RecoveryBar(QWidget *parent = nullptr);
    /// Offers these, the first one selected; hides if there are none.
    void offer(const std::vector<RecoveryInfo> &kept);

signals:
    // Emitted with the index of the chosen one among those offered.
    void recoverRequested(int index);
    void discardRequested(int index);
    void laterRequested();

private:
    QLabel *m_text;
    QComboBox *m_choice; ///< shown if there are several
};

/// The progress of opening and then of drawing a file, with a cancel button. It appears after a
/// moment, so that small files don't flash. After it disappears, its area ignores clicks for a
/// moment: a click meant for its button must not hit the view behind.
class LoadingBar : public QFrame {
    Q_OBJECT
public:
    explicit LoadingBar(QWidget *parent = nullptr);
    void start();
    void setProgress(const QString &fileName, double share);
    /// Handles the end of an opening, in any way.
    /// @param isDrawn  nothing is left to report; else setDrawn(1.0) follows
    void finish(bool isDrawn);
    /// @param share  1: it is drawn
    void setDrawn(double share);

signals:
    void cancelRequested();

private:
    void goAway();
    /// Keeps the layout space of the hidden button, so that the rest doesn't move.
    void keepPlaceOfCancel(bool isKept);

    QLabel *m_text;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    bool m_isOpening = false;
    QTimer *m_delay;
    QWidget *m_emptyPlace = nullptr; ///< in the bar's former area; created on demand
    QTimer *m_emptyDelay;
};

} // namespace unprojector::gui

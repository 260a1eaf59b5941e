#pragma once

#include <QFrame>

#include <vector>

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QToolButton;

namespace unprojector::gui {

struct RecoveryInfo;

/// Makes a frame a bar over the view, hidden at first. Its ground is light whatever the window's colours are.
/// @param background, border  as in style sheets: "#f4f6f8"
void makeOverlay(QFrame &frame, const char *background, const char *border);

/// A message over the top of the view that stays until it is closed: it tells what went wrong and stops nothing. Of many lines it
/// shows the first, so that the view stays in sight, and the rest when it is asked for.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    void showMessage(const QString &text);
    /// All of it.
    QString text() const { return m_full; }

private:
    void unfold(bool isUnfolded);

    QString m_full;
    QLabel *m_text;
    QPlainTextEdit *m_all; ///< scrolls, once somebody asks for all lines
    QToolButton *m_more;
    QToolButton *m_close;
};

/// Asks over the top of the view what to do with unsaved changes that an unexpected end has left, and stops nothing.
class RecoveryBar : public QFrame {
    Q_OBJECT
public:
    explicit RecoveryBar(QWidget *parent = nullptr);
    /// Offers these, the first one at first; goes where there are none.
    void offer(const std::vector<RecoveryInfo> &kept);

signals:
    // The index of the chosen one among those offered.
    void recoverRequested(int index);
    void discardRequested(int index);
    void laterRequested();

private:
    QLabel *m_text;
    QComboBox *m_choice; ///< shown where there are several
};

/// What is being opened, how far it is, and a button to stop it; then how much of it is drawn, until it is. Shown after a
/// moment, so that small files don't flash; where it stood, nothing is clicked for a moment once it is gone, so that what
/// was meant for its button does not fall on what is behind.
class LoadingBar : public QFrame {
    Q_OBJECT
public:
    explicit LoadingBar(QWidget *parent = nullptr);
    void start();
    void setProgress(const QString &fileName, double share);
    /// The opening has ended, in whatever way.
    /// @param isDrawn  nothing is left to be told: else setDrawn(1.0) will come
    void finish(bool isDrawn);
    /// @param share  1: it is drawn
    void setDrawn(double share);

signals:
    void cancelRequested();

private:
    void goAway();
    /// A button that is hidden can leave its place empty, so that the rest stays where it is.
    void keepPlaceOfCancel(bool isKept);

    QLabel *m_text;
    QProgressBar *m_progress;
    QPushButton *m_cancel;
    bool m_isOpening = false;
    QTimer *m_delay;
    QWidget *m_emptyPlace = nullptr; ///< where the bar stood; made when it is first needed
    QTimer *m_emptyDelay;
};

} // namespace unprojector::gui

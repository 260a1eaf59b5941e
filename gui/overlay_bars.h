#pragma once

#include <QFrame>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace unprojector {

/// A message over the top of the view that stays until it is closed: it tells what went wrong and stops nothing.
class MessageBar : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    void showMessage(const QString &text);
    QString text() const;

private:
    QLabel *m_text;
    QToolButton *m_close;
};

/// What is being opened, how far it is, and a button to stop it. Shown after a moment, so that small files don't flash.
class LoadingBar : public QFrame {
    Q_OBJECT
public:
    explicit LoadingBar(QWidget *parent = nullptr);
    void start();
    void setProgress(const QString &fileName, double share);
    void finish();

signals:
    void cancelRequested();

private:
    QLabel *m_text;
    QProgressBar *m_progress;
    QTimer *m_delay;
};

} // namespace unprojector

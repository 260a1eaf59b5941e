#pragma once

#include <QWidget>

#include <functional>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class SceneDocument;

/// Which point is placed next, in large letters, and where that is. Only there while one waits.
class NextPointBar : public QWidget {
    Q_OBJECT
public:
    /// What is known of where a point of a name is; empty: nothing.
    using Hint = std::function<QString(const QString &name)>;

    NextPointBar(SceneDocument &document, Hint hint, QWidget *parent = nullptr);

    /// Shows what waits now; to be called where hints have changed.
    void refresh();

protected:
    void changeEvent(QEvent *event) override;

private:
    void useFonts();

    SceneDocument &m_document;
    Hint m_hint;
    QLabel *m_name;
    QLabel *m_where;
    QLabel *m_count;
    QToolButton *m_skip;
};

} // namespace unprojector::gui

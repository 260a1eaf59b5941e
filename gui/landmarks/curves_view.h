#pragma once

#include "core/landmarks/landmark.h"

#include <QWidget>

#include <cstddef>
#include <optional>

class QLabel;
class QToolButton;
class QTreeWidget;
class QVariant;

namespace unprojector::gui {

class SceneDocument;

/// The curves of a document: the landmarks that each joins, its kind, number of semilandmarks and
/// length. It is hidden without curves and messages.
class CurvesView : public QWidget {
    Q_OBJECT
public:
    explicit CurvesView(SceneDocument &document, QWidget *parent = nullptr);

    /// Joins the selected landmarks; placed beside their list.
    QToolButton *joinButton() const { return m_join; }
    /// Commits pending input, as Enter does.
    void applyTyped();
    /// Joins the selected landmarks, or shows why it can't. Digits typed next set the number of
    /// semilandmarks.
    void join(landmarks::CurveKind kind);

signals:
    /// Emitted when the list appears or disappears.
    void shownOrHidden();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    /// @param reason  why an input or a request is rejected; empty: clears the message
    void say(const QString &reason);
    void showRows();
    void showLengths();
    /// Limits the list's height to its rows.
    void fitHeight();
    void apply(int row, int column, const QVariant &typed);
    void showMenu(const QPoint &place);
    void removeCurrent();
    std::optional<std::size_t> current() const;

    SceneDocument &m_document;
    QTreeWidget *m_rows;
    QLabel *m_reason;
    QToolButton *m_join;
};

} // namespace unprojector::gui

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

/// The curves of a document: the points that each joins, how it goes, on how many semilandmarks, how long it is. It is hidden while
/// there are none and nothing is to be said.
class CurvesView : public QWidget {
    Q_OBJECT
public:
    explicit CurvesView(SceneDocument &document, QWidget *parent = nullptr);

    /// Joins the points that are selected; to be put where these are listed.
    QToolButton *joinButton() const { return m_join; }
    /// What is being typed counts, as if Enter were pressed.
    void applyTyped();
    /// Joins the points that are selected, or says why not. Digits that are typed next are its number of semilandmarks.
    void join(landmarks::CurveKind kind);

signals:
    /// There is a list now, or none any more.
    void shownOrHidden();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    /// @param reason  why something typed or asked for is refused; empty: it is not
    void say(const QString &reason);
    void showRows();
    void showLengths();
    /// The list takes no more room than its rows need.
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

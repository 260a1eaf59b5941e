#pragma once

#include <QWidget>

#include <filesystem>
#include <functional>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class SceneDocument;

/// Which point is placed next, in large letters, where that is, and the template's picture of it. Only there while one waits.
class NextLandmarkBar : public QWidget {
    Q_OBJECT
public:
    /// What is known of where a point of a name is; empty: nothing.
    using Hint = std::function<QString(const QString &name)>;

    /// The file of a picture of a point of a name; empty: none.
    using Picture = std::function<std::filesystem::path(const QString &name)>;

    /// Whether a point of a name is of the template that is gone through.
    using IsOfTemplate = std::function<bool(const QString &name)>;

    NextLandmarkBar(SceneDocument &document, Hint hint, Picture picture, IsOfTemplate isOfTemplate,
                    QWidget *parent = nullptr);

    /// Whether a click in the view places it; else it is said how.
    void setPlacing(bool isPlacing);
    /// Shows what waits now; to be called where hints have changed.
    void refresh();

protected:
    void changeEvent(QEvent *event) override;

private:
    void useFonts();
    void showPicture(const std::filesystem::path &file);

    SceneDocument &m_document;
    Hint m_hint;
    Picture m_picture;
    IsOfTemplate m_isOfTemplate;
    std::filesystem::path m_shownPicture;
    QLabel *m_name;
    QLabel *m_how;
    QLabel *m_where;
    QLabel *m_drawing;
    QLabel *m_count;
    QToolButton *m_skip;
};

} // namespace unprojector::gui

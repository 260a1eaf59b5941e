#pragma once

#include <QWidget>

#include <filesystem>
#include <functional>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class SceneDocument;

/// The landmark to place next: its name in large letters, its hint, and the template's image.
/// Visible only while there is one.
class NextLandmarkBar : public QWidget {
    Q_OBJECT
public:
    /// Returns the hint for a landmark name; empty: none.
    using Hint = std::function<QString(const QString &name)>;

    /// Returns the file of an image for a landmark name; empty: none.
    using Picture = std::function<std::filesystem::path(const QString &name)>;

    /// Returns whether a landmark name belongs to the chosen template.
    using IsOfTemplate = std::function<bool(const QString &name)>;

    NextLandmarkBar(SceneDocument &document, Hint hint, Picture picture, IsOfTemplate isOfTemplate,
                    QWidget *parent = nullptr);

    /// Sets whether a click in the view places it; otherwise the bar explains how.
    void setPlacing(bool isPlacing);
    /// Shows the present next landmark. Call it after hints have changed.
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

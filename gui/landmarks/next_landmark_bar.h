#pragma once

#include <QWidget>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class SceneDocument;

/// The landmark to place next: its name in large letters, its hint, the template's image, and how
/// many are placed. Visible while there is one, and after the last one until the list changes. It
/// keeps the height that the longest name and hint of the list need: the rows below stay where they
/// are.
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
    /// Shows the present next landmark, after hints have changed.
    void refresh();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void useFonts();
    void showNext();
    static QString howText(bool isDone, bool isPlacing);
    void showHow();
    void showDone();
    void showPicture(const std::filesystem::path &file);
    /// The side of the square that an image fits into.
    int pictureSide() const;
    /// Computes the heights that the names, hints and images of the list need at the present width.
    void reserveRoom();
    QString nextText(std::size_t index) const;
    void showCount();

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
    QToolButton *m_missing;
    std::vector<std::string> m_names; ///< those that the room was computed for
    std::size_t m_listed = 0;         ///< number of landmarks when they were last shown
    bool m_hasNext = false;           ///< at that time
    bool m_isDone = false;            ///< all of the list have been placed
    bool m_isPlacing = false;
};

} // namespace unprojector::gui

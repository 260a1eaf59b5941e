#pragma once

#include <QObject>
#include <QToolButton>

#include <functional>

class QUrl;

namespace unprojector::gui {

/// A small "?" beside a computed value: it opens the help at its formulas.
class HelpLink : public QToolButton {
    Q_OBJECT
public:
    /// @param anchor  a name in formulas.html: "ortho"
    explicit HelpLink(const QString &anchor, QWidget *parent = nullptr);

    const QString &anchor() const { return m_anchor; }
    void setAnchor(const QString &anchor) { m_anchor = anchor; }

private:
    QString m_anchor;
};

/// Opens the help at an anchor, by the current HelpOpener.
void openHelp(const QString &anchor);

/// Handles the links to the help, in labels too (helpAddress), while it lives or until another one
/// is created.
class HelpOpener : public QObject {
    Q_OBJECT
public:
    /// @param open  receives the anchor
    HelpOpener(std::function<void(const QString &)> open, QObject *parent);
    ~HelpOpener() override;

public slots:
    void openUrl(const QUrl &url);

private:
    std::function<void(const QString &)> m_open;
};

} // namespace unprojector::gui

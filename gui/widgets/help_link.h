#pragma once

#include <QObject>
#include <QToolButton>

#include <functional>

class QUrl;

namespace unprojector::gui {

/// A small "?" beside what is computed: it opens Help where its formulas are.
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

/// Shows a place of Help, through whoever has taken it over.
void openHelp(const QString &anchor);

/// Takes over the links to Help, those of labels too (helpAddress), for as long as it lives or until another one does.
class HelpOpener : public QObject {
    Q_OBJECT
public:
    /// @param open  given the anchor
    HelpOpener(std::function<void(const QString &)> open, QObject *parent);
    ~HelpOpener() override;

public slots:
    void openUrl(const QUrl &url);

private:
    std::function<void(const QString &)> m_open;
};

} // namespace unprojector::gui

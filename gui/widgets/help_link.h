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
/// Opens the manual by the current HelpOpener.
/// @param place  "pipeline.md#viewport"; empty: its first page
void openManual(const QString &place);

/// Opens all links to Help and to the manual, also links in labels (helpAddress, manualAddress). It
/// is active until it is destroyed or another opener is created.
class HelpOpener : public QObject {
    Q_OBJECT
public:
    using Open = std::function<void(const QString &)>;
    /// @param open        given the anchor
    /// @param openManual  given the place
    HelpOpener(Open open, Open openManual, QObject *parent);
    ~HelpOpener() override;

public slots:
    void openUrl(const QUrl &url);

private:
    Open m_open, m_openManual;
};

} // namespace unprojector::gui

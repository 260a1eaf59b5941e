#include "gui/shell/about_dialog.h"

#include "gui/widgets/copy_menu.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace unprojector::gui {

AboutDialog::AboutDialog(const QString &openGL, const QString &note, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("About Unprojector"));
    m_versions = QStringLiteral("Unprojector %1\nQt %2 (%3)\nOpenGL: %4\n%5, %6")
                     .arg(QStringLiteral(UNPROJECTOR_VERSION), QLatin1String(qVersion()),
                          QGuiApplication::platformName(), openGL.isEmpty() ? tr("not started") : openGL,
                          QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture());
    auto *what = new QLabel(tr("Click a pixel of a 3-D view and get its world coordinate, computed twice: by the "
                               "closed-form inverse formulas of Weng, Huang and Cai (2008) and by the inverted matrix. "
                               "The window shows the difference, its cause and the uncertainty of the coordinate."));
    auto *versions = new QLabel(m_versions);
    versions->setTextFormat(Qt::PlainText);
    versions->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    versions->setAccessibleName(tr("Versions"));
    auto *layout = new QVBoxLayout(this);
    for (QLabel *label : {what, new QLabel(note), versions, new QLabel(tr("MIT licence."))}) {
        if (label->text().isEmpty()) {
            delete label;
            continue;
        }
        label->setWordWrap(true);
        layout->addWidget(label);
    }
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton *copy = buttons->addButton(tr("&Copy Versions"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copy the versions, for a report"));
    connect(copy, &QPushButton::clicked, this, [this] { copyToClipboard(m_versions); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    constexpr int kDigits = 64;
    setMinimumWidth(kDigits * fontMetrics().horizontalAdvance(u'0'));
}

} // namespace unprojector::gui

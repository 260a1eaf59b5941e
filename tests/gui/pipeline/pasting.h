#pragma once

#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "gui/document/camera_looks.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/pipeline/paste_choices_form.h"
#include "gui/widgets/plain_text_box.h"
#include "tests/support/patience.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

namespace guitest {

/// The dialog that pastes a camera, on the screen, and hands on it.
struct Pasting {
    unprojector::gui::SceneDocument document;
    std::unique_ptr<unprojector::gui::PasteCameraDialog> dialog;

    Pasting()
    {
        document.setSurface(unprojector::geometry::surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        dialog = std::make_unique<unprojector::gui::PasteCameraDialog>(document);
        dialog->show();
        if (!QTest::qWaitForWindowExposed(dialog.get(), kPatienceMilliseconds))
            qFatal("The dialog is not shown.");
    }
    unprojector::gui::PlainTextBox *text() const { return dialog->findChild<unprojector::gui::PlainTextBox *>(); }
    /// Pastes as a user does: by the clipboard and the keyboard.
    void paste(const QString &pasted) const
    {
        text()->setFocus();
        text()->selectAll();
        QGuiApplication::clipboard()->setText(pasted);
        QTest::keySequence(text(), QKeySequence::Paste);
    }
    /// @return null unless it is visible
    template <class Widget>
    Widget *named(const char *name) const
    {
        for (Widget *widget : dialog->findChildren<Widget *>()) {
            if (widget->accessibleName() == QLatin1String(name) && widget->isVisible())
                return widget;
        }
        return nullptr;
    }
    QAbstractButton *button(const QString &words) const
    {
        for (QAbstractButton *button : dialog->findChildren<QAbstractButton *>()) {
            if (button->text().remove(u'&') == words && button->isVisible())
                return button;
        }
        return nullptr;
    }
    void type(const char *name, const QString &typed) const
    {
        auto *field = named<QLineEdit>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, typed);
    }
    void choose(const char *name, int index) const
    {
        auto *combo = named<QComboBox>(name);
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }
    QPushButton *ok() const { return dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok); }
    QTextBrowser *report() const { return dialog->findChild<QTextBrowser *>(); }
    bool says(const QString &words) const
    {
        const QString all = report()->toPlainText();
        if (!all.contains(words))
            qWarning("It says: %s", qPrintable(all));
        return all.contains(words);
    }
    /// Follows a link of the report. Returns whether it has one.
    bool click(const QString &words) const
    {
        const QTextDocument &page = *report()->document();
        for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
            for (auto at = block.begin(); !at.atEnd(); ++at) {
                const QTextFragment fragment = at.fragment();
                if (fragment.text() == words && fragment.charFormat().isAnchor()) {
                    emit report()->anchorClicked(QUrl(fragment.charFormat().anchorHref()));
                    return true;
                }
            }
        }
        return false;
    }
    /// The pixel of a world point in the document's view, from the corner of the image.
    glm::dvec2 pixelOf(const glm::dvec3 &world) const
    {
        const unprojector::geometry::Setup &setup = document.setup();
        const auto window = windowFromWorld(setup, unprojector::geometry::WorldPoint(world));
        const auto at = deviceFromWindow(setup.surface, *window);
        return {at.x, at.y};
    }
};

} // namespace guitest

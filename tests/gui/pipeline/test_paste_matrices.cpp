// Matrices of other programs, pasted into the real dialog: read in every usual form, and repaired
// by a finding's button. The scene changes in one step; its file keeps the matrices as given.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "core/scene_file/scene_file.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/pipeline/pasted_matrix_box.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/translation.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/plain_text_box.h"
#include "tests/support/patience.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::scene_file;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

glm::dmat4 lens()
{
    return glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0);
}

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
}

QString number(double value)
{
    return QString::number(value, 'g', 17);
}

/// The entries one after the other, four of them in a pair of brackets or in a line.
QString fours(const glm::dmat4 &m, bool areRows, const QString &separator, const QString &open, const QString &close,
              const QString &between)
{
    QStringList groups;
    for (int i = 0; i < 4; ++i) {
        QStringList numbers;
        for (int j = 0; j < 4; ++j)
            numbers << number(areRows ? m[j][i] : m[i][j]);
        groups << open + numbers.join(separator) + close;
    }
    return groups.join(between);
}

/// The matrix as the programs print it.
QString printed(const glm::dmat4 &m, const QString &form)
{
    if (form == "glm::to_string")
        return "dmat4x4(" + fours(m, false, ", ", "(", ")", ", ") + ")";
    if (form == "NumPy")
        return "[" + fours(m, true, "  ", "[", "]", "\n ") + "]";
    if (form == "Eigen")
        return fours(m, true, "   ", "", "", "\n");
    if (form == "QMatrix4x4")
        return "QMatrix4x4(type:General\n" + fours(m, true, "  ", "  ", "", "\n") + "\n)";
    if (form == "JSON")
        return "[" + fours(m, false, ", ", "", "", ", ") + "]";
    if (form == "C")
        return "const double m[16] = {\n" + fours(m, false, ", ", "    ", "", ",\n") + "\n};";
    if (form == "three.js")
        return R"({"elements":[)" + fours(m, false, ",", "", "", ",") + "]}";
    QString text; // m[0] to m[15]
    for (int i = 0; i < 16; ++i)
        text += QStringLiteral("m[%1] = %2\n").arg(i).arg(number(m[i / 4][i % 4]));
    return text;
}

double difference(const glm::dmat4 &a, const glm::dmat4 &b)
{
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return largest;
}

/// A dialog on the screen, and hands on it.
struct Pasting {
    SceneDocument document;
    PasteCameraDialog dialog{document};

    Pasting()
    {
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        dialog.show();
        if (!QTest::qWaitForWindowExposed(&dialog, kPatienceMilliseconds))
            qFatal("The dialog is not shown.");
    }
    PastedMatrixBox *box(MatrixRole role) const
    {
        const QList<PastedMatrixBox *> boxes = dialog.findChildren<PastedMatrixBox *>();
        return boxes.at(role == MatrixRole::Projection ? 0 : role == MatrixRole::View ? 1 : 2);
    }
    /// Pastes as a user does: by the clipboard and the keyboard.
    void paste(MatrixRole role, const QString &text) const
    {
        if (role == MatrixRole::Product)
            button("Product")->click();
        auto *edit = box(role)->findChild<QPlainTextEdit *>();
        edit->setFocus();
        edit->selectAll();
        QGuiApplication::clipboard()->setText(text);
        QTest::keySequence(edit, QKeySequence::Paste);
    }
    QAbstractButton *button(const QString &text) const
    {
        for (QAbstractButton *button : dialog.findChildren<QAbstractButton *>()) {
            if (button->text() == text && button->isVisible())
                return button;
        }
        return nullptr;
    }
    QPushButton *ok() const { return dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok); }
    bool says(const QString &text) const
    {
        QStringList all;
        for (const QLabel *label : dialog.findChildren<QLabel *>()) {
            if (label->isVisible())
                all << label->text();
        }
        if (all.join('\n').contains(text))
            return true;
        qWarning("It says: %s", qPrintable(all.join('\n')));
        return false;
    }
    /// The product of the scene's own camera.
    glm::dmat4 shownProduct() const { return *clipFromWorld(document.setup()); }
};

/// The document's file, written and read again, without its objects.
SceneFile saved(const SceneDocument &document)
{
    SceneFile file = sceneFileFrom(document.scene(), document.setup(), {});
    file.objects.clear();
    return parseScene(*sceneText(file), "saved").value();
}

} // namespace

/// A box whose protected functions the clipboard and the pointer call.
class OpenBox : public PlainTextBox {
public:
    using PlainTextBox::canInsertFromMimeData;
    using PlainTextBox::insertFromMimeData;
};

class TestPasteMatrices : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void everyPrintedFormIsTaken_data()
    {
        addColumn<QString>("form");
        for (const char *form :
             {"glm::to_string", "NumPy", "Eigen", "QMatrix4x4", "JSON", "C", "three.js", "m[0] to m[15]"})
            newRow(form) << form;
    }

    void everyPrintedFormIsTaken()
    {
        QFETCH(QString, form);
        Pasting pasting;
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.paste(MatrixRole::Projection, printed(lens(), form));
        pasting.paste(MatrixRole::View, printed(view(), form));
        QVERIFY(pasting.says("Eye at (3, 2, 5)"));
        QVERIFY(pasting.says("near 2, far 50"));
        QVERIFY(pasting.ok()->isEnabled());
        pasting.ok()->click();
        QVERIFY(!pasting.dialog.isVisible());
        QCOMPARE(pasting.document.scene().projection.matrix()->clipFromEye, lens());
        QCOMPARE(*pasting.document.scene().camera.matrix(), view());
        QVERIFY(difference(pasting.shownProduct(), lens() * view()) <= 1e-13);
    }

    void oneTextMayHaveBoth_data()
    {
        addColumn<MatrixRole>("role");
        addColumn<QString>("text");
        const QString view_ = printed(view(), "NumPy"), lens_ = printed(lens(), "NumPy");
        newRow("named, in the projection's place")
            << MatrixRole::Projection << "view = " + view_ + "\nprojection = " + lens_;
        newRow("named, in the view's place") << MatrixRole::View << "projection: " + lens_ + "\nmodelview: " + view_;
        newRow("unnamed, as glGet gives them") << MatrixRole::View << view_ + "\n" + lens_;
        newRow("with an inverse too many") << MatrixRole::Projection
                                           << "view = " + view_ + "\nprojection = " + lens_
                                                  + "\nviewInverse = " + printed(glm::inverse(view()), "NumPy");
        newRow("with a viewport") << MatrixRole::View << view_ + "\n" + lens_ + "\nviewport: QRect(0,0 300x200)";
    }

    void oneTextMayHaveBoth()
    {
        QFETCH(MatrixRole, role);
        QFETCH(QString, text);
        Pasting pasting;
        pasting.paste(role, text);
        if (text.contains("viewport"))
            QVERIFY(pasting.says("The viewport, 300 × 200, is ignored"));
        QCOMPARE(pasting.says("The pasted text also has the inverse of this matrix. It is ignored."),
                 text.contains("viewInverse"));
        pasting.ok()->click();
        QVERIFY(difference(pasting.shownProduct(), lens() * view()) <= 1e-13);
    }

    void theProductAloneIsTakenApart()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Product, printed(lens() * view(), "glm::to_string"));
        QVERIFY(pasting.says("Decomposed into projection and view"));
        pasting.ok()->click();
        QVERIFY(difference(pasting.shownProduct(), lens() * view()) <= 1e-12);

        Pasting ofBox;
        const glm::dmat4 box = glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 9.0);
        ofBox.paste(MatrixRole::Product, printed(box * view(), "NumPy"));
        QVERIFY(ofBox.says("it is put on the near plane"));
        ofBox.ok()->click();
        QVERIFY(difference(ofBox.shownProduct(), box * view()) <= 1e-12);
    }

    void everyFindingHasItsButton_data()
    {
        addColumn<MatrixRole>("role");
        addColumn<glm::dmat4>("given");
        addColumn<QString>("sentence");
        addColumn<QString>("button");
        addColumn<glm::dmat4>("expected"); ///< the projection or view that the scene keeps
        const auto scaling = [](double x, double y, double z) {
            return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
        };
        using enum MatrixRole;
        newRow("an inverse") << Projection << glm::inverse(lens()) << "is an inverse"
                             << "Invert" << lens();
        newRow("the camera's matrix") << View << glm::inverse(view()) << "may be the inverse of a view"
                                      << "Invert" << view();
        newRow("Vulkan's y") << Projection << scaling(1, -1, 1) * lens() << "flips y"
                             << "Flip y" << lens();
        newRow("mirrored") << Projection << scaling(-1, 1, 1) * lens() << "mirrors x"
                           << "Flip x" << lens();
        newRow("a mirrored view") << View << scaling(-1, 1, 1) * view() << "is mirrored"
                                  << "Flip x" << view();
        newRow("a scaled view") << View << view() * scaling(2, 2, 2) << "scales by 2"
                                << "Remove the Scale" << view();
        newRow("negated") << Projection << -lens() << "negated"
                          << "Negate" << lens();
        newRow("along +z") << Projection << lens() * scaling(1, 1, -1) << "looks along +z"
                           << "Turn to −z" << lens();
        glm::dmat4 zeroToOne = lens();
        zeroToOne[2][2] = -50.0 / 48.0;
        zeroToOne[3][2] = -100.0 / 48.0;
        newRow("depths in [0, 1]") << Projection << zeroToOne << "seems to use NDC depths from 0 to 1"
                                   << "Read as 0 to 1" << zeroToOne;
        newRow("exchanged") << Projection << view() << "seem to be swapped"
                            << "Swap Them" << view();
    }

    void everyFindingHasItsButton()
    {
        QFETCH(MatrixRole, role);
        QFETCH(glm::dmat4, given);
        QFETCH(QString, sentence);
        QFETCH(QString, button);
        QFETCH(glm::dmat4, expected);
        Pasting pasting;
        const bool isExchanged = button == "Swap Them";
        if (role == MatrixRole::View)
            pasting.paste(MatrixRole::Projection, printed(lens(), "JSON"));
        else if (!isExchanged)
            pasting.paste(MatrixRole::View, printed(view(), "JSON"));
        pasting.paste(role, printed(given, "JSON"));
        QVERIFY(pasting.says(sentence));
        QVERIFY(role != MatrixRole::View || button != "Flip x" || pasting.says("its axes are left-handed; negate"));
        QVERIFY(pasting.button(button));
        pasting.button(button)->click();
        QVERIFY(!pasting.button(button));
        QVERIFY(pasting.ok()->isEnabled());
        pasting.ok()->click();
        if (role == MatrixRole::View || isExchanged) {
            QVERIFY(difference(*pasting.document.scene().camera.matrix(), expected) <= 1e-12);
            return;
        }
        if (button == "Turn to −z") { // with the view, whose product stays
            QVERIFY(difference(pasting.shownProduct(), given * view()) <= 1e-12);
            return;
        }
        QVERIFY(difference(pasting.document.scene().projection.matrix()->clipFromEye, expected) <= 1e-12);
        if (button == "Read as 0 to 1")
            QVERIFY(std::abs(projectionWindow(pasting.document.setup().projection()).nearDistance - 2.0) <= 1e-12);
    }

    void theOrderIsToldByTheNumbers()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, printed(glm::transpose(lens()), "NumPy"));
        pasting.paste(MatrixRole::View, printed(glm::transpose(view()), "NumPy"));
        QVERIFY(pasting.says("It is read in the order, by rows or by columns, that makes it a projection."));
        QVERIFY(pasting.says("It is read in the order, by rows or by columns, that makes 0 0 0 1 its last row."));
        // The other order can be had all the same.
        pasting.button("Read as Row-major")->click();
        QTRY_VERIFY_WITH_TIMEOUT(pasting.says("looks transposed"), kPatienceMilliseconds);
        pasting.button("As Pasted")->click();
        pasting.ok()->click();
        QVERIFY(difference(pasting.document.scene().projection.matrix()->clipFromEye, lens()) <= 1e-12);
        QVERIFY(difference(*pasting.document.scene().camera.matrix(), view()) <= 1e-12);
    }

    void anOrderThatNothingTellsIsAskedFor()
    {
        const glm::dmat4 turn{glm::dmat3(view())};
        Pasting pasting;
        pasting.paste(MatrixRole::View, printed(glm::transpose(turn), "NumPy"));
        QVERIFY(pasting.says("It is a camera's matrix by rows and by columns"));
        pasting.button("Read as Column-major")->click();
        QVERIFY(!pasting.button("Read as Column-major"));
        pasting.ok()->click();
        QVERIFY(difference(*pasting.document.scene().camera.matrix(), turn) <= 1e-12);
    }

    void theDepthsCanBeSaid()
    {
        // Near has many digits in either order: only the user can tell the two apart.
        constexpr double kNear = 1.23457, kFar = 87.6543;
        glm::dmat4 zeroToOne = glm::frustum(-1.0, 1.0, -0.75, 0.75, kNear, kFar);
        zeroToOne[2][2] = -kFar / (kFar - kNear);
        zeroToOne[3][2] = -kFar * kNear / (kFar - kNear);
        const auto nearOf = [](const Pasting &pasting) {
            return projectionWindow(pasting.document.setup().projection()).nearDistance;
        };
        Pasting pasting;
        QVERIFY(!pasting.button("0 to 1")->isEnabled());
        pasting.paste(MatrixRole::Projection, printed(zeroToOne, "JSON"));
        QVERIFY(!pasting.button("Read as 0 to 1"));
        QVERIFY(pasting.button("By default")->isChecked());
        pasting.button("0 to 1")->click();
        QVERIFY(pasting.says("near 1.2346, far 87.654"));
        pasting.ok()->click();
        QVERIFY(std::abs(nearOf(pasting) - kNear) <= 1e-12);
        QCOMPARE(pasting.document.scene().projection.matrix()->ndcDepth, std::optional(NdcDepth::ZeroToOne));
        // The switch also undoes a repair that was offered and done.
        Pasting offered;
        glm::dmat4 round = zeroToOne;
        round[2][2] = -50.0 / 48.0;
        round[3][2] = -100.0 / 48.0;
        offered.paste(MatrixRole::Projection, printed(round, "JSON"));
        offered.button("Read as 0 to 1")->click();
        QVERIFY(offered.button("0 to 1")->isChecked());
        offered.button("−1 to 1")->click();
        QVERIFY(!offered.button("As Pasted"));
        offered.ok()->click();
        QCOMPARE(offered.document.scene().projection.matrix()->ndcDepth, std::optional(NdcDepth::MinusOneToOne));
    }

    void theScenesOwnStaysWithoutOne()
    {
        Pasting pasting;
        const LookAt camera = pasting.document.setup().camera();
        pasting.paste(MatrixRole::Projection, printed(lens(), "C"));
        pasting.ok()->click();
        QCOMPARE(pasting.document.setup().camera(), camera);
        QVERIFY(!pasting.document.scene().camera.matrix());
    }

    void whatIsNoMatrixIsSaid_data()
    {
        addColumn<MatrixRole>("role");
        addColumn<QString>("text");
        addColumn<QString>("message");
        using enum MatrixRole;
        glm::dmat4 shear(1.0);
        shear[2][0] = 0.5;
        const QString zeros = QStringLiteral("0 ").repeated(16);
        newRow("words") << View << "no matrix at all"
                        << "0 numbers found, 16 are needed.";
        newRow("one short") << View << "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0"
                            << "15 numbers found, 16 are needed.";
        newRow("one number") << View << "7"
                             << "\n1 number found, 16 are needed.";
        newRow("half a viewport") << Projection << "projection " + zeros + " viewport 100 100"
                                  << "Viewport: 2 numbers found, 4 are needed: x y width height, or 16 of a matrix.";
        newRow("NaN") << Projection << "1 0 0 0\n0 nan 0 0\n"
                      << "In line 2, column 3: \"nan\" is not a finite number.";
        newRow("no projection among them")
            << Projection << "view " + zeros + " model " + zeros << "no matrix of this kind";
        newRow("no inverse") << View << zeros << "Not a camera: the view matrix is not rotation + translation";
        newRow("an inverse without one") << View << "viewInverse " + zeros << "but it is singular";
        newRow("a sheared box's product")
            << Product << printed(glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 9.0) * shear * view(), "JSON")
            << "cannot be decomposed";
    }

    void whatIsNoMatrixIsSaid()
    {
        QFETCH(MatrixRole, role);
        QFETCH(QString, text);
        QFETCH(QString, message);
        Pasting pasting;
        pasting.paste(role, text);
        QVERIFY(pasting.says(message));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.dialog.accept();
        QVERIFY(pasting.dialog.isVisible());
        QCOMPARE(pasting.document.undoStack().count(), 0);
    }

    void callsAreTaken()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, "glViewport(10, 20, 300, 200);\nglFrustum(-1, 1, -0.75, 0.75, 2, 50);\n"
                                              "gluLookAt(3, 2, 5, 0, 0, 0, 0, 1, 0);");
        QVERIFY(pasting.says("glFrustum: left -1, right 1, bottom -0.75, top 0.75, near 2, far 50."));
        QVERIFY(pasting.says("From the other text: gluLookAt: eye (3, 2, 5), center (0, 0, 0), up (0, 1, 0)."));
        QVERIFY(pasting.says("The viewport is set by glViewport: 300 × 200 at (10, 20)."));
        pasting.ok()->click();
        QVERIFY(difference(pasting.shownProduct(), lens() * view()) <= 1e-13);
        QCOMPARE(pasting.document.setup().viewport, (Viewport{10.0, 20.0, 300.0, 200.0}));
        QCOMPARE(pasting.document.undoStack().count(), 1);
    }

    void aCallThatCannotBeReadIsNamed()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, "gluPerspective(45, aspect, 0.1, 100)");
        QVERIFY(pasting.says("gluPerspective: the argument 'aspect' is not a number. Put its value there."));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.paste(MatrixRole::Projection, "gluPerspective(45, 1.5, 0.1, 100)");
        QVERIFY(pasting.says("Empty: the scene's view is kept."));
        QVERIFY(pasting.ok()->isEnabled());
    }

    void aNamedProductIsMovedToItsPlace()
    {
        Pasting pasting;
        const QString text = "mvp = " + printed(lens() * view(), "NumPy");
        pasting.paste(MatrixRole::Projection, text);
        QVERIFY(pasting.button("Read as product"));
        pasting.button("Read as product")->click();
        QVERIFY(!pasting.button("Read as product"));
        QCOMPARE(pasting.box(MatrixRole::Product)->text(), text);
        QVERIFY(pasting.box(MatrixRole::Projection)->text().isEmpty());
        QVERIFY(pasting.says("Decomposed into projection and view"));
        // Calls without a product can be read back as projection and view.
        pasting.paste(MatrixRole::Product,
                      "gluLookAt(3, 2, 5, 0, 0, 0, 0, 1, 0)\nglFrustum(-1, 1, -0.75, 0.75, 2, 50)");
        QVERIFY(pasting.says("The text has no product."));
        pasting.button("Read as projection and view")->click();
        pasting.ok()->click();
        QVERIFY(difference(pasting.shownProduct(), lens() * view()) <= 1e-13);
    }

    void theCountIsThatOfTheMatrix()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, "view: " + printed(view(), "NumPy") + "\nprojection: 1.5 2");
        QVERIFY(pasting.says("Projection: 2 of the 18 numbers in the text belong to it; a matrix has 16."));
    }

    void noFindingIsCut_data()
    {
        addColumn<double>("points");
        addColumn<bool>("isChinese");
        for (const double points : {9.0, 13.0}) {
            for (const bool isChinese : {false, true})
                addRow("%g pt, %s", points, isChinese ? "Chinese" : "English") << points << isChinese;
        }
    }

    /// The Vulkan conventions cause two findings, and the view has one.
    void noFindingIsCut()
    {
        QFETCH(double, points);
        QFETCH(bool, isChinese);
        const QFont before = QApplication::font();
        QFont font = before;
        font.setPointSizeF(points);
        QApplication::setFont(font);
        const Translation translation(isChinese ? QStringList{QStringLiteral("zh-CN")} : QStringList());
        const auto back = qScopeGuard([&before] { QApplication::setFont(before); });
        glm::dmat4 vulkan = lens();
        vulkan[1][1] = -vulkan[1][1];
        vulkan[2][2] = -50.0 / 48.0;
        vulkan[3][2] = -100.0 / 48.0;
        Pasting pasting;
        constexpr QSize kScreen(1280, 800);
        pasting.dialog.resize(pasting.dialog.size().boundedTo(kScreen - QSize(0, 340))); // it grows
        const auto paste = [&pasting](MatrixRole role, const glm::dmat4 &matrix) {
            pasting.box(role)->setText(printed(matrix, "NumPy"));
        };
        paste(MatrixRole::Projection, vulkan);
        paste(MatrixRole::View, view() * glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
        for (int level = 0; level < 6; ++level) // a layout that grows asks the one around it, level by level
            QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        const QStringList cut = cutTexts(pasting.dialog);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        QCOMPARE(pasting.dialog.findChild<QScrollArea *>()->verticalScrollBar()->maximum(), 0);
        QVERIFY(pasting.dialog.height() <= kScreen.height());
    }

    void oneStepIsUndone()
    {
        Pasting pasting;
        const Setup before = pasting.document.setup();
        // Reversed, with its far plane at infinity, near 2.
        glm::dmat4 reversed = lens();
        reversed[2][2] = 0.0;
        reversed[3][2] = 2.0;
        pasting.paste(MatrixRole::Projection, printed(reversed, "JSON"));
        pasting.paste(MatrixRole::View, printed(view(), "JSON"));
        QVERIFY(pasting.says("It has reversed depths") && pasting.says("far plane at infinity"));
        pasting.ok()->click();
        SceneDocument &document = pasting.document;
        QCOMPARE(document.setup().depthRange, (DepthRange{1.0, 0.0}));
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Paste Camera"));
        // The next one is not reversed: the depth range is as it was.
        QVERIFY(editMatrices(document, MatrixProjection{lens(), std::nullopt}, std::nullopt, {"again"}));
        QCOMPARE(document.setup().depthRange, DepthRange{});
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.setup(), before);
        QVERIFY(!document.scene().projection.matrix() && !document.scene().camera.matrix());
        document.undoStack().redo();
        QCOMPARE(document.scene().projection.matrix()->clipFromEye, reversed);
    }

    void theSameTextGivesTheSameDepths()
    {
        Pasting pasting;
        SceneDocument &document = pasting.document;
        glm::dmat4 reversed = lens();
        reversed[2][2] = 0.0;
        reversed[3][2] = 2.0;
        const auto paste = [&document](const glm::dmat4 &matrix) {
            return editMatrices(document, MatrixProjection{matrix, std::nullopt}, std::nullopt, {"Paste"}).hasValue();
        };
        const auto changeProjection = [&document] {
            const Projection other = Ortho{-1.0, 1.0, -1.0, 1.0, 1.0, 9.0};
            return editProjection(document, {other, false, false}, {"Projection"}).hasValue();
        };
        for (int time = 0; time < 2; ++time) {
            QVERIFY(paste(reversed) && changeProjection());
            QCOMPARE(document.setup().depthRange, (DepthRange{1.0, 0.0}));
        }
        QVERIFY(paste(lens()));
        QCOMPARE(document.setup().depthRange, DepthRange{});
        // A range that was set since stays.
        QVERIFY(paste(reversed) && changeProjection());
        QVERIFY(editViewport(document, document.scene().viewport, {0.25, 0.75}, {"Depth range"}));
        QVERIFY(paste(lens()));
        QCOMPARE(document.setup().depthRange, (DepthRange{0.25, 0.75}));
    }

    void theFileKeepsThemAsGiven()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, printed(lens(), "JSON"));
        pasting.paste(MatrixRole::View, printed(view(), "JSON"));
        pasting.ok()->click();
        SceneDocument &document = pasting.document;
        const SceneFile file = saved(document);
        QCOMPARE(std::get<MatrixProjection>(file.projection).clipFromEye, lens());
        QCOMPARE(std::get<glm::dmat4>(file.view), view());
        const auto scene = sceneFromFile(file, {}, {});
        QVERIFY(scene && scene->projection.matrix() && scene->camera.matrix());
        QCOMPARE(*scene->camera.matrix(), view());
        // A turn of the camera gives another view, but keeps the projection; undone, the view is as
        // given again.
        LookAt camera = document.setup().camera();
        camera.eye.x += 1.0;
        setCamera(document, camera);
        QVERIFY(std::holds_alternative<LookAt>(saved(document).view));
        QVERIFY(std::holds_alternative<MatrixProjection>(saved(document).projection));
        document.undoStack().undo();
        QVERIFY(std::holds_alternative<glm::dmat4>(saved(document).view));
    }

    void whatStillHoldsIsSaidInThePipeline()
    {
        SceneDocument document;
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        glm::dmat4 turned = lens();
        turned[1][1] = -turned[1][1];
        QVERIFY(editMatrices(document, MatrixProjection{turned, std::nullopt}, view(), {"Paste Matrices"}));
        const auto button = [&]() -> QPushButton * {
            for (QPushButton *one : panel.findChildren<QPushButton *>()) {
                if (one->text() == "Flip y" && one->isVisible())
                    return one;
            }
            return nullptr;
        };
        QVERIFY(button());
        button()->click();
        QCOMPARE(document.scene().projection.matrix()->clipFromEye, lens());
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Flip y"));
        QVERIFY(!button());
        document.undoStack().undo();
        QVERIFY(button());
    }

    void pastingNothingChangesNothing()
    {
        Pasting pasting;
        auto *edit = pasting.box(MatrixRole::Projection)->findChild<QPlainTextEdit *>();
        edit->setPlainText(QStringLiteral("1 2"));
        QGuiApplication::clipboard()->clear();
        edit->setFocus();
        QTest::keySequence(edit, QKeySequence::Paste);
        QCOMPARE(edit->toPlainText(), QStringLiteral("1 2"));
        QGuiApplication::clipboard()->clear(QClipboard::Selection);
        QTest::mouseClick(edit->viewport(), Qt::MiddleButton);
        QCOMPARE(edit->toPlainText(), QStringLiteral("1 2"));

        OpenBox box;
        QMimeData nothing, picture, marked;
        box.insertFromMimeData(&nothing);
        picture.setData(QStringLiteral("image/png"), "x");
        box.insertFromMimeData(&picture);
        QVERIFY(!box.canInsertFromMimeData(&nothing) && !box.canInsertFromMimeData(&picture));
        QCOMPARE(box.toPlainText(), QString());
        marked.setData(QStringLiteral("text/markdown"), "**1**");
        marked.setText(QStringLiteral("**1**"));
        box.insertFromMimeData(&marked);
        QCOMPARE(box.toPlainText(), QStringLiteral("**1**"));
        box.setReadOnly(true);
        box.insertFromMimeData(&marked);
        QCOMPARE(box.toPlainText(), QStringLiteral("**1**"));
    }

    void aTextThatIsTooLongIsRefused()
    {
        Pasting pasting;
        pasting.paste(MatrixRole::Projection, QStringLiteral("1 2 3"));
        const QString text = QStringLiteral("1 ").repeated(500'000) + QStringLiteral("1");
        pasting.paste(MatrixRole::Projection, text);
        QVERIFY(pasting.says(QStringLiteral("The text has 1000001 characters; at most 1000000 can be pasted.")));
        QVERIFY(pasting.says(QStringLiteral("“unproject scene FILE”")));
        QCOMPARE(pasting.box(MatrixRole::Projection)->text(), QStringLiteral("1 2 3"));
        // From the Pipeline panel too, and together with the text there.
        pasting.dialog.setText(MatrixRole::View, text);
        QVERIFY(pasting.says(QStringLiteral("1000001 characters")));
        QCOMPARE(pasting.box(MatrixRole::View)->text(), QString());
        OpenBox box;
        QSignalSpy refused(&box, &PlainTextBox::refused);
        QMimeData four;
        four.setText(QStringLiteral("1234"));
        box.setMost(7);
        box.insertFromMimeData(&four);
        box.insertFromMimeData(&four);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused[0][0].toLongLong(), 8);
        QCOMPARE(box.toPlainText(), QStringLiteral("1234"));
        box.selectAll();
        box.insertFromMimeData(&four);
        QCOMPARE(refused.size(), 1);
    }

    void pasteInThePipelineOpensTheDialog()
    {
        SceneDocument document;
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
        panel.open(PointModel::Space::Eye);
        QGuiApplication::clipboard()->setText(printed(view(), "Eigen"));
        const QSignalSpy typedCounts(&panel, &PipelinePanel::aboutToPaste);
        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() != panel.model().matrix(PipelineStage::ViewMatrix))
                continue;
            grid->setFocus();
            QTest::keySequence(grid, QKeySequence::Paste);
        }
        QCOMPARE(typedCounts.size(), 1);
        auto *dialog = panel.findChild<PasteCameraDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->findChildren<PastedMatrixBox *>().at(1)->text(), printed(view(), "Eigen"));
        dialog->accept();
        QCOMPARE(*document.scene().camera.matrix(), view());
    }

    void whatIsTypedInAMatrixStaysThere()
    {
        const std::unique_ptr<MainWindow> window = shownWindow(false, {900, 700}, true);
        PipelinePanel panel(window->document(), window.get());
        panel.resize(400, 600);
        panel.show();
        NumberGrid *grid = panel.findChildren<NumberGrid *>().first();
        grid->setFocus();
        grid->setCurrentIndex(grid->model()->index(0, 0));
        for (const Qt::Key key :
             {Qt::Key_V, Qt::Key_E, Qt::Key_S, Qt::Key_M, Qt::Key_F, Qt::Key_P, Qt::Key_5, Qt::Key_Home}) {
            QKeyEvent event(QEvent::ShortcutOverride, key, {},
                            key == Qt::Key_Home ? QString() : QString(QChar(key)).toLower());
            event.ignore();
            QCoreApplication::sendEvent(grid, &event);
            QVERIFY2(event.isAccepted(), qPrintable(QKeySequence(key).toString()));
        }
        // Ctrl makes them commands, as everywhere.
        QKeyEvent command(QEvent::ShortcutOverride, Qt::Key_1, Qt::ControlModifier, "1");
        command.ignore();
        QCoreApplication::sendEvent(grid, &command);
        QVERIFY(!command.isAccepted());
    }
};

UNPROJECTOR_TEST(TestPasteMatrices, display)
#include "test_paste_matrices.moc"

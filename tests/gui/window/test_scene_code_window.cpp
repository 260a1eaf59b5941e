// The scene as code in its window: the code of the current scene, copied and saved as displayed.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/manual_window.h"
#include "gui/shell/plain_tool_tip.h"
#include "gui/shell/scene_code_window.h"
#include "gui/shell/window_questions.h"
#include "gui/widgets/elided_label.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QUndoCommand>

#include <algorithm>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene_code;

class TestSceneCodeWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_window = windowOfSize({1000, 700});
        QAction *action = actionOf(*m_window, QStringLiteral("Scene as Code…"));
        QVERIFY(action);
        action->trigger();
        m_code = m_window->findChild<SceneCodeWindow *>();
        QVERIFY(m_code && m_code->isVisible());
        QVERIFY(shown().contains(QStringLiteral("gluLookAt(")));
    }

    void itFollowsTheScene()
    {
        auto *text = m_code->findChild<QPlainTextEdit *>();
        text->verticalScrollBar()->setValue(7);
        LookAt camera = m_window->document().setup().camera();
        camera.eye = WorldPoint(1.25, 2.5, 7.0625);
        setCamera(m_window->document(), camera);
        QVERIFY2(shown().contains(QStringLiteral("gluLookAt(1.25, 2.5, 7.0625, ")), qPrintable(shown()));
        QCOMPARE(text->verticalScrollBar()->value(), 7);
        QVERIFY(text->isReadOnly());
    }

    void matricesOfAFileStayMatrices()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("scene.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"unprojector": 1, "window": {"width": 800, "height": 600},
        "projection": {"type": "matrix", "matrix": [1.5,0,0,0, 0,2,0,0, 0,0,-1.25,-1, 0,0,-2.25,0]},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": []})");
        file.close();
        m_window->session().openScene(std::filesystem::path(file.fileName().toStdU16String()));
        QTRY_VERIFY2_WITH_TIMEOUT(shown().contains(QStringLiteral("0.0, 0.0, -1.25, -1.0")), qPrintable(shown()),
                                  kPatienceMilliseconds);
    }

    void everyDialectIsCopiedAndSaved()
    {
        QTemporaryDir folder;
        const QList<QPushButton *> buttons = m_code->findChildren<QPushButton *>();
        const auto copies = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton *button) {
            return button->text().remove(u'&') == QStringLiteral("Copy");
        });
        QVERIFY(copies != buttons.end());
        for (const auto &[dialect, word] : {std::pair(CodeDialect::Glu, "gluUnProject"),
                                            {CodeDialect::Glm, "glm::unProject"},
                                            {CodeDialect::Qt, "QMatrix4x4"},
                                            {CodeDialect::ThreeJs, "THREE."},
                                            {CodeDialect::NumPy, "import numpy as np"}}) {
            m_code->setDialect(dialect);
            QVERIFY2(shown().contains(QLatin1String(word)), word);
            (*copies)->click();
            QCOMPARE(QGuiApplication::clipboard()->text(), shown());
            const QString file = folder.filePath(QStringLiteral("code"));
            QCOMPARE(m_code->exportTo(std::filesystem::path(file.toStdU16String())), QString());
            QFile saved(file);
            QVERIFY(saved.open(QIODevice::ReadOnly));
            QCOMPARE(QString::fromUtf8(saved.readAll()), shown());
            const QList<QLabel *> labels = m_code->findChildren<QLabel *>();
            QVERIFY(std::any_of(labels.begin(), labels.end(),
                                [](const QLabel *label) { return label->text() == QStringLiteral("Saved: code"); }));
        }
        QVERIFY(m_code->exportTo(std::filesystem::path(folder.path().toStdU16String()))
                    .startsWith(QDir::toNativeSeparators(folder.path())));
    }

    void filesOfTheSceneAreNotWrittenOver()
    {
        const QTemporaryDir folder;
        const auto pathOf = [&folder](const QString &name) {
            return std::filesystem::path(folder.filePath(name).toStdU16String());
        };
        const auto write = [&folder](const QString &name, const QByteArray &text) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        };
        write(QStringLiteral("t.mtl"), "newmtl m\nmap_Kd t.jpg\nmap_Bump bumps.jpg\n");
        write(QStringLiteral("t.jpg"), "no picture");
        write(QStringLiteral("bumps.jpg"), "no picture");
        write(QStringLiteral("t.obj"), "mtllib t.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write(QStringLiteral("scene.json"), R"({"unprojector": 1, "window": {"width": 800, "height": 600},
        "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": [{"name": "t", "file": "t.obj"}]})");
        std::filesystem::create_hard_link(pathOf(QStringLiteral("t.obj")), pathOf(QStringLiteral("other.obj")));
        m_window->session().openScene(pathOf(QStringLiteral("scene.json")));
        QTRY_COMPARE_WITH_TIMEOUT(m_window->session().file(), pathOf(QStringLiteral("scene.json")),
                                  kPatienceMilliseconds);
        for (const char *name : {"scene.json", "t.obj", "t.mtl", "t.jpg", "bumps.jpg", "other.obj"}) {
            const std::filesystem::path file = pathOf(QString::fromLatin1(name));
            const auto before = std::filesystem::file_size(file);
            const QString problem = m_code->exportTo(file);
            QVERIFY2(problem.contains(QStringLiteral("would destroy it")), qPrintable(name + problem));
            QCOMPARE(std::filesystem::file_size(file), before);
        }
        QCOMPARE(m_code->exportTo(pathOf(QStringLiteral("new.cpp"))), QString());
    }

    /// Names and paths that look like markup are shown as plain text.
    void namesAreNoMarkup()
    {
        const QString name = QStringLiteral("<img src=x><b>bold"),
                      escaped = QStringLiteral("&lt;img src=x&gt;&lt;b&gt;bold");
#ifndef Q_OS_WIN // where no file has such a name
        const QTemporaryDir folder;
        QCOMPARE(m_code->exportTo(std::filesystem::path(folder.filePath(name).toStdU16String())), QString());
        const QList<QLabel *> labels = m_code->findChildren<QLabel *>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [&](const QLabel *label) {
            return label->textFormat() == Qt::PlainText && label->text().contains(name)
                   && label->toolTip().contains(escaped);
        }));
#endif
        bool isPlain = false;
        QTimer::singleShot(0, m_code, [&] {
            auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(box);
            isPlain = box->textFormat() == Qt::PlainText && box->text() == name;
            box->close();
        });
        warn(*m_code, QStringLiteral("title"), name);
        QVERIFY(isPlain);
        ElidedLabel label;
        label.resize(20, 20);
        label.setFullText(name);
        QVERIFY2(label.toolTip().contains(escaped), qPrintable(label.toolTip()));
        QAction action(QStringLiteral("&Undo Move ") + name);
        keepToolTipPlain(&action);
        QVERIFY2(action.toolTip().contains(escaped), qPrintable(action.toolTip()));
        action.setText(QStringLiteral("&Undo"));
        QVERIFY(!action.toolTip().contains(escaped) && action.toolTip().contains(QStringLiteral("Undo")));
        m_window->document().undoStack().push(new QUndoCommand(QStringLiteral("Move ") + name));
        QVERIFY(m_window->findChild<QAction *>(QStringLiteral("undo"))->toolTip().contains(escaped));
    }

    void helpOpensItsPage()
    {
        m_code->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Help)->click();
        auto *manual = m_window->findChild<ManualWindow *>();
        QVERIFY(manual && manual->isVisible());
        QCOMPARE(manual->currentPage().name, QStringLiteral("conventions"));
        QCOMPARE(manual->contents().currentItem()->text(0), QStringLiteral("A scene as code"));
    }

    void theChosenDialectIsRemembered()
    {
        const auto codeOf = [](MainWindow &window) {
            actionOf(window, QStringLiteral("Scene as Code…"))->trigger();
            return window.findChild<SceneCodeWindow *>();
        };
        const auto start = [] {
            MainWindow::Options options;
            options.remembers = true;
            return std::make_unique<MainWindow>(options);
        };
        redirectSettings();
        {
            const auto window = start();
            SceneCodeWindow *code = codeOf(*window);
            QCOMPARE(code->dialect(), CodeDialect::Glu);
            code->setDialect(CodeDialect::NumPy);
        }
        const auto next = start();
        QCOMPARE(codeOf(*next)->dialect(), CodeDialect::NumPy);
    }

private:
    QString shown() const
    {
        return m_code->findChild<QPlainTextEdit *>()->toPlainText();
    }

    std::unique_ptr<MainWindow> m_window;
    SceneCodeWindow *m_code = nullptr;
};

UNPROJECTOR_TEST(TestSceneCodeWindow, display)
#include "test_scene_code_window.moc"

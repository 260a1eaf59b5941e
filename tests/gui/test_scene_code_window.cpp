// The scene as code in its window: it is that of the scene as it is now, copied and saved as it is read.

#include "gui/window/scene_code_window.h"
#include "tests/support/patience.h"
#include "window_user.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>

#include <algorithm>

using namespace guitest;

class TestSceneCodeWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void itFollowsTheScene();
    void matricesOfAFileStayMatrices();
    void everyDialectIsCopiedAndSaved();

private:
    QString shown() const { return m_code->findChild<QPlainTextEdit *>()->toPlainText(); }

    std::unique_ptr<MainWindow> m_window;
    SceneCodeWindow *m_code = nullptr;
};

void TestSceneCodeWindow::initTestCase()
{
    m_window = windowOfSize({1000, 700});
    QAction *action = actionOf(*m_window, QStringLiteral("Scene as Code…"));
    QVERIFY(action);
    action->trigger();
    m_code = m_window->findChild<SceneCodeWindow *>();
    QVERIFY(m_code && m_code->isVisible());
    QVERIFY(shown().contains(QStringLiteral("gluLookAt(")));
}

void TestSceneCodeWindow::itFollowsTheScene()
{
    auto *text = m_code->findChild<QPlainTextEdit *>();
    text->verticalScrollBar()->setValue(7);
    LookAt camera = m_window->document().geometry().camera();
    camera.eye = WorldPoint(1.25, 2.5, 7.0625);
    m_window->document().setCamera(camera);
    QVERIFY2(shown().contains(QStringLiteral("gluLookAt(1.25, 2.5, 7.0625, ")), qPrintable(shown()));
    QCOMPARE(text->verticalScrollBar()->value(), 7);
    QVERIFY(text->isReadOnly());
}

void TestSceneCodeWindow::matricesOfAFileStayMatrices()
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

void TestSceneCodeWindow::everyDialectIsCopiedAndSaved()
{
    QTemporaryDir folder;
    QPushButton *copies = nullptr;
    for (QPushButton *button : m_code->findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == QStringLiteral("Copy"))
            copies = button;
    }
    QVERIFY(copies);
    for (const auto &[dialect, word] : {std::pair(CodeDialect::Glu, "gluUnProject"),
                                        {CodeDialect::Glm, "glm::unProject"},
                                        {CodeDialect::Qt, "QMatrix4x4"},
                                        {CodeDialect::ThreeJs, "THREE."}}) {
        m_code->setDialect(dialect);
        QVERIFY2(shown().contains(QLatin1String(word)), word);
        copies->click();
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
    QVERIFY(m_code->exportTo(std::filesystem::path(folder.path().toStdU16String())).startsWith(folder.path()));
}

QTEST_MAIN(TestSceneCodeWindow)
#include "test_scene_code_window.moc"

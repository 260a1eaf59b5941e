// The list of the scene's objects, as a user handles it.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/objects/objects_model.h"
#include "gui/objects/objects_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QRegularExpression>
#include <QToolButton>
#include <QTreeView>

#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

class TestObjectsPanel : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_panel.reset();
        m_document = std::make_unique<SceneDocument>();
        m_document->setSurface({800, 600, 1.0});
        std::vector<SceneObject> objects = examples::bundledScene();
        objects.resize(3);
        objects[0].name = "first";
        objects[1].name = "second";
        objects[2].name = "third";
        objects[1].transform = {Translate{{30.0, 0.0, 0.0}}};
        openObjects(*m_document, objects);
        m_panel = std::make_unique<ObjectsPanel>(*m_document);
        m_panel->resize(300, 300);
        m_panel->show();
        m_list = m_panel->findChild<QTreeView *>();
        QVERIFY(m_list);
    }

    void aRowTellsItsObject()
    {
        QCOMPARE(m_list->model()->rowCount(), 3);
        for (int row = 0; row < 3; ++row) {
            const SceneObject &object = m_document->objects()[static_cast<std::size_t>(row)];
            QCOMPARE(at(row).data().toString(), QString::fromStdString(object.name));
            QCOMPARE(at(row).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
            QCOMPARE(at(row, ObjectsModel::Triangles).data().toString(),
                     QLocale().toString(qulonglong(object.model->triangleCount())));
            QVERIFY(at(row).data(Qt::ToolTipRole).toString().contains(QStringLiteral("comes with the program")));
        }
        std::vector<SceneObject> more{m_document->objects()[0]};
        more[0].name = "more";
        more[0].file = "/there/more.obj";
        QVERIFY(addObjects(*m_document, more));
        QCOMPARE(m_list->model()->rowCount(), 4);
        QVERIFY(at(3).data(Qt::ToolTipRole).toString().contains(QStringLiteral("more.obj")));
        QCOMPARE(at(3).data().toString(), QStringLiteral("more"));
    }

    void aNameOfAnyKindIsShownAsItIsWritten_data()
    {
        addColumn<QString>("name");
        addColumn<QString>("shown");
        newRow("HTML") << "<h1>big</h1>"
                       << "<h1>big</h1>";
        newRow("line breaks") << "two\nlines\r\nthree"
                              << "two lines three";
        newRow("very long") << QString(100000, u'a') << QString(200, u'a') + u'…';
    }

    void aNameOfAnyKindIsShownAsItIsWritten()
    {
        QFETCH(QString, name);
        QFETCH(QString, shown);
        std::vector<SceneObject> objects = m_document->objects();
        objects[0].name = name.toStdString();
        openObjects(*m_document, objects);
        QCOMPARE(at(0).data().toString(), shown);
        const QString toolTip = at(0).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(shown.toHtmlEscaped()), qPrintable(toolTip));
        QVERIFY(!toolTip.contains(QStringLiteral("<h1>")) && toolTip.size() < 600);
    }

    void theCheckBoxHidesAndShows()
    {
        m_list->setCurrentIndex(at(1));
        const QRect row = m_list->visualRect(at(1));
        const QPoint box(row.left() + 10, row.center().y());
        QTest::mouseClick(m_list->viewport(), Qt::LeftButton, {}, box);
        QVERIFY(m_document->objects()[1].isHidden);
        QCOMPARE(at(1).data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QVERIFY(at(1).data(Qt::ToolTipRole).toString().contains(QStringLiteral("hidden")));
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Hide object"));
        m_document->undoStack().undo();
        QVERIFY(!m_document->objects()[1].isHidden);
        QCOMPARE(at(1).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        QTest::keyClick(m_list, Qt::Key_Space);
        QVERIFY(m_document->objects()[1].isHidden);
        QTest::keyClick(m_list, Qt::Key_Space);
        QVERIFY(!m_document->objects()[1].isHidden);
    }

    void namesAreEditedInPlace_data()
    {
        addColumn<QString>("typed");
        addColumn<QString>("name");
        addColumn<QString>("said");
        newRow("another name") << " bunny "
                               << "bunny"
                               << "";
        newRow("that of another") << "first"
                                  << "second"
                                  << "Another object is already called “first”. Choose another name.";
        newRow("none") << " "
                       << "second"
                       << "An object needs a name. The old name is kept.";
        newRow("its own") << "second"
                          << "second"
                          << "";
    }

    void namesAreEditedInPlace()
    {
        QFETCH(QString, typed);
        QFETCH(QString, name);
        QFETCH(QString, said);
        m_list->setCurrentIndex(at(1));
        m_list->edit(at(1));
        type(typed);
        QCOMPARE(m_document->objects()[1].name, name.toStdString());
        QCOMPARE(at(1).data().toString(), name);
        QCOMPARE(reason(), said);
        QCOMPARE(m_document->undoStack().undoText(),
                 name == QStringLiteral("second") ? QString() : QStringLiteral("Rename object"));
        // The message disappears with the next action.
        m_list->setCurrentIndex(at(2));
        QVERIFY(reason().isEmpty());
    }

    void keysRenameAndRemove()
    {
        m_list->setFocus();
        m_list->setCurrentIndex(at(2));
        QTest::keyClick(m_list, Qt::Key_Return);
        type(QStringLiteral("bunny"));
        QCOMPARE(names(), QStringList({"first", "second", "bunny"}));
        QTest::keyClick(m_list, Qt::Key_Delete);
        QCOMPARE(names(), QStringList({"first", "second"}));
        m_document->undoStack().undo();
        QCOMPARE(names(), QStringList({"first", "second", "bunny"}));
        QCOMPARE(m_list->model()->rowCount(), 3);
    }

    void theButtonsGoToTheCurrentObject()
    {
        m_list->setCurrentIndex(at(1));
        button(QStringLiteral("Fit"))->click();
        QVERIFY(std::abs(m_document->setup().camera().center.x - 30.0) < 5.0);
        button(QStringLiteral("Remove"))->click();
        QCOMPARE(names(), QStringList({"first", "third"}));
        QCOMPARE(m_list->currentIndex().row(), 1); // the next one
        button(QStringLiteral("Remove"))->click();
        QCOMPARE(names(), QStringList({"first"}));
        QCOMPARE(m_list->currentIndex().row(), 0); // the last one
    }

    void withoutAnObjectNothingCanBeDone()
    {
        openObjects(*m_document, {});
        QVERIFY(!button(QStringLiteral("Fit"))->isEnabled() && !button(QStringLiteral("Remove"))->isEnabled());
        QTest::keyClick(m_list, Qt::Key_Delete);
        QTest::keyClick(m_list, Qt::Key_Return);
        QCOMPARE(m_list->model()->rowCount(), 0);
        m_document->undoStack().undo();
    }

    void theCurrentObjectStaysCurrent()
    {
        m_list->setCurrentIndex(at(1));
        const auto current = [this] { return m_list->currentIndex().data().toString(); };
        QVERIFY(moveObject(*m_document, 1, 0));
        QCOMPARE(current(), QStringLiteral("second"));
        QVERIFY(removeObject(*m_document, 1));
        QCOMPARE(current(), QStringLiteral("second"));
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QCOMPARE(current(), QStringLiteral("second"));
        QCOMPARE(m_list->currentIndex().row(), 1);
    }

    void draggingARowMovesItsObject_data()
    {
        addColumn<int>("from");
        addColumn<int>("row"); // where it is dropped: before that one
        addColumn<QStringList>("order");
        newRow("to the end") << 0 << 3 << QStringList({"second", "third", "first"});
        newRow("onto nothing, below") << 0 << -1 << QStringList({"second", "third", "first"});
        newRow("to the start") << 2 << 0 << QStringList({"third", "first", "second"});
        newRow("between") << 0 << 2 << QStringList({"second", "first", "third"});
        newRow("where it is") << 1 << 1 << QStringList({"first", "second", "third"});
        newRow("just behind where it is") << 1 << 2 << QStringList({"first", "second", "third"});
    }

    void draggingARowMovesItsObject()
    {
        QFETCH(int, from);
        QFETCH(int, row);
        QFETCH(QStringList, order);
        const QStringList before = names();
        QAbstractItemModel *model = m_list->model();
        const std::unique_ptr<QMimeData> transformed(model->mimeData({at(from)}));
        QVERIFY(model->canDropMimeData(transformed.get(), Qt::MoveAction, row, 0, {}));
        model->dropMimeData(transformed.get(), Qt::MoveAction, row, 0, {});
        QCOMPARE(names(), order);
        QCOMPARE(m_list->model()->rowCount(), 3);
        QCOMPARE(m_document->undoStack().count(), order == before ? 0 : 1);
        // Something else is dropped in vain.
        QMimeData text;
        text.setText(QStringLiteral("2"));
        QVERIFY(!model->dropMimeData(&text, Qt::MoveAction, 0, 0, {}));
    }

    void itIsAsNarrowAsAPanelMayBe()
    {
        QVERIFY(addObjects(*m_document, {m_document->objects()[0]}));
        QCOMPARE(renameObject(*m_document, 0, QString(300, u'x')), NameFault::None);
        const int digits = m_panel->fontMetrics().horizontalAdvance(QString(40, u'0'));
        QVERIFY(m_panel->minimumSizeHint().width() <= digits);
        m_panel->resize(digits, 300);
        // The name is cut in the middle, not the number.
        QVERIFY(m_list->header()->length() <= m_list->viewport()->width());
        QVERIFY(m_list->columnWidth(ObjectsModel::Triangles)
                >= m_panel->fontMetrics().horizontalAdvance(at(0, ObjectsModel::Triangles).data().toString()));
    }

private:
    QModelIndex at(int row, int column = 0) const { return m_list->model()->index(row, column); }
    QToolButton *button(const QString &text) const
    {
        for (QToolButton *button : m_panel->findChildren<QToolButton *>()) {
            if (button->text() == text)
                return button;
        }
        return nullptr;
    }
    QStringList names() const
    {
        QStringList names;
        for (const SceneObject &object : m_document->objects())
            names << QString::fromStdString(object.name);
        return names;
    }
    QString reason() const
    {
        for (const QLabel *label : m_panel->findChildren<QLabel *>()) {
            if (label->accessibleName() == QStringLiteral("Reason why the name was rejected"))
                return label->isHidden() ? QString() : label->text();
        }
        return QStringLiteral("no label");
    }
    void type(const QString &name)
    {
        auto *editor = m_list->findChild<QLineEdit *>();
        QVERIFY(editor);
        // Enter ends the editing, and is not the list's, which would begin another.
        QTest::failOnWarning(QRegularExpression(QStringLiteral("^edit:")));
        editor->setText(name);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // it ends when the key has been dealt with
    }

    std::unique_ptr<ObjectsPanel> m_panel; // goes before the document
    std::unique_ptr<SceneDocument> m_document;
    QTreeView *m_list = nullptr;
};

UNPROJECTOR_TEST(TestObjectsPanel)
#include "test_objects_panel.moc"

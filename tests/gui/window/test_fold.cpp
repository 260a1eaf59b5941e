// A fold in a panel that scrolls.

#include "tests/support/test.h"

#include "gui/widgets/fold.h"
#include "tests/support/patience.h"

#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

using namespace unprojector::gui;

class TestFold : public QObject {
    Q_OBJECT

private slots:
    void whatItOpensIsInSight()
    {
        auto &content = *new QLabel(QStringLiteral("opened")); // owned by the fold
        content.setFixedHeight(60);
        QScrollArea area;
        area.setWidgetResizable(true);
        auto *panel = new QWidget;
        auto *layout = new QVBoxLayout(panel);
        auto *above = new QWidget;
        above->setFixedHeight(400);
        layout->addWidget(above);
        auto *fold = new Fold(QStringLiteral("fold"), {}, &content);
        layout->addWidget(fold);
        area.setWidget(panel);
        area.resize(200, 430);
        area.show();
        const auto isInSight = [&] {
            const QRect seen(content.mapTo(area.viewport(), QPoint()), content.size());
            return content.isVisible() && area.viewport()->rect().contains(seen);
        };
        fold->setOpen(true); // like the restore of a layout
        QTest::qWait(20);
        QVERIFY(!isInSight());
        fold->setOpen(false);
        fold->findChild<QToolButton *>()->click();
        QTRY_VERIFY_WITH_TIMEOUT(isInSight(), kPatienceMilliseconds);
    }
};

UNPROJECTOR_TEST(TestFold)
#include "test_fold.moc"

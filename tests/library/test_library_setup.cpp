#include "unprojector/setup.h"

#include <QTest>

class TestLibrarySetup : public QObject {
    Q_OBJECT

private slots:
    void aWrongValueIsNamed();
};

void TestLibrarySetup::aWrongValueIsNamed()
{
    unprojector::Perspective perspective;
    perspective.nearDistance = 0.0;
    const auto setup = unprojector::Setup::of(perspective, {}, {});
    QVERIFY(!setup);
    QCOMPARE(QString::fromStdString(setup.error().message),
             QStringLiteral("near is 0; it must be greater than 0 and smaller than far (100)"));
}

QTEST_GUILESS_MAIN(TestLibrarySetup)
#include "test_library_setup.moc"

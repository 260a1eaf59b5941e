#include "tests/support/test.h"

#include "unprojector/setup.h"

class TestLibrarySetup : public QObject {
    Q_OBJECT

private slots:
    void aWrongValueIsNamed()
    {
        unprojector::Perspective perspective;
        perspective.nearDistance = 0.0;
        const auto setup = unprojector::Setup::of(perspective, {}, {});
        QVERIFY(!setup);
        QCOMPARE(QString::fromStdString(setup.error().message),
                 QStringLiteral("near is 0; it must be greater than 0 and smaller than far (100)"));
    }
};

UNPROJECTOR_TEST(TestLibrarySetup)
#include "test_library_setup.moc"

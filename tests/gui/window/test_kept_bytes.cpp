// The window's state between runs: it is read back only if it is unchanged.

#include "tests/support/test.h"

#include "gui/window/kept_bytes.h"
#include "gui/window/workspaces.h"
#include "tests/gui/gui_scene.h"

#include <QDockWidget>
#include <QSettings>

#include <functional>

using namespace guitest;
using namespace unprojector::gui;

namespace {

using Damage = std::function<QVariant(const QByteArray &)>;

const QByteArray kPurpose = "window/places/click";

} // namespace

Q_DECLARE_METATYPE(Damage)

class TestKeptBytes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void whatWasSealedComesBack_data()
    {
        addColumn<QByteArray>("bytes");
        newRow("a layout") << QByteArray("\0\0\0\xFFlayout", 10);
        newRow("one byte") << QByteArray("x");
    }

    void whatWasSealedComesBack()
    {
        QFETCH(QByteArray, bytes);
        QCOMPARE(unsealed(sealed(bytes, kPurpose), kPurpose), bytes);
        QCOMPARE(unsealed(sealed(bytes, kPurpose), "window/places/pipeline"), QByteArray());
    }

    void nothingElseDoes_data()
    {
        addColumn<Damage>("damage");
        const auto row = [](const char *name, const Damage &damage) { newRow(name) << damage; };
        row("cut off", [](const QByteArray &kept) { return kept.chopped(1); });
        row("half of it", [](const QByteArray &kept) { return kept.left(kept.size() / 2); });
        row("shorter than its check sum", [](const QByteArray &kept) { return kept.left(7); });
        row("with more behind it", [](const QByteArray &kept) { return kept + '\0'; });
        row("one bit other", [](const QByteArray &kept) {
            QByteArray other = kept;
            other[other.size() - 1] = static_cast<char>(other.back() ^ 1);
            return other;
        });
        row("another check sum", [](const QByteArray &kept) {
            QByteArray other = kept;
            other[0] = static_cast<char>(other.front() ^ 1);
            return other;
        });
        row("without a check sum", [](const QByteArray &kept) { return kept.mid(32); });
        row("nothing", [](const QByteArray &) { return QByteArray(); });
        row("a text", [](const QByteArray &) { return QStringLiteral("layout"); });
        row("a list", [](const QByteArray &kept) { return QVariantList{kept}; });
    }

    void nothingElseDoes()
    {
        QFETCH(Damage, damage);
        QCOMPARE(unsealed(damage(sealed("a layout", kPurpose)), kPurpose), QByteArray());
    }

    void aDamagedLayoutIsNotTaken_data() { nothingElseDoes_data(); }

    /// The window starts as if nothing had been kept.
    void aDamagedLayoutIsNotTaken()
    {
        QFETCH(Damage, damage);
        QSettings().clear();
        const auto start = [] {
            MainWindow::Options options;
            options.autosave = {};
            auto window = std::make_unique<MainWindow>(options);
            window->show();
            return window;
        };
        const auto isObjectsShown = [](MainWindow &window) {
            return !window.workspaces().dock(Panel::Objects).isHidden();
        };
        {
            const auto first = start();
            QVERIFY(isObjectsShown(*first));
            first->workspaces().dock(Panel::Objects).close();
            first->close();
        }
        QVERIFY(!isObjectsShown(*start())); // the kept layout is restored
        QSettings settings;
        for (const QString &key : settings.allKeys()) {
            if (settings.value(key).typeId() == QMetaType::QByteArray && key != QStringLiteral("window/place"))
                settings.setValue(key, damage(settings.value(key).toByteArray()));
        }
        settings.sync();
        QVERIFY(isObjectsShown(*start()));
    }
};

UNPROJECTOR_TEST(TestKeptBytes, display)
#include "test_kept_bytes.moc"

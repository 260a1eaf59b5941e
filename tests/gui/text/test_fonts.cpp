// The fontconfig files of tests/fonts: a test run uses the fonts that it names, and no others.

#include "tests/support/test.h"

#include "gui/text/formula_layout.h"

#include <QApplication>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFontInfo>
#include <QStringList>

#include <algorithm>
#include <array>

namespace unprojector::gui {
namespace {

struct Family {
    const char *file, *sans, *serif, *mono, *packages;
};
constexpr std::array kFamilies{
    Family{"dejavu", "DejaVu Sans", "DejaVu Serif", "DejaVu Sans Mono", "fonts-dejavu-core"},
    Family{"noto", "Noto Sans", "Noto Serif", "Noto Sans Mono", "fonts-noto-core fonts-noto-mono"},
    Family{"liberation", "Liberation Sans", "Liberation Serif", "Liberation Mono", "fonts-liberation"},
};

} // namespace

class TestFonts : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QString file = QFileInfo(qEnvironmentVariable("FONTCONFIG_FILE")).baseName();
        const auto *found = std::find_if(kFamilies.begin(), kFamilies.end(),
                                         [&file](const Family &one) { return file == QLatin1String(one.file); });
        QVERIFY2(found != kFamilies.end(), "FONTCONFIG_FILE must name a file of tests/fonts");
        m_family = found;
    }

    void theNamedFontsAreInUse_data()
    {
        QTest::addColumn<QString>("used");
        QTest::addColumn<QString>("named");
        const auto usedBy = [](const QFont &font) { return QFontInfo(font).family(); };
        constexpr double kPointSize = 11.0;
        QTest::newRow("window") << usedBy(QApplication::font()) << QString::fromLatin1(m_family->sans);
        QTest::newRow("formulas") << usedBy(formulaFont(kPointSize)) << QString::fromLatin1(m_family->serif);
        QTest::newRow("code") << usedBy(QFontDatabase::systemFont(QFontDatabase::FixedFont))
                              << QString::fromLatin1(m_family->mono);
    }

    void theNamedFontsAreInUse()
    {
        QFETCH(QString, used);
        QFETCH(QString, named);
        QVERIFY2(used == named, qPrintable(QStringLiteral("%1 is in use, not %2%3").arg(used, named, advice())));
    }

    void hanziHaveAFont()
    {
        for (const char *family : {"Noto Sans CJK SC", "Noto Serif CJK SC"})
            QVERIFY2(QFontDatabase::hasFamily(QLatin1String(family)), qPrintable(QLatin1String(family) + advice()));
    }

    void otherFontsAreInvisible()
    {
        const QString name = QString::fromLatin1(m_family->sans).section(u' ', 0, 0);
        const QStringList generic{QStringLiteral("Sans Serif"), QStringLiteral("Serif"), QStringLiteral("Monospace")};
        for (const QString &family : QFontDatabase::families()) {
            QVERIFY2(family.startsWith(name) || family.contains(QStringLiteral(" CJK ")) || generic.contains(family),
                     qPrintable(family));
        }
        // DejaVu's italics are in a package that a fresh machine lacks.
        const QStringList styles = QFontDatabase::styles(QLatin1String(m_family->serif));
        const bool hasItalics = std::any_of(styles.begin(), styles.end(), [this](const QString &style) {
            return QFontDatabase::italic(QLatin1String(m_family->serif), style);
        });
        QCOMPARE(hasItalics, qstrcmp(m_family->file, "dejavu") != 0);
    }

private:
    QString advice() const
    {
        return QStringLiteral("; install the packages %1 fonts-noto-cjk").arg(QLatin1String(m_family->packages));
    }

    const Family *m_family = nullptr;
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestFonts, fonts)
#include "test_fonts.moc"

// The fontconfig file of tests/fonts: a test run uses the fonts that it names, and no others.

#include "tests/support/test.h"

#include "gui/text/formula_layout.h"

#include <QApplication>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFontInfo>
#include <QStringList>

#include <algorithm>

namespace unprojector::gui {

class TestFonts : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QString file = QFileInfo(qEnvironmentVariable("FONTCONFIG_FILE")).fileName();
        QVERIFY2(file == QStringLiteral("dejavu.conf"), "FONTCONFIG_FILE must name the file of tests/fonts");
    }

    void theNamedFontsAreInUse_data()
    {
        addColumn<QString>("used");
        addColumn<QString>("named");
        const auto usedBy = [](const QFont &font) { return QFontInfo(font).family(); };
        constexpr double kPointSize = 11.0;
        newRow("window") << usedBy(QApplication::font()) << QStringLiteral("DejaVu Sans");
        newRow("formulas") << usedBy(formulaFont(kPointSize)) << QStringLiteral("DejaVu Serif");
        newRow("code") << usedBy(QFontDatabase::systemFont(QFontDatabase::FixedFont))
                       << QStringLiteral("DejaVu Sans Mono");
    }

    void theNamedFontsAreInUse()
    {
        QFETCH(QString, used);
        QFETCH(QString, named);
        QVERIFY2(used == named, qPrintable(QStringLiteral("%1 is in use, not %2%3").arg(used, named, kAdvice)));
    }

    void hanziHaveAFont()
    {
        for (const QString &family : {QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Noto Serif CJK SC")})
            QVERIFY2(QFontDatabase::hasFamily(family), qPrintable(family + kAdvice));
    }

    void otherFontsAreInvisible()
    {
        const QStringList generic{QStringLiteral("Sans Serif"), QStringLiteral("Serif"), QStringLiteral("Monospace")};
        for (const QString &family : QFontDatabase::families()) {
            QVERIFY2(family.startsWith(QStringLiteral("DejaVu ")) || family.contains(QStringLiteral(" CJK "))
                         || generic.contains(family),
                     qPrintable(family));
        }
        // DejaVu's italics are in a package that a fresh machine lacks.
        const QString serif = QStringLiteral("DejaVu Serif");
        const QStringList styles = QFontDatabase::styles(serif);
        QVERIFY(std::none_of(styles.begin(), styles.end(),
                             [&serif](const QString &style) { return QFontDatabase::italic(serif, style); }));
    }

private:
    static inline const QString kAdvice = QStringLiteral("; install the packages fonts-dejavu-core fonts-noto-cjk");
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestFonts)
#include "test_fonts.moc"

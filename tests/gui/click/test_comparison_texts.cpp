// The texts about a pick: its numbers, the formulas with numbers put in, the cause of a difference,
// and the wording of every error.

#include "tests/support/test.h"

#include "gui/click/comparison_panel.h"
#include "gui/click/verdict_view.h"
#include "gui/text/error_text.h"
#include "gui/text/fitted_text.h"
#include "gui/text/formula_text.h"
#include "gui/text/landmark_text.h"
#include "gui/text/number_text.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/formula_view.h"

#include "tests/gui/comparison_picks.h"

#include <QRegularExpression>
#include <QToolButton>

#include <cmath>
#include <limits>
#include <set>

using namespace comparing;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::unproject;

namespace {

/// The text with ordinary spaces instead of no-break ones; the difference is only a matter of
/// looks.
QString withPlainSpaces(QString text)
{
    return text.replace(QChar::Nbsp, u' ');
}

} // namespace

class TestComparisonTexts : public QObject {
    Q_OBJECT

private slots:
    void numbersAreWritten_data()
    {
        addColumn<QString>("is");
        addColumn<QString>("expected");
        newRow("shortest") << shortestText(0.1) << "0.1";
        newRow("shortest, all digits") << shortestText(0.1 + 0.2) << "0.30000000000000004";
        newRow("shortest, tiny") << shortestText(1e-17) << "1e-17";
        newRow("shortest, far from zero") << shortestText(4000000.0) << "4000000";
        newRow("shortest, to the millimetre") << shortestText(-4000000.123) << "-4000000.123";
        newRow("shortest, ten thousand million") << shortestText(1e10) << "1e+10";
        newRow("written, far from zero") << writtenText(4000000.123, 4) << "4000000";
        newRow("written, nearly ten thousand million") << writtenText(9.5e9, 2) << "9500000000";
        newRow("written, ten thousand million") << writtenText(1e10, 2) << "1e+10";
        newRow("written, a ten-thousandth") << writtenText(0.000123456, 3) << "0.000123";
        newRow("written, less") << writtenText(1.234567e-8, 5) << "1.2346e-08";
        newRow("written, less, in few digits") << writtenText(0.00002, 5) << "0.00002";
        newRow("written, tiny") << writtenText(-1.23456e-88, 5) << "-1.2346e-88";
        newRow("written, not a number") << writtenText(std::numeric_limits<double>::quiet_NaN(), 5) << "nan";
        newRow("written, infinite") << writtenText(-std::numeric_limits<double>::infinity()) << "-inf";
        newRow("certain, far from zero") << certainText(4000000.1234, 0.0005) << "4000000.123";
        newRow("certain, far below") << certainText(1.0802858072384839e-13, 9.18e-21) << "1.0802858e-13";
        newRow("certain, below 1e-20") << certainText(1.0802858072384839e-18, 9.18e-26) << "1.0802858e-18";
        newRow("certain, farther") << certainText(123456789012.0, 300.0) << "1.23456789e+11";
        newRow("certain, farther, rounded to nothing") << certainText(4e10, 1e12) << "0";
        newRow("how large") << significantText(1234567.0, 2) << "1.2e+06";
        newRow("significant") << significantText(0.82842712, 4) << "0.8284";
        newRow("significant, negative zero") << significantText(-0.0, 4) << "0";
        newRow("fixed") << fixedText(-1.5, 3) << "-1.500";
        newRow("fixed, rounds to zero") << fixedText(-0.0001, 3) << "0.000";
        newRow("point") << pointText({1.0, -2.96, 0.25}, {0.01, 0.05, 2.0}) << "(1.00, -3.0, 0)";
        newRow("decimals for 123") << QString::number(decimalsFor({1.0, -123.0, 4.0}, 16)) << "13";
        newRow("decimals for nothing") << QString::number(decimalsFor({0.0, 0.0, 0.0}, 16)) << "15";
        newRow("readable") << readableText(0.048) << "0.05";
        newRow("readable, first digit 1") << readableText(0.00123) << "0.0012";
        newRow("readable, rounds to 1") << readableText(0.0096) << "0.01";
        newRow("readable, a pixel of a city") << readableText(312.0) << "300";
        newRow("readable, tens of thousands") << readableText(15500.0) << "16000";
        newRow("readable, a millionth") << readableText(1.26e-6) << "0.0000013";
        newRow("readable, tiny") << readableText(7.9e-9) << "8 × 10⁻⁹";
        newRow("readable, huge") << readableText(1.26e9) << "1.3 × 10⁹";
        newRow("readable, nothing") << readableText(0.0) << "0";
        newRow("point of a survey") << pointText({4000000.1234, 500000.4567, 300.7891}, {0.0005, 0.0005, 0.02})
                                    << "(4000000.123, 500000.457, 300.8)";
        newRow("smaller than the uncertainty") << QString::number(certainPlace(0.002)) << "-2";
        newRow("smaller than the uncertainty, a power of ten") << QString::number(certainPlace(0.001)) << "-3";
        newRow("smaller than the uncertainty of hundreds") << QString::number(certainPlace(300.0)) << "3";
        newRow("smaller than the uncertainty of infinity")
            << QString::number(certainPlace(std::numeric_limits<double>::infinity())) << "-20";
    }

    void numbersAreWritten()
    {
        QFETCH(QString, is);
        QFETCH(QString, expected);
        QCOMPARE(withPlainSpaces(is), expected);
    }

    void aNumberInAnyRoomIsRightInItsDigits_data()
    {
        addColumn<double>("value");
        addColumn<double>("error"); // negative: unknown
        for (const double value :
             {0.0422343399942, 24.773746776, 103.76353143, 1.0715559448, 9.9996, 0.99999999, 0.3, 1234.5, 5123000.25,
              4.5e9, 6.02e23, 1.2e-7, -0.042234339, -1.5e-300, 2.0 / 3.0, 0.0}) {
            for (const double error : {1.5e-13, 2e-9, 0.05, 300.0, 0.0, -1.0})
                addRow("%.17g within %g", value, error) << value << error;
        }
    }

    /// Whatever the width: the text is read back as the value rounded to the last digit shown, with its
    /// power of ten and its unit, or it is a sign that is no number.
    void aNumberInAnyRoomIsRightInItsDigits()
    {
        QFETCH(double, value);
        QFETCH(double, error);
        const auto known = error < 0.0 ? std::nullopt : std::optional(error);
        const QStringList texts = lengthTexts({value, known}, QStringLiteral("mm"));
        QCOMPARE(texts.front(), lengthText({value, known}, QStringLiteral("mm")));
        static const QRegularExpression number(
            QStringLiteral("^(-?\\d+(?:\\.(\\d+))?(?:e([+-]\\d+))?)(?: ± (?:\\?|[\\d.]+(?: × 10⁻?[⁰-⁹¹²³]+)?))? mm$"));
        const auto size = [](const QString &text) { return static_cast<int>(text.size()); };
        qsizetype before = 0;
        for (int width = 0; width <= texts.front().size() + 1; ++width) {
            const QString text = withPlainSpaces(fittedText(texts, width, size));
            QVERIFY2(text.size() <= std::max(width, 1), qPrintable(text));
            if (text.startsWith(u'#')) {
                QCOMPARE(text, QString(text.size(), u'#'));
                QCOMPARE(before, 0); // more room is never worse
                continue;
            }
            QVERIFY2(text.size() >= before, qPrintable(text));
            before = text.size();
            const QRegularExpressionMatch match = number.match(text);
            QVERIFY2(match.hasMatch(), qPrintable(text));
            const int power = match.captured(3).toInt() - static_cast<int>(match.captured(2).size());
            const double off = std::abs(match.captured(1).toDouble() - value);
            // Without a power of ten, a large error rounds before the decimal point.
            const double place =
                std::max(std::pow(10.0, power), match.captured(2).isEmpty() ? std::max(error, 0.0) * 10.0 : 0.0);
            QVERIFY2(off <= (0.5 + 1e-6) * place, qPrintable(text));
        }
        QCOMPARE(before, texts.front().size());
    }

    void measuresAreWrittenOut()
    {
        const auto fitted = [](double value, double error, int width) {
            return withPlainSpaces(fittedText(lengthTexts({value, error}, QStringLiteral("mm")), width,
                                              [](const QString &text) { return static_cast<int>(text.size()); }));
        };
        // Never "4.2234339994…".
        QCOMPARE(fitted(0.0422343399942, 1.5e-13, 60), QStringLiteral("0.042234339994 ± 1.5 × 10⁻¹³ mm"));
        QCOMPARE(fitted(0.0422343399942, 1.5e-13, 20), QStringLiteral("0.042234339994 mm"));
        QCOMPARE(fitted(0.0422343399942, 1.5e-13, 11), QStringLiteral("0.042234 mm"));
        QCOMPARE(fitted(0.0422343399942, 1.5e-13, 7), QStringLiteral("0.04 mm"));
        QCOMPARE(fitted(0.0422343399942, 1.5e-13, 6), QStringLiteral("####"));
        QCOMPARE(fitted(1.25e-9, 3e-14, 11), QStringLiteral("1.25e-09 mm"));
        QCOMPARE(fitted(1.25e-9, 3e-14, 9), QStringLiteral("1e-09 mm"));
        QCOMPARE(fitted(12.345, 0.05, 60), QStringLiteral("12.35 ± 0.05 mm"));
        QCOMPARE(fitted(12.349, 0.05, 7), QStringLiteral("12.3 mm")); // not from 12.35
    }

    void aSentenceIsNeverCutInANumber()
    {
        const auto size = [](const QString &text) { return static_cast<int>(text.size()); };
        const QString said = QStringLiteral("They were moved onto the mesh by at most 1.23e-05 mm (nasion left).");
        for (int width = 1; width <= said.size(); ++width) {
            const QString shown = elidedSentence(said, width, size);
            QVERIFY2(shown.size() <= width, qPrintable(shown));
            QVERIFY2(shown == said || !shown.contains(u'1') || shown.contains(QStringLiteral("1.23e-05 mm")),
                     qPrintable(shown));
        }
        // A number at the start, and one in Chinese, which has no blanks: with their units, or not at all.
        const QString apart = QStringLiteral("5.2 mm apart from the mesh"),
                      chinese = QStringLiteral("标志点最多移动了1.23e-05\u00a0mm（鼻根），6°");
        for (int width = 1; width < apart.size(); ++width) {
            const QString shown = elidedSentence(apart, width, size);
            QVERIFY2(!shown.contains(u'5') || shown.startsWith(QStringLiteral("5.2 mm")), qPrintable(shown));
        }
        for (int width = 1; width < chinese.size(); ++width) {
            const QString shown = elidedSentence(chinese, width, size);
            QVERIFY2(!shown.contains(u'1') || shown.contains(QStringLiteral("1.23e-05\u00a0mm")), qPrintable(shown));
            QVERIFY2(!shown.contains(u'6'), qPrintable(shown));
        }
        QCOMPARE(elidedSentence(said, 50, size), QStringLiteral("They were moved onto the mesh by at most…"));
        QCOMPARE(elidedSentence(said, 63, size),
                 QStringLiteral("They were moved onto the mesh by at most 1.23e-05 mm (nasion l…"));
        QCOMPARE(elidedSentence(QStringLiteral("标志点最多移动了1.23e-05毫米"), 12, size),
                 QStringLiteral("标志点最多移动…"));
    }

    void theFormulaIsWrittenWithItsNumbers_data()
    {
        addColumn<Pick>("pick");
        addColumn<QString>("expected");

        // z = 20 / (2.5 + 1.5) = 5. x = 0.828427 x (2 x 412.5 / 800 - 1) x 5 / 2 = 0.0647209; y the
        // same with 300.5 / 600.
        newRow("frustum") << picked(frustumGeometry(), 412.0, 299.0, 0.75)
                          << QStringLiteral(
                                 "(13) z = n f / (f (1 − d) + n d)\n"
                                 "  = 2 × 10 / (10 × (1 − 0.75) + 2 × 0.75) = 5\n\n"
                                 "(9) x = (px − vx) (r − l) z / (width · n) + l z / n\n  = (412.5 − 0) × (0.828427 "
                                 "− (−0.828427)) × 5 / (800 × 2) + (−0.828427) × 5 / 2 = 0.0647209\n\n"
                                 "(10) y = (rect.bottom − py − vy) (t − b) z / (height · n) + b z / n\n  = (600 − "
                                 "299.5 − 0) × (0.62132 − (−0.62132)) × 5 / (600 × 2) + (−0.62132) × 5 / 2 = "
                                 "0.00258883\n\n"
                                 "(16) world = eye + x s + y u + z f\n"
                                 "  = (0, 0, 5) + 0.0647209 × (1, 0, 0) + 0.00258883 × (0, 1, 0) + 5 × (0, 0, −1) = "
                                 "(0.0647209, 0.00258883, 0)");

        // A viewport of 400 x 300 from (100, 50); window 0.5 .. 1.5 and -0.5 .. 1 at n = 1, f = 4: z =
        // 4 / (2 + 0.5) = 1.6; x = (200.5 x 1 / 400 + 0.5) x 1.6 = 1.602, y = (100.5 x 1.5 / 300 - 0.5)
        // x 1.6 = 0.004
        Setup offset = frustumGeometry();
        offset.viewport = {100.0, 50.0, 400.0, 300.0};
        offset.projection() = Frustum{0.5, 1.5, -0.5, 1.0, 1.0, 4.0};
        newRow("off-centre frustum in an offset viewport")
            << picked(offset, 300.0, 449.0, 0.5)
            << QStringLiteral(
                   "(13) z = n f / (f (1 − d) + n d)\n"
                   "  = 1 × 4 / (4 × (1 − 0.5) + 1 × 0.5) = 1.6\n\n"
                   "(9) x = (px − vx) (r − l) z / (width · n) + l z / n\n  = (300.5 − 100) × (1.5 − 0.5) × 1.6 / (400 "
                   "× 1) "
                   "+ 0.5 × 1.6 / 1 = 1.602\n\n"
                   "(10) y = (rect.bottom − py − vy) (t − b) z / (height · n) + b z / n\n  = (600 − 449.5 − 50) × (1 − "
                   "(−0.5)) × 1.6 / (300 × 1) + (−0.5) × 1.6 / 1 = 0.004\n\n"
                   "(16) world = eye + x s + y u + z f\n"
                   "  = (0, 0, 5) + 1.602 × (1, 0, 0) + 0.004 × (0, 1, 0) + 1.6 × (0, 0, −1) = (1.602, 0.004, 3.4)");

        // z = 0.75 + 2.25 = 3; x = 350.5 x 6 / 600 - 3 = 0.505; y = 279.5 x 4 / 400 - 2 = 0.795
        const Ortho box{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0};
        newRow("ortho")
            << picked(boxGeometry(box), 350.0, 120.0, 0.25)
            << QStringLiteral(
                   "(14) z = n (1 − d) + f d\n"
                   "  = 1 × (1 − 0.25) + 9 × 0.25 = 3\n\n"
                   "(11) x = (px − vx) (r − l) / width + l\n  = (350.5 − 0) × (3 − (−3)) / 600 + (−3) = 0.505\n\n"
                   "(12) y = (rect.bottom − py − vy) (t − b) / height + b\n  = (400 − 120.5 − 0) × (2 − (−2)) / 400 + "
                   "(−2) "
                   "= 0.795\n\n"
                   "(16) world = eye + x s + y u + z f\n"
                   "  = (10, 20, 30) + 0.505 × (1, 0, 0) + 0.795 × (0, 1, 0) + 3 × (0, 0, −1) = (10.505, 20.795, 27)");

        // The near plane of a box may lie behind the eye: z = -0.75 + 2.25 = 1.5 with n = -1.
        newRow("ortho, negative near")
            << picked(boxGeometry(Ortho{-3.0, 3.0, -2.0, 2.0, -1.0, 9.0}), 50.0, 120.0, 0.25)
            << QStringLiteral(
                   "(14) z = n (1 − d) + f d\n"
                   "  = (−1) × (1 − 0.25) + 9 × 0.25 = 1.5\n\n"
                   "(11) x = (px − vx) (r − l) / width + l\n  = (50.5 − 0) × (3 − (−3)) / 600 + (−3) = −2.495\n\n"
                   "(12) y = (rect.bottom − py − vy) (t − b) / height + b\n  = (400 − 120.5 − 0) × (2 − (−2)) / 400 + "
                   "(−2) "
                   "= 0.795\n\n"
                   "(16) world = eye + x s + y u + z f\n"
                   "  = (10, 20, 30) + (−2.495) × (1, 0, 0) + 0.795 × (0, 1, 0) + 1.5 × (0, 0, −1) = (7.505, 20.795, "
                   "28.5)");

        newRow("oblique")
            << picked(boxGeometry(Oblique{box, radiansFromDegrees(45.0), radiansFromDegrees(90.0)}), 350.0, 120.0, 0.25)
            << QStringLiteral(
                   "(14) z = n (1 − d) + f d\n"
                   "  = 1 × (1 − 0.25) + 9 × 0.25 = 3\n\n"
                   "(11) x0 = (px − vx) (r − l) / width + l\n  = (350.5 − 0) × (3 − (−3)) / 600 + (−3) = 0.505\n\n"
                   "(12) y0 = (rect.bottom − py − vy) (t − b) / height + b\n  = (400 − 120.5 − 0) × (2 − (−2)) / 400 + "
                   "(−2) = 0.795\n\n"
                   "(15) x = x0 + cot θ z\n  = 0.505 + cot 45° × 3 = 3.505\n\n"
                   "(15) y = y0 + cot φ z\n  = 0.795 + cot 90° × 3 = 0.795\n\n"
                   "(16) world = eye + x s + y u + z f\n"
                   "  = (10, 20, 30) + 3.505 × (1, 0, 0) + 0.795 × (0, 1, 0) + 3 × (0, 0, −1) = (13.505, 20.795, 27)");
    }

    void theFormulaIsWrittenWithItsNumbers()
    {
        QFETCH(Pick, pick);
        QFETCH(QString, expected);
        QCOMPARE(withPlainSpaces(formulasOf(pick).text()), expected);
        PanelOfPicks panel;
        panel.setPick(pick);
        QCOMPARE(withPlainSpaces(panel.findChild<FormulaView *>()->formulas().text()), expected);
    }

    void theRayOfABackgroundIsWritten()
    {
        // The pixel (350, 120) of the box above: x = 0.505, y = 0.795 at both ends, z = 1 and 9.
        const Pick pick = picked(boxGeometry(Ortho{-3.0, 3.0, -2.0, 2.0, 1.0, 9.0}), 350.0, 120.0, 1.0, false);
        QCOMPARE(formulasOf(pick).text(), QStringLiteral("p(t) = near + t (far − near), 0 ≤ t ≤ 1\n"
                                                         "  = (10.505, 20.795, 29) + t × (0, 0, −8)"));
        QCOMPARE(certaintyText(pick),
                 QStringLiteral("The ray enters the view volume at (10.505, 20.795, 29) and leaves it "
                                "at (10.505, 20.795, 21)."));
    }

    /// Every text at a survey's coordinates has the certain digits, down to thousandths, and no power
    /// of ten.
    void coordinatesOfASurveyCanBeRead()
    {
        Setup survey = boxGeometry(Ortho{-0.3, 0.3, -0.2, 0.2, 1.0, 9.0});
        survey.camera() = LookAt{WorldPoint(4000000.1231, 500000.4561, 305.789),
                                 WorldPoint(4000000.1231, 500000.4561, 300.789),
                                 {0.0, 1.0, 0.0}};
        // x = 350.5 x 0.6 / 600 - 0.3 = 0.0505, y = 279.5 x 0.4 / 400 - 0.2 = 0.0795; z = 3.
        const QString surface = withPlainSpaces(formulasOf(picked(survey, 350.0, 120.0, 0.25)).text());
        QVERIFY2(surface.contains(QStringLiteral("(4000000.123, 500000.456, 305.789) + 0.0505 × (1, 0, 0)"))
                     && surface.endsWith(QStringLiteral("= (4000000.174, 500000.536, 302.789)")),
                 qPrintable(surface));
        const Pick background = picked(survey, 350.0, 120.0, 1.0, false);
        QCOMPARE(certaintyText(background),
                 QStringLiteral("The ray enters the view volume at (4000000.174, 500000.536, 304.789) and leaves it at "
                                "(4000000.174, 500000.536, 296.789)."));
        QVERIFY(formulasOf(background).text().contains(QStringLiteral("(4000000.174, 500000.536, 304.789)")));
        QVERIFY(errorText(Error{ErrorCode::NearNotBeforeFar, 5000000.0, 4000000.0})
                    .contains(QStringLiteral("Near is 5000000; "
                                             "it must be smaller "
                                             "than far (4000000)")));
    }

    void theCauseOfADifferenceIsNamed()
    {
        PanelOfPicks panel;
        panel.setPick(pickWith({1.0, 2.0, 4.0}, {1.0, 2.0, 4.0 + 1e-12}, {1.0, 2.0, 4.0}, 0.01));
        const QString verdict = labelNamed(panel, "Do the methods agree?")->text();
        QVERIFY2(verdict.contains(QStringLiteral("differ by 1100 ulp: rounding")), qPrintable(verdict));
        const QString cause = withPlainSpaces(labelNamed(panel, "Cause of the difference")->text());
        QVERIFY2(cause.contains(QStringLiteral("magnified")) && cause.contains(QStringLiteral("perspective")),
                 qPrintable(cause));
        QVERIFY(!hasPlaceholder(cause));
        // The reasons are shown on demand.
        panel.show();
        QVERIFY(!labelNamed(panel, "Cause of the difference")->isVisible());
        panel.findChild<VerdictView *>()->findChild<QToolButton *>()->click();
        QVERIFY(labelNamed(panel, "Cause of the difference")->isVisible());
    }

    void theCertaintyIsNamed()
    {
        Pick pick = picked(frustumGeometry(), 412.0, 299.0, 0.75);
        pick.certainty = {1.26e-6, 0.008, 0.0124, 2.26e-6};
        const QString text = withPlainSpaces(certaintyText(pick));
        QVERIFY2(text.contains(QStringLiteral("± 0.000003 along the view")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("depth buffer alone ± 0.0000013")), qPrintable(text));
        // A bound is rounded up.
        for (const auto &[bound, expected] :
             {std::pair{2.26e-6, "0.000003"}, std::pair{3e-6, "0.000003"}, std::pair{1.21e-6, "0.0000013"},
              std::pair{1.95e-6, "0.000002"}, std::pair{9.1e-3, "0.010"}, std::pair{0.25, "0.3"}, std::pair{0.0, "0"}})
            QCOMPARE(boundText(bound), QString::fromLatin1(expected));
        QVERIFY2(text.contains(QStringLiteral("A pixel covers 0.008 × 0.012 here")), qPrintable(text));
    }

    void aLongTextIsQuotedByItsBeginning()
    {
        const QString pasted = QStringLiteral("1 2 3 ").repeated(1000);
        QCOMPARE(typedBeginning(pasted), pasted.left(40) + u'…');
        QCOMPARE(typedBeginning(QStringLiteral("1 x")), QStringLiteral("1 x"));
        QVERIFY2(sizeFaultText(pasted).size() < 150, qPrintable(sizeFaultText(pasted).left(200)));
    }

    void everyErrorHasItsSentence_data()
    {
        addColumn<int>("code");
        addColumn<QStringList>("named");
        std::set<int> codes;
        const auto row = [&codes](const char *name, ErrorCode code, const QStringList &named = {}) {
            codes.insert(static_cast<int>(code));
            newRow(name) << static_cast<int>(code) << named;
        };
        // 0.25 and 7.5 are the values; 0.25 radians are 14.3239 degrees.
        const QString value = QStringLiteral("0.25"), other = QStringLiteral("7.5"), angle = QStringLiteral("14.3239");
        row("not finite", ErrorCode::NotFinite, {value});
        row("near not positive", ErrorCode::NearNotPositive, {value, other});
        row("near not before far", ErrorCode::NearNotBeforeFar, {value, other});
        row("left equals right", ErrorCode::LeftEqualsRight, {value});
        row("bottom equals top", ErrorCode::BottomEqualsTop, {value});
        row("field of view", ErrorCode::FieldOfViewOutOfRange, {angle});
        row("aspect", ErrorCode::AspectNotPositive, {value});
        row("focal length", ErrorCode::FocalLengthIsZero);
        row("empty image", ErrorCode::EmptyImage, {value, other});
        row("shear angle", ErrorCode::ShearAngleOutOfRange, {angle});
        row("eye equals center", ErrorCode::EyeEqualsCenter);
        row("up is zero", ErrorCode::UpIsZero);
        row("up parallel to view", ErrorCode::UpParallelToView);
        row("empty viewport", ErrorCode::EmptyViewport, {value, other});
        row("empty framebuffer", ErrorCode::EmptyFramebuffer, {value, other});
        row("pixel ratio", ErrorCode::PixelRatioNotPositive, {value});
        row("empty depth range", ErrorCode::EmptyDepthRange, {value});
        row("depth outside range", ErrorCode::DepthOutsideRange, {value});
        row("outside the framebuffer", ErrorCode::OutsideFramebuffer, {value, other});
        row("singular matrix", ErrorCode::SingularMatrix);
        row("point at infinity", ErrorCode::PointAtInfinity);
        row("scale is zero", ErrorCode::ScaleIsZero);
        row("rotation axis is zero", ErrorCode::RotationAxisIsZero);
        row("clip plane without a normal", ErrorCode::ClipPlaneHasNoNormal);
        row("matrix not a projection", ErrorCode::MatrixNotAProjection, {value});
        row("viewport not whole", ErrorCode::ViewportNotWhole, {value});
        row("viewport too large", ErrorCode::ViewportTooLarge, {value, other});
        row("framebuffer too large", ErrorCode::FramebufferTooLarge, {value, other});
        row("depth range not drawable", ErrorCode::DepthRangeNotDrawable, {value});
        row("object too far", ErrorCode::ObjectTooFar, {value});
        row("object too small", ErrorCode::ObjectTooSmall, {value});
        row("view not rigid", ErrorCode::ViewNotRigid);
        row("view mirrored", ErrorCode::ViewMirrored);
        QCOMPARE(codes.size(), std::size_t(ErrorCode::ViewMirrored) + 1); // none is left out
    }

    void everyErrorHasItsSentence()
    {
        QFETCH(int, code);
        QFETCH(QStringList, named);
        const QString text = errorText(Error{static_cast<ErrorCode>(code), 0.25, 7.5});
        QVERIFY(text.size() > 15 && text.endsWith(u'.'));
        QVERIFY2(!hasPlaceholder(text), qPrintable(text));
        for (const QString &value : named)
            QVERIFY2(text.contains(value), qPrintable(text));
        if (code == int(ErrorCode::MatrixNotAProjection)
            || code == int(ErrorCode::ViewNotRigid)) // they always have a place
            return;
        const QString nan = errorText(Error{static_cast<ErrorCode>(code)});
        QVERIFY2(!hasPlaceholder(nan), qPrintable(nan));
    }

    /// A name that looks like a placeholder is a name.
    void anErrorOfAFileNamesIt()
    {
        QCOMPARE(errorText(unprojector::base::Error{.text = "the file is empty", .file = "100%1%2.obj"}),
                 QStringLiteral("100%1%2.obj: the file is empty."));
        QCOMPARE(errorText(unprojector::base::Error{"it is too far away", "head", "a.json"}),
                 QStringLiteral("a.json: head: it is too far away."));
        QCOMPARE(errorText(unprojector::base::Error{"the field is empty"}), QStringLiteral("the field is empty."));
    }
};

UNPROJECTOR_TEST(TestComparisonTexts)
#include "test_comparison_texts.moc"

// The matrices of one camera as many programs print them, among sizes, labels and other numbers.

#include "tests/support/test.h"

#include "core/base/error.h"
#include "core/cameras/named_values.h"
#include "core/cameras/pasted_numbers.h"
#include "tests/core/cameras/pasted_text.h"
#include "tests/support/data_files.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

/// NDC x and y of a world point.
glm::dvec2 ndc(const glm::dmat4 &clipFromWorld, const glm::dvec3 &point)
{
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(point, 1.0);
    return {clip.x / clip.w, clip.y / clip.w};
}

/// The largest difference from the camera in NDC, at points in front of it.
double offFromCamera(const glm::dmat4 &clipFromWorld)
{
    const glm::dmat4 right = glm::perspective(glm::radians(50.0), 4.0 / 3.0, 0.1, 100.0)
                             * glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.2, 0.1, 0), glm::dvec3(0, 1, 0));
    double off = 0.0;
    for (const glm::dvec3 point :
         {glm::dvec3(0.2, 0.1, 0), glm::dvec3(1, 0.5, -1), glm::dvec3(-1, 0.3, 0.7), glm::dvec3(0.5, -0.8, 1)}) {
        const glm::dvec2 difference = ndc(clipFromWorld, point) - ndc(right, point);
        off = std::max({off, std::abs(difference.x), std::abs(difference.y)});
    }
    return off;
}

QString asideOf(const char *text)
{
    QStringList names;
    const auto scene = pastedParts(text);
    if (scene) {
        for (const std::string &name : scene->aside)
            names << QString::fromStdString(name);
    }
    return names.join(QLatin1Char(' '));
}

} // namespace

class TestPastedKinds : public QObject {
    Q_OBJECT

private slots:
    /// Each file of tests/data/printed is one camera as a program or a debugger prints it: view,
    /// projection (or their product) and a viewport of 800 x 600 pixels.
    void theCameraIsRead_data()
    {
        addColumn<QByteArray>("printed");
        for (const std::filesystem::path &file : data_files::in("printed"))
            newRow(file.stem().string().c_str()) << QByteArray::fromStdString(data_files::read(file));
    }

    void theCameraIsRead()
    {
        QFETCH(QByteArray, printed);
        const std::string text = printed.toStdString();
        constexpr double kPrinted = 2e-3; // four printed digits
        const PastedCamera camera = pasted(text);
        QVERIFY2(camera.projection && camera.eyeFromWorld, camera.fault ? camera.fault->message().c_str() : "");
        const auto *given = std::get_if<MatrixProjection>(&*camera.projection);
        const glm::dmat4 lens = given ? given->clipFromEye : *clipFromEye(std::get<Projection>(*camera.projection));
        const double off = offFromCamera(lens * *camera.eyeFromWorld);
        QVERIFY2(off < kPrinted, qPrintable(QString::number(off)));
        const auto scene = pastedParts(text);
        QVERIFY(scene && scene->viewport);
        QVERIFY(*scene->viewport == (Viewport{0, 0, 800, 600}));
    }

    /// Texts in which every number counts, unlike sizes, labels and times.
    void numbersOfMatricesStay_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QVector<double>>("numbers");
        const auto add = [](const char *text, const QVector<double> &numbers) {
            newRow(text) << QByteArray(text) << numbers;
        };
        add("1, 2, 3, 4", {1, 2, 3, 4});
        add("1,2,3,4\n5,6,7,8", {1, 2, 3, 4, 5, 6, 7, 8});
        add("(16) 5 6", {16, 5, 6});
        add("m[0] = 1", {1});
        add("m[1][2] = 3", {3});
        add("0 1 2 3\n0 1 2 3 4", {0, 1, 2, 3, 0, 1, 2, 3, 4});
        add("1.5, 2.5, 3,5", {1.5, 2.5, 3, 5});
        add("x = 1, y = 2, z = 3", {1, 2, 3});
        add("Vector(16) 3", {16, 3});
        add("[3, 4]", {3, 4});
        add("1e5 2E-3", {1e5, 2e-3});
        add("0:1 1:2", {1, 2});
        add("12-05-2024", {});
        add("0x10", {});
    }

    void numbersOfMatricesStay()
    {
        QFETCH(QByteArray, text);
        QFETCH(QVector<double>, numbers);
        const auto read = pastedNumbers(text.toStdString());
        QCOMPARE(bool(read), !numbers.isEmpty());
        QVector<double> values;
        for (std::size_t i = 0; read && i < read->numbers.size(); ++i)
            values << read->numbers[i].value;
        QCOMPARE(values, numbers);
    }

    void computedValuesKeepTheirFirstOperand_data()
    {
        addColumn<QByteArray>("value");
        addColumn<QVector<double>>("numbers");
        addColumn<QByteArray>("arithmetic");
        const auto add = [](const char *value, const QVector<double> &numbers, const char *arithmetic) {
            newRow(value) << QByteArray(value) << numbers << QByteArray(arithmetic);
        };
        add("-0.3 / 2", {-0.3}, "/ 2");
        add("1280/2", {1280}, "/ 2");
        add("1200 / (2 * 3), 5", {1200, 5}, "/ (2 * 3), 5");
        add("60 * np.pi / 180", {60}, "* np.pi / 180");
        add("1280 - 80;", {1280}, "- 80");
        add("1200 + 20 + 3", {1200}, "+ 20 + 3");
        add("(1280 - 1) / 2", {1280}, "- 1) / 2");
        add("[1, 2, 5] + [1, 1, 1]", {1, 2, 5, 1, 1, 1}, "+ [1, 1, 1]");
        add("np.array([1, 2]) / 1000", {1, 2}, "/ 1000");
        add("Matrix(((1, 2), (3, 4))).inverted()", {1, 2, 3, 4}, "inverted");
        add("Matrix(((1, 2), (3, 4))).inverted_safe()", {1, 2, 3, 4}, "invertedsafe");
        add("Matrix(((1, 2), (3, 4))).transposed()", {1, 2, 3, 4}, "transposed");
        add("(cv::Mat_<double>(1, 2) << 1, 2).t()", {1, 2}, "t");
        add("[1, 2]\nt(5)", {1, 2, 5}, "");
        add("5\n6", {5, 6}, "");
    }

    void computedValuesKeepTheirFirstOperand()
    {
        QFETCH(QByteArray, value);
        QFETCH(QVector<double>, numbers);
        QFETCH(QByteArray, arithmetic);
        const NamedValues values("fx = " + value.toStdString());
        const NamedValue *found = values.find({"fx"});
        QVERIFY(found);
        QCOMPARE(QVector<double>(found->numbers.begin(), found->numbers.end()), numbers);
        QCOMPARE(QByteArray::fromStdString(found->arithmetic), arithmetic);
    }

    /// A matrix's numbers all count: its reader must not take the first operands alone for it.
    void operandsInMatricesCount()
    {
        const auto matrix = pastedMatrix("[1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1] / 5");
        QVERIFY(!matrix);
        QCOMPARE(matrix.error().found, std::size_t(17));
    }

    void largeSubscriptsTellNothing()
    {
        for (const char *text : {"m[2000000000][3] = 1", "m[3000000000] = 1", "{\"2000000000\": 1}", "m[17] = 1"}) {
            const auto read = pastedNumbers(text);
            QVERIFY2(read && read->numbers.size() == 1, text);
            QVERIFY2(read->numbers[0].subscripts.empty(), text);
        }
        const auto read = pastedNumbers("m[16] = 1");
        QVERIFY(read && read->numbers.at(0).subscripts == std::vector{16});
    }

    void infinityIsFound()
    {
        for (const char *text : {"-inf", "+inf", "-nan", "+nan", "inf", "nan"}) {
            const std::vector<double> numbers = NamedValues("k = 1 " + std::string(text)).numbers({"k"}, 2);
            QVERIFY2(numbers.size() == 2 && !std::isfinite(numbers[1]), text);
        }
    }

    /// Megabytes of signs are read in linear time.
    void runsOfSignsEnd()
    {
        for (const char sign : {'-', '+', '.', '*'})
            QCOMPARE(scan("a = " + std::string(2000000, sign) + " 5").back().numbers.size(), std::size_t(1));
        std::string products = "a = b";
        while (products.size() < 1000000)
            products += "*b";
        QCOMPARE(scan(products).size(), std::size_t(3));
    }

    void textsOfTooManyNamesAreRefused()
    {
        std::string text;
        while (text.size() < 4400000)
            text += "a 1\n";
        const auto read = pastedNumbers(text);
        QVERIFY(!read);
        QCOMPARE(QByteArray::fromStdString(read.error().text),
                 QByteArray("the text has more than 500000 names; give the part that has the camera"));
        QVERIFY(read.error().line > 499990);
        try {
            const NamedValues values(text);
            QFAIL("all names were read");
        } catch (const base::Error &error) {
            QCOMPARE(error.text, read.error().text);
        }
        text.resize(1900000);
        QVERIFY(NamedValues(text).all().size() > 400000);
    }

    void numbersAsideAreNamed()
    {
        QCOMPARE(asideOf("near = 0.1\nfar = 100\nview 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"), QStringLiteral("near far"));
        QCOMPARE(asideOf("view 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nMouse: 312, 204"), QStringLiteral("Mouse"));
        QCOMPARE(asideOf("view 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nviewport 0 0 8 6\nwidth 8"), QStringLiteral("width"));
        QCOMPARE(asideOf("view 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nwidth 8 height 6"), QString());
        const PastedCamera camera = pasted("near = 0.1\n1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1");
        QCOMPARE(camera.aside, std::vector<std::string>{"near"});
        QVERIFY(camera.eyeFromWorld && !camera.projection);
        // The numbers of the next line are a matrix's again.
        const auto scene = pastedParts("depth 0.98\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1");
        QVERIFY(scene && scene->modelView);
    }

    void repeatedSizesAreOneSize_data()
    {
        addColumn<QString>("sizes");
        addColumn<QString>("aside");
        newRow("the same") << "width = 800\nheight = 600\nsize = 800x600"
                           << "";
        newRow("the same in two numbers") << "size = 800 600\nresolution 800 600"
                                          << "";
        newRow("each twice") << "width = 800\nwidth = 800\nheight = 600\nheight = 600"
                             << "";
        newRow("a width before both") << "width = 800\nsize = 800x600"
                                      << "";
        newRow("both before a height") << "size = 800x600\nheight = 600"
                                       << "";
        newRow("another size") << "width = 800\nheight = 600\nsize = 400x300"
                               << "size";
        newRow("another width") << "width = 800\nwidth = 640\nheight = 600"
                                << "width";
        newRow("a matrix's size first") << "size = 4x4\nwindow size = 800x600"
                                        << "";
    }

    void repeatedSizesAreOneSize()
    {
        QFETCH(QString, sizes);
        QFETCH(QString, aside);
        const std::string matrices =
            "view 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nprojection 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n";
        for (const std::string &text : {matrices + sizes.toStdString(), sizes.toStdString() + '\n' + matrices}) {
            const auto scene = pastedParts(text);
            QVERIFY2(scene, scene ? "" : scene.error().text.c_str());
            QVERIFY(scene->viewport && *scene->viewport == (Viewport{0, 0, 800, 600}));
            QCOMPARE(asideOf(text.c_str()), aside);
        }
    }

    void rowsAreCompleted()
    {
        const auto bottomOf = [](const char *text) {
            const auto matrix = pastedMatrix(text);
            return matrix ? matrixOf(matrix->numbers, orderOf(matrix->form)) : glm::dmat4(0.0);
        };
        glm::dmat4 right(1.0);
        right[3] = {4, 8, 12, 1};
        right[0][1] = 5;
        for (const char *text :
             {"[[1, 0, 0, 4], [5, 1, 0, 8], [0, 0, 1, 12]]", "1 0 0 4\n5 1 0 8\n0 0 1 12",
              "[1, 0, 0, 4; 5, 1, 0, 8; 0, 0, 1, 12]", "[X: (1, 5, 0), Y: (0, 1, 0), Z: (0, 0, 1), O: (4, 8, 12)]"})
            QVERIFY2(bottomOf(text) == right, text);
        // Twelve numbers in one row may be anything.
        QVERIFY(!pastedMatrix("1 0 0 4 5 1 0 8 0 0 1 12"));
        QVERIFY(!pastedMatrix("1 0 0\n5 1 0\n0 0 1\n4 8 12"));
    }
};

UNPROJECTOR_TEST(TestPastedKinds)
#include "test_pasted_kinds.moc"

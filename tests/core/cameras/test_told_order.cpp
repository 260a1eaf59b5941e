// The order of the numbers of pasted matrices, as the command's options and the window's dialog
// give it.
#include "tests/core/cameras/fault_names.h"
#include "tests/core/cameras/pasted_text.h"
#include "tests/support/test.h"

#include "core/cameras/told_order.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <string>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
}

glm::dmat4 turn()
{
    return glm::dmat4(glm::dmat3(view()));
}

glm::dmat4 lens()
{
    return glm::perspective(glm::radians(45.0), 4.0 / 3.0, 1.0, 100.0);
}

/// Near 1/2, far at infinity: it is its own transpose.
glm::dmat4 symmetricLens()
{
    glm::dmat4 m(0.0);
    m[0][0] = 1.5;
    m[1][1] = 2.0;
    m[2][2] = m[2][3] = m[3][2] = -1.0;
    return m;
}

BothOrders read(MatrixRole role, const glm::dmat4 &usual, MatrixForm form = MatrixForm::NestedRows)
{
    return {role, form, usual, glm::transpose(usual)};
}

std::vector<ToldOrder> told(const std::vector<BothOrders> &matrices, const std::optional<double> &aspect = std::nullopt)
{
    return toldOrders(matrices, aspect);
}

/// Four brackets of four, row after row.
std::string nested(const glm::dmat4 &m)
{
    std::string text = "[";
    for (int row = 0; row < 4; ++row) {
        text += '[';
        for (int column = 0; column < 4; ++column)
            text += QByteArray::number(m[column][row], 'g', 17).toStdString() + ' ';
        text += "]\n";
    }
    return text + "]\n";
}

std::vector<std::string> idsOf(const std::vector<MatrixFinding> &found)
{
    std::vector<std::string> ids;
    for (const MatrixFinding &finding : found)
        ids.emplace_back(idOf(finding.fault));
    return ids;
}

using Ids = std::vector<std::string>;

} // namespace

class TestToldOrder : public QObject {
    Q_OBJECT

private slots:
    void aMatrixTellsByItself()
    {
        using enum MatrixRole;
        for (const BothOrders &right : {read(View, view()), read(Projection, lens()), read(Product, lens() * view()),
                                        read(View, glm::inverse(view())), read(Projection, glm::inverse(lens()))}) {
            QVERIFY(told({right}) == std::vector{ToldOrder::Usual});
            QVERIFY(told({read(right.role, right.other)}) == std::vector{ToldOrder::Other});
        }
        // Each matrix is judged independently of the others.
        QVERIFY(told({read(View, glm::transpose(view())), read(Projection, lens())})
                == (std::vector{ToldOrder::Other, ToldOrder::Usual}));
    }

    void whatOnlyTurnsGoesByTheOthers()
    {
        using enum MatrixRole;
        QVERIFY(told({read(View, turn()), read(Projection, lens())})
                == (std::vector{ToldOrder::Usual, ToldOrder::Usual}));
        QVERIFY(told({read(View, turn()), read(Projection, glm::transpose(lens()))})
                == (std::vector{ToldOrder::OtherAsOthers, ToldOrder::Other}));
        // A matrix of another form settles the meaning of forms here, but not the other order.
        QVERIFY(told({read(View, turn()), read(Projection, lens(), MatrixForm::Flat)})
                == (std::vector{ToldOrder::Usual, ToldOrder::Usual}));
        QVERIFY(told({read(View, turn()), read(Projection, glm::transpose(lens()), MatrixForm::Flat)})
                == (std::vector{ToldOrder::Open, ToldOrder::Other}));
    }

    void whatNothingTellsStaysOpen()
    {
        using enum MatrixRole;
        QVERIFY(told({read(View, turn())}) == std::vector{ToldOrder::Open});
        QVERIFY(told({read(View, turn()), read(Projection, symmetricLens())})
                == (std::vector{ToldOrder::Open, ToldOrder::Usual}));
        // The same in both orders: nothing is left open.
        QVERIFY(told({read(View, glm::dmat4(1.0)), read(Projection, symmetricLens())})
                == (std::vector{ToldOrder::Usual, ToldOrder::Usual}));
    }

    void betweenTwoCamerasPixelsAreSquare()
    {
        using enum MatrixRole;
        // A quarter turn about the view's axis: in the other order the picture is turned the other way,
        // and high instead of wide.
        const glm::dmat4 roll(glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1));
        const BothOrders product = read(Product, symmetricLens() * roll);
        QVERIFY(told({product}) == std::vector{ToldOrder::Open});
        QVERIFY(told({product}, 4.0 / 3.0) == std::vector{ToldOrder::Usual});
        QVERIFY(told({read(Product, product.other)}, 4.0 / 3.0) == std::vector{ToldOrder::Other});
        QVERIFY(told({product}, 2.0) == std::vector{ToldOrder::Open});
    }

    void whatIsNoCamerasTellsNothing()
    {
        glm::dmat4 any(1.0);
        for (int i = 0; i < 16; ++i)
            any[i / 4][i % 4] += (i * 7 % 11) / 3.0;
        for (const MatrixRole role : {MatrixRole::View, MatrixRole::Projection, MatrixRole::Product})
            QVERIFY(told({read(role, any), read(role, glm::dmat4(0.0))})
                    == (std::vector{ToldOrder::Usual, ToldOrder::Usual}));
    }

    void pastedMatricesAreReadSo()
    {
        const std::string turned = "view = " + nested(glm::transpose(turn()));
        const PastedCamera camera = pasted(turned + "projection = " + nested(glm::transpose(lens())));
        const ReadMatrix *projection = matrixOf(camera, MatrixRole::Projection),
                         *view = matrixOf(camera, MatrixRole::View);
        QCOMPARE(projection->matrix, lens());
        QCOMPARE(view->matrix, turn());
        QVERIFY(view->order == NumberOrder::ByColumns);
        QCOMPARE(idsOf(projection->findings), Ids{"other-order"});
        QCOMPARE(idsOf(view->findings), Ids{"order-of-others"});
        // Without the matrix that gave the order:
        QVERIFY(pasted(turned).matrices[0].order == NumberOrder::ByRows);
    }

    void anOrderThatIsChosenCounts()
    {
        const std::string text = nested(glm::transpose(view()));
        const ReadMatrix read = pasted(text).matrices.at(0);
        QCOMPARE(read.matrix, view());
        PasteChoices choices;
        choices.corrections.push_back({MatrixRole::View, read.findings.at(0)});
        QCOMPARE(pasted(text, choices).matrices[0].matrix, glm::transpose(view()));
        const ReadMatrix transposed = pasted(text, choices).matrices[0];
        QCOMPARE(idsOf(transposed.findings), Ids{"transposed"});
        choices.corrections.push_back({MatrixRole::View, transposed.findings[0]});
        QCOMPARE(pasted(text, choices).matrices[0].matrix, view());
    }

    void anOpenOrderIsFound()
    {
        const ReadMatrix read = pasted(nested(turn())).matrices.at(0);
        QCOMPARE(idsOf(read.findings), Ids{"order-open"});
        QCOMPARE(read.matrix, turn());
    }
};

UNPROJECTOR_TEST(TestToldOrder)
#include "test_told_order.moc"

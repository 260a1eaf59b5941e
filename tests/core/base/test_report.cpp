// A report says the same in a terminal and in a document.

#include "tests/support/test.h"

#include "core/base/translation.h"
#include "core/report/report.h"

#include <string>

using namespace unprojector;
using namespace unprojector::report;

namespace {

/// One of each block, with what a file may bring: a control character, a tag, quotes.
Report whole()
{
    Rows rows{10};
    rows.add("world", {{"1.5 ", Piece::Look::Plain}, {"-2", Piece::Look::Strong}, {" 3", Piece::Look::Code}});
    rows.add("a \x1b[31m", "<b> & \"b\"");
    return {
        {"first", {Paragraph{"A sentence."}, rows, Note{{{"see "}, {"this", Piece::Look::Plain, "help:picking#a"}}}}},
        {"", {Table{{"method", "x"}, {{"formula", "1"}, {"matrix", "-12.5"}}}}, false, "table"},
        {"code", {Code{{"if (a < b)", "    f();"}}}, true},
    };
}

} // namespace

class TestReport : public QObject {
    Q_OBJECT

private slots:
    void terminalHasAlignedLines()
    {
        QCOMPARE(asText(whole()), std::string("first\n"
                                              "  A sentence.\n"
                                              "  world     1.5 -2 3\n"
                                              "  a \\x1b[31m<b> & \"b\"\n"
                                              "note: see this\n"
                                              "  method       x\n"
                                              "  formula      1\n"
                                              "  matrix   -12.5\n"
                                              "\n"
                                              "code\n"
                                              "  if (a < b)\n"
                                              "      f();\n"));
        QCOMPARE(asText({}), std::string());
    }
    void chineseTakesTwoColumnsASign()
    {
        base::setLanguage(base::Language::Chinese);
        Rows rows{8};
        rows.add("深度", "1");
        const std::string text = asText({{"", {rows, Note{"x"}}}});
        base::setLanguage(base::Language::English);
        QVERIFY2(text.starts_with("  深度    1\n"), text.c_str());
        QVERIFY2(!text.ends_with("note: x\n"), text.c_str());
    }
    void documentEscapesWhatIsText()
    {
        const std::string html = asHtml(whole());
        for (const char *part :
             {"<h3>first</h3>", "<p>A sentence.</p>", "<td>1.5 <b>-2</b><code> 3</code></td>",
              "<td>a \\x1b[31m</td><td>&lt;b&gt; &amp; &quot;b&quot;</td>", "see <a href=\"help:picking#a\">this</a>",
              "<a name=\"table\"></a>", "<th align=\"left\">method</th><th align=\"right\">x</th>",
              "<td align=\"right\">-12.5</td>", "<pre>if (a &lt; b)\n    f();\n</pre>"})
            QVERIFY2(html.find(part) != html.npos, part);
        QVERIFY(html.find("<h3></h3>") == html.npos);
    }
};

UNPROJECTOR_TEST(TestReport)
#include "test_report.moc"

// The templates of generated code: their tags, their mistakes, and that each can be filled for every
// kind of scene.

#include "tests/support/test.h"

#include "core/scene_code/code_template.h"
#include "core/scene_code/scene_code.h"
#include "tests/scene_code/core_clicks.h"

using namespace unprojector::scene_code;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;

namespace {

Values values()
{
    const auto row = [](std::size_t k) { return Values{{"k", std::to_string(k)}, {"isFirst", k == 0}}; };
    return {{"name", "n"}, {"tags", "<<name>>"}, {"empty", ""},          {"yes", true},
            {"no", false}, {"k", "outside"},     {"rows", Rows{3, row}}, {"none", Rows{}}};
}

} // namespace

class TestCodeTemplate : public QObject {
    Q_OBJECT

private slots:
    void tagsAreFilled_data()
    {
        addColumn<std::string>("source");
        addColumn<std::string>("expected");
        const auto row = [](const char *name, const char *source, const char *expected) {
            newRow(name) << std::string(source) << std::string(expected);
        };
        row("nothing", "", "");
        row("no tag", "a < b > c >> 1\n", "a < b > c >> 1\n");
        row("text", "int <<name>> = {<<name>>};\n", "int n = {n};\n");
        row("a text is not read for tags", "<<tags>>", "<<name>>");
        row("if", "a<<if yes>>b<<end>>c<<if no>>d<<end>>", "abc");
        row("if not", "<<if not yes>>a<<else if not no>>b<<end>>", "b");
        row("else", "<<if no>>a<<else>>b<<end>>", "b");
        row("else if: the first that holds", "<<if no>>a<<else if name>>b<<else if yes>>c<<else>>d<<end>>", "b");
        row("a text holds unless empty", "<<if name>>a<<end>><<if empty>>b<<end>>", "a");
        row("rows hold unless there are none", "<<if rows>>a<<end>><<if none>>b<<end>>", "a");
        row("for", "<<for rows>><<k>>;<<end>>", "0;1;2;");
        row("for, between", "[<<for rows>><<k>><<between>>, <<end>>]", "[0, 1, 2]");
        row("for, no row", "[<<for none>><<unknown>><<between>>, <<end>>]", "[]");
        row("names from outside", "<<for rows>><<name>><<if isFirst>>!<<end>><<between>><<k>><<end>>",
            "n!outsidenoutsiden");
        row("within each other", "<<if no>><<for rows>><<if yes>>a<<else>>b<<end>><<end>><<else>>c<<end>>", "c");
        row("a line with a tag alone", "{\n    <<if yes>>\n    a\n    <<else>>\n    b\n  <<end>>\n}\n",
            "{\n    a\n}\n");
        row("the first line, the last line", "<<for rows>>\n<<k>>\n<<end>>", "0\n1\n2\n");
        row("a line with more", "<<if yes>> \na<<end>>\n<<name>>\n", " \na\nn\n");
    }

    void tagsAreFilled()
    {
        QFETCH(std::string, source);
        QFETCH(std::string, expected);
        QCOMPARE(filled(source, values()), expected);
    }

    void mistakesAreFound_data()
    {
        addColumn<std::string>("source");
        addColumn<int>("line");
        addColumn<std::string>("tag");
        const auto row = [](const char *name, const char *source, int line, const char *tag) {
            newRow(name) << std::string(source) << line << std::string(tag);
        };
        row("unknown name", "a\n<<nam>>\n<<other>>", 2, "nam");
        row("no name", "<<>>", 1, "");
        row("unknown condition", "<<if no>><<else if yess>><<end>>", 1, "else if yess");
        row("unknown rows", "<<for row>><<end>>", 1, "row");
        row("a condition as text", "<<yes>>", 1, "yes");
        row("rows as text", "<<rows>>", 1, "rows");
        row("a text as rows", "<<for name>><<end>>", 1, "name");
        row("a row's name outside", "<<isFirst>>", 1, "isFirst");
        row("if without end", "\n\n<<if yes>>\n<<if no>>\n<<end>>\n", 3, "if yes");
        row("for without end", "<<for rows>><<k>>", 1, "for rows");
        row("skipped without end", "<<if no>>\n<<for rows>>\n<<end>>", 1, "if no");
        row("end too many", "a\n<<end>>", 2, "end");
        row("else without if", "<<else>>", 1, "else");
        row("else in for", "<<for rows>><<else>><<end>>", 1, "for rows");
        row("between in if", "<<if yes>><<between>><<end>>", 1, "if yes");
        row("open tag", "a\n<<name", 2, "<<name");
    }

    void mistakesAreFound()
    {
        QFETCH(std::string, source);
        try {
            filled(source, values());
            QFAIL("no mistake is found");
        } catch (const TemplateError &error) {
            QTEST(int(error.line), "line");
            QTEST(error.tag, "tag");
        }
    }

    /// sceneCode has no other mistakes than its templates'.
    void everyKindOfSceneFillsEachTemplate()
    {
        Frustum skewed;
        skewed.skew = 0.25;
        std::vector<std::variant<Projection, MatrixProjection>> projections = {
            Projection{Frustum{}},     Projection{skewed},    Projection{Ortho{}},
            Projection{Perspective{}}, Projection{Oblique{}}, Projection{Pinhole{}}};
        for (const char *name : {"matrices", "general_matrix", "ortho_matrix", "perspective_matrix"})
            projections.push_back(core_clicks::sceneNamed(name).projection);
        glm::dmat4 singleEye(1.0);
        singleEye[3] = {1.0, 2.0, 3.0, 1.0};
        const SceneFile full = core_clicks::sceneNamed("frustum");
        for (const auto &projection : projections) {
            for (const bool isFull : {false, true}) {
                SceneFile scene = isFull ? full : SceneFile();
                scene.projection = projection;
                if (isFull) {
                    scene.viewport = Viewport{0.5, 0.0, 30.0, 40.0};
                    scene.depthRange = {1.0, -0.5};
                    scene.devicePixelRatio = 1.5;
                    scene.view = singleEye;
                }
                for (const CodeDialect dialect :
                     {CodeDialect::Glu, CodeDialect::Glm, CodeDialect::Qt, CodeDialect::ThreeJs, CodeDialect::NumPy}) {
                    const std::string code = sceneCode(scene, dialect);
                    QVERIFY2(code.ends_with('\n') && code.find("<<") == std::string::npos, code.c_str());
                    QVERIFY2(code.find(">>") == std::string::npos, code.c_str());
                }
            }
        }
    }
};

UNPROJECTOR_TEST(TestCodeTemplate)
#include "test_code_template.moc"

// The parser of JSON agrees with the library's, and is stricter where it says so.

#include "core/base/json.h"

#include "tests/support/test.h"

#include <nlohmann/json.hpp>

using namespace unprojector::base;

namespace {

QByteArray messageFor(const std::string &text)
{
    const auto json = parseJson(text, "f");
    return json ? QByteArray("it was read") : QByteArray::fromStdString(json.error().message());
}

std::string objectWith(int keys, const std::string &more)
{
    std::string text = "{";
    for (int i = 0; i < keys; ++i)
        text += "\"k" + std::to_string(i) + "\": " + std::to_string(i) + ",\n";
    return text + more + "}";
}

} // namespace

class TestJson : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadAsByTheLibrary()
    {
        // All texts of up to six of these.
        const std::vector<std::string> parts{"{", "}", "[", "]", ",", ":", "\"a\"", "-1.5e3", "0", "true", " "};
        std::vector<std::string> texts{""};
        for (int length = 1; length <= 6; ++length) {
            std::vector<std::string> longer;
            for (const std::string &text : texts) {
                for (const std::string &part : parts) {
                    longer.push_back(text + part);
                    const auto read = parseJson(longer.back());
                    const Json expected = Json::parse(longer.back(), nullptr, false);
                    QVERIFY2(read.hasValue() == !expected.is_discarded(), longer.back().c_str());
                    QVERIFY2(!read || *read == expected, longer.back().c_str());
                }
            }
            // A text that is wrong already is not longer; nor one whose first part stays the same.
            std::erase_if(longer, [](const std::string &text) {
                const auto read = parseJson(text);
                return !read && read.error().text.find("ends too early") == std::string::npos;
            });
            texts = std::move(longer);
        }
    }

    void escapesAreReadAsByTheLibrary()
    {
        for (const char *text :
             {"\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"", "\"\\u0041\\u00e4\\u20ac\\ud83d\\ude00\"", "\"\\uD83D\\uDE00x\"",
              "{\"\\u0061\": \"\\\\u0061\"}", "\"\xC3\xA4\xF0\x9F\x98\x80\x7F\""}) {
            const auto read = parseJson(text);
            QVERIFY2(read, text);
            QVERIFY2(*read == Json::parse(text), text);
        }
        for (const char *text :
             {"\"\\x\"", "\"\\u12g4\"", "\"\\ud83d\"", "\"\\ude00\"", "\"\\ud83d\\u0041\"", "\"\\\""}) {
            QVERIFY2(!parseJson(text), text);
            QVERIFY2(!Json::accept(text), text);
        }
    }

    void numbersKeepTheirDigits_data()
    {
        addColumn<QByteArray>("number");
        addColumn<QByteArray>("written");
        const auto row = [](const char *number, const char *written) {
            newRow(number) << QByteArray(number) << QByteArray(written);
        };
        for (const char *same :
             {"0", "-7", "18446744073709551615", "18446744073709551616", "-9223372036854775809", "0.5",
              "0.1000000000000000000001", "12345678901234567890.5e-3", "123456789012345678e-400"})
            row(same, same);
        row("1.50", "1.5");
        row("1E5", "100000.0");
        row("1e-400", "0.0");
        row("-0", "0");
        row("-0.0", "-0.0");
    }

    void numbersKeepTheirDigits()
    {
        QFETCH(QByteArray, number);
        QFETCH(QByteArray, written);
        const auto read = parseJson(number.toStdString());
        QVERIFY(read && isJsonNumber(*read));
        QCOMPARE(QByteArray::fromStdString(compactJson(*read)), written);
        QCOMPARE(valueOfJsonNumber(*read), Json::parse(number.toStdString()).get<double>());
    }

    void mistakesAreRefusedWithTheirPlace()
    {
        QCOMPARE(messageFor("[1,\n 1e400]"), "f:2:2: 1e400 is too large for a number");
        QCOMPARE(messageFor("[01]"), "f:1:2: 01 is not a number; write one such as 1, -0.5 or 2e3");
        QCOMPARE(messageFor("1 \"x"), "f:1:3: \"x follows the end");
        QCOMPARE(messageFor("{\"a\": 1} x"), "f:1:10: x follows the end");
        QCOMPARE(messageFor("\xEF\xBB\xBF[x]"), "f:1:2: x found where a value is expected");
        QCOMPARE(messageFor(std::string(64, '[') + std::string(64, ']')), "it was read");
        QVERIFY(messageFor(std::string(65, '[')).startsWith("f:1:65: brackets are nested deeper"));
    }

    void aKeyTwiceIsRefusedInSmallAndLargeObjects()
    {
        for (const int keys : {1, 15, 16, 17, 40}) {
            QCOMPARE(messageFor(objectWith(keys, "\"x\": 0")), "it was read");
            for (const int again : {0, keys - 1}) {
                const QByteArray where =
                    "f:" + QByteArray::number(keys + 1) + ":1: the key \"k" + QByteArray::number(again);
                QCOMPARE(messageFor(objectWith(keys, "\"k" + std::to_string(again) + "\": 0")),
                         where + "\" is here for the second time");
            }
        }
        // The value of a key that nobody reads may have them.
        const auto isUnread = [](std::string_view object, std::string_view key) { return object == "o" && key == "u"; };
        QVERIFY(checkJson(R"({"o": [{"u": {"a": [{"b": 1, "b": 2}]}}]})", 8, isUnread));
        QVERIFY(!checkJson(R"({"o": [{"u": 1, "v": {"b": 1, "b": 2}}]})", 8, isUnread));
        QVERIFY(!checkJson(R"({"o": {"u": 1, "u": 2}})", 8, isUnread));
        QVERIFY(!checkJson("[[1]]", 1, isUnread));
    }

    void aPathHasItsPlace()
    {
        const std::string text = "{\"a\": [0, {\"b\\n\":\n 1}],\n\"c\": 2, nonsense";
        Error error;
        QVERIFY(setPlace(error, text, {{"a"}, {{}, 1}, {"b\n"}}));
        QCOMPARE(error.subject, std::string("a[1].b\n"));
        QVERIFY(error.line == 2 && error.column == 2);
        QVERIFY(setPlace(error, text, {{"c"}}));
        QVERIFY(error.line == 3 && error.column == 6);
        QVERIFY(!setPlace(error, text, {{"d"}}));
        QVERIFY(!setPlace(error, text, {{"a"}, {{}, 2}}));
        QVERIFY(!setPlace(error, text, {{"c"}, {"d"}}));
    }
};

UNPROJECTOR_TEST(TestJson)
#include "test_json.moc"

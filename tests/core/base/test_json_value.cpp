#include "tests/support/test.h"

#include "core/base/json.h"

#include <nlohmann/json.hpp>

using unprojector::base::JsonValue;
using Json = nlohmann::ordered_json;

class TestJsonValue : public QObject {
    Q_OBJECT

private slots:
    void isNullAtFirst()
    {
        QVERIFY(JsonValue().json().is_null());
        QVERIFY(JsonValue() == JsonValue(Json()));
        JsonValue made;
        made.edit()["a"] = 1;
        QVERIFY(made == JsonValue(Json{{"a", 1}}));
        made.edit() = nullptr;
        QVERIFY(made == JsonValue());
    }

    void valuesCompareByContent()
    {
        const JsonValue one(Json::parse(R"({"a": [1, 2]})")), same(Json::parse(R"({"a":[1,2]})")),
            other(Json::parse(R"({"a": [2, 1]})"));
        QVERIFY(one == same);
        QVERIFY(!(one == other));
        QVERIFY(!(one == JsonValue()));
    }

    void anEditedCopyLeavesTheOriginal()
    {
        JsonValue original(Json{{"a", 1}});
        JsonValue copy = original;
        QCOMPARE(&copy.json(), &original.json()); // shared: a copy costs a pointer
        copy.edit()["a"] = 2;
        QVERIFY(original == JsonValue(Json{{"a", 1}}));
        QVERIFY(copy == JsonValue(Json{{"a", 2}}));
        const JsonValue kept = original;
        original.edit()["b"] = 3;
        QVERIFY(kept == JsonValue(Json{{"a", 1}}));
    }
};

UNPROJECTOR_TEST(TestJsonValue)
#include "test_json_value.moc"

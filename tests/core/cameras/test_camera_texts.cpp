// The cases of tests/data/texts/cameras.txt: no number of a camera is dropped without a word, or read as another thing.

#include "tests/support/test.h"

#include "core/base/text_scanner.h"
#include "core/cameras/foreign_camera.h"
#include "core/geometry/setup.h"
#include "tests/support/data_files.h"

#include <cmath>

using namespace unprojector;
using namespace unprojector::cameras;

Q_DECLARE_METATYPE(data_files::Case)

namespace {

constexpr double kWorld[][3]{{1.9, -1.8, 5.0}, {2.2, -2.3, 6.1}, {1.2, -1.5, 7.0}};

CameraChoices choicesOf(const data_files::Case &example)
{
    CameraChoices choices;
    for (const std::string &image : example.all("image"))
        choices.image = image;
    choices.isUndistorted = !example.all("undistorted").empty();
    for (const std::string &pose : example.all("pose"))
        choices.direction =
            pose == keyOf(PoseDirection::WorldToCamera) ? PoseDirection::WorldToCamera : PoseDirection::CameraToWorld;
    return choices;
}

std::vector<double> numbersIn(const std::string &line)
{
    std::vector<double> numbers;
    base::TextScanner scanner(line);
    for (auto word = scanner.nextWord(); !word.empty(); word = scanner.nextWord())
        numbers.push_back(base::doubleFromWord(word).value());
    return numbers;
}

/// The pixels of the world's points, from the image's corner.
std::vector<double> pixelsOf(const SceneCamera &scene)
{
    std::vector<double> pixels;
    const geometry::Surface surface{scene.size.width, scene.size.height, 1.0};
    const geometry::Setup setup{surface, geometry::wholeSurface(surface), {}, scene.projection, scene.eyeFromWorld};
    for (const auto &[x, y, z] : kWorld) {
        const auto window = geometry::windowFromWorld(setup, geometry::WorldPoint({x, y, z}));
        const auto pixel = window ? geometry::deviceFromWindow(surface, *window).coordinates() : glm::dvec2(NAN);
        pixels.insert(pixels.end(), {pixel.x, pixel.y});
    }
    return pixels;
}

} // namespace

class TestCameraTexts : public QObject {
    Q_OBJECT

private slots:
    void numbersAreReadNamedOrRefused_data() { data_files::addCases("cameras"); }

    void numbersAreReadNamedOrRefused()
    {
        QFETCH(data_files::Case, example);
        CameraChoices choices = choicesOf(example);
        const auto read = readCamera(std::vector<NamedText>{{"a.txt", example.text}}, choices);
        if (!example.all("unknown").empty()) {
            QVERIFY(!read);
            return;
        }
        QVERIFY2(read, "not recognised");
        if ((*read) && (*read)->program != "Blender")
            choices.axes = EyeAxes::RightDownAhead;
        for (const std::string &numbers : example.all("distorted")) {
            const std::vector<double> k = numbersIn(numbers);
            QVERIFY2(*read, *read ? "" : read->error().message().c_str());
            QVERIFY((*read)->distortion);
            QCOMPARE(*(*read)->distortion, (Distortion{k.at(0), k.at(1), k.at(2), k.at(3), k.at(4)}));
        }
        const auto scene = *read ? sceneCamera(**read, choices, std::nullopt) : read->error();
        for (const std::string &reason : example.all("refused")) {
            QVERIFY(!scene);
            QVERIFY2(scene.error().text.find(reason) != std::string::npos, scene.error().message().c_str());
        }
        for (const std::string &line : example.all("pixels")) {
            QVERIFY2(scene, scene ? "" : scene.error().message().c_str());
            const std::vector<double> wanted = numbersIn(line), pixels = pixelsOf(*scene);
            QCOMPARE(pixels.size(), wanted.size());
            for (std::size_t i = 0; i < wanted.size(); ++i)
                QVERIFY2(std::abs(pixels[i] - wanted[i]) <= 1e-9 * std::max(1.0, std::abs(wanted[i])),
                         qPrintable(QStringLiteral("%1, not %2").arg(pixels[i]).arg(wanted[i])));
        }
        for (const std::string &sentence : example.all("says"))
            QVERIFY2(scene
                         && std::any_of(scene->assumed.begin(), scene->assumed.end(),
                                        [&](const std::string &one) { return one.find(sentence) != one.npos; }),
                     "it is not said");
    }
};

UNPROJECTOR_TEST(TestCameraTexts)
#include "test_camera_texts.moc"

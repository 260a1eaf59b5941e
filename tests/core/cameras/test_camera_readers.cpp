// The cameras of other programs: each camera projects points to the pixels to which its program
// projects them.

#include "tests/support/test.h"

#include "core/cameras/camera_reader.h"
#include "core/cameras/lens.h"
#include "core/cameras/named_values.h"
#include "tests/support/data_files.h"

#include <QRandomGenerator>
#include <QRegularExpression>

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

using namespace unprojector;
using namespace unprojector::cameras;
using data_files::CameraExample;
using data_files::cameraExamples;

namespace {

std::vector<NamedText> textsOf(const CameraExample &example)
{
    std::vector<NamedText> texts;
    for (const data_files::NamedText &text : example.texts)
        texts.push_back({text.name, text.text});
    return texts;
}

CameraChoices choicesOf(const CameraExample &example)
{
    CameraChoices choices;
    choices.image = example.image;
    if (example.width > 0)
        choices.size = ImageSize{example.width, example.height};
    return choices;
}

const CameraExample &exampleOf(const char *name)
{
    return *std::find_if(cameraExamples().begin(), cameraExamples().end(),
                         [name](const CameraExample &one) { return one.name == name; });
}

/// An example's texts with a part replaced.
std::vector<NamedText> changed(const char *name, const std::string &from, const std::string &to)
{
    std::vector<NamedText> texts = textsOf(exampleOf(name));
    for (NamedText &text : texts) {
        if (const std::size_t at = text.text.find(from); at != text.text.npos)
            text.text.replace(at, from.size(), to);
    }
    return texts;
}

QString reasonOf(const std::vector<NamedText> &texts, const CameraChoices &choices)
{
    const auto read = readCamera(texts, choices);
    if (!read)
        return QStringLiteral("not recognised");
    return *read ? QStringLiteral("read")
                 : QString::fromStdString(base::Error{read->error().text, read->error().subject}.message());
}

QString assumedOf(const std::vector<NamedText> &texts, const CameraChoices &choices)
{
    QStringList said;
    const auto read = readCamera(texts, choices);
    if (read && *read) {
        for (const std::string &one : (*read)->assumed)
            said << QString::fromStdString(one);
    }
    return said.join(QLatin1Char('\n'));
}

/// How programs spell numbers with more digits than the shortest that give a double back.
struct Spelling {
    const char *name, *format;
    bool isExponentShort; ///< as of JavaScript: e-7, not e-07
};
constexpr Spelling kSpellings[]{
    {"%.17g", "%.17g", false}, {"%.16e", "%.16e", false}, {"%.15f", "%.15f", false}, {"JavaScript", "%.16e", true}};

QByteArray spelled(double value, const Spelling &spelling)
{
    QByteArray text = QString::asprintf(spelling.format, value).toLatin1();
    if (const qsizetype e = text.indexOf('e'); spelling.isExponentShort && e >= 0)
        text = text.left(e + 1) + QByteArray::number(text.mid(e + 1).toInt());
    return text;
}

/// A JSON text with its fractions spelled anew.
std::string respelled(const std::string &json, const Spelling &spelling)
{
    static const QRegularExpression parts(QStringLiteral(R"("[^"]*"|-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)"));
    const QString text = QString::fromStdString(json);
    QString result;
    qsizetype at = 0;
    for (auto it = parts.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch part = it.next();
        const QString word = part.captured();
        result += QStringView(text).mid(at, part.capturedStart() - at);
        result += word.startsWith('"') || !word.contains('.') ? word
                                                              : QString::fromLatin1(spelled(word.toDouble(), spelling));
        at = part.capturedEnd();
    }
    return (result + text.mid(at)).toStdString();
}

glm::dmat4 clipFromEyeOf(const SceneCamera &camera)
{
    geometry::Setup setup;
    setup.lens = camera.projection;
    return clipFromEye(setup).value();
}

/// The pixel of a point, from the image's top-left corner.
glm::dvec2 pixelOf(const SceneCamera &camera, const CameraExample::Point &point)
{
    const glm::dvec4 clip =
        clipFromEyeOf(camera) * camera.eyeFromWorld * glm::dvec4(point.world[0], point.world[1], point.world[2], 1.0);
    return {(clip.x / clip.w + 1.0) / 2.0 * camera.size.width, (1.0 - clip.y / clip.w) / 2.0 * camera.size.height};
}

} // namespace

class TestCameraReaders : public QObject {
    Q_OBJECT

private slots:
    void everyFileHasItsExpectation()
    {
        for (const std::filesystem::path &folder : data_files::in("cameras")) {
            QStringList files, expected{QStringLiteral("expected.json")};
            for (const std::filesystem::path &file : data_files::in(folder))
                files << QString::fromStdU16String(file.filename().u16string());
            for (const data_files::NamedText &text : data_files::cameraExample(folder).texts)
                expected << QString::fromStdString(text.name);
            expected.sort();
            files.sort();
            QCOMPARE(files, expected);
        }
    }

    void pixelsAreTheProgramsOwn_data()
    {
        addColumn<int>("index");
        addColumn<int>("spelling");
        for (int i = 0; i < int(cameraExamples().size()); ++i) {
            const CameraExample &example = cameraExamples()[std::size_t(i)];
            newRow(example.name.c_str()) << i << -1;
            const bool isJson = std::string_view("{[\"").find(example.texts[0].text[0]) != std::string_view::npos;
            for (int k = 0; isJson && k < int(std::size(kSpellings)); ++k)
                addRow("%s, %s", example.name.c_str(), kSpellings[k].name) << i << k;
        }
    }

    void pixelsAreTheProgramsOwn()
    {
        QFETCH(int, index);
        QFETCH(int, spelling);
        const CameraExample &example = cameraExamples()[std::size_t(index)];
        std::vector<NamedText> texts = textsOf(example);
        if (spelling >= 0)
            texts[0].text = respelled(texts[0].text, kSpellings[spelling]);
        const auto read = readCamera(texts, choicesOf(example));
        QVERIFY(read);
        QVERIFY2(*read, *read ? "" : (*read).error().message().c_str());
        QVERIFY(QString::fromStdString(example.name).startsWith(QString::fromStdString((*read)->program)));
        const auto scene = sceneCamera(**read, choicesOf(example), std::nullopt);
        QVERIFY2(scene, scene ? "" : scene.error().message().c_str());
        const double side = std::max(scene->size.width, scene->size.height);
        for (const CameraExample::Point &point : example.points) {
            const glm::dvec2 pixel = pixelOf(*scene, point);
            for (int i = 0; i < 2; ++i) {
                const double off = std::abs(pixel[i] - point.pixel[i] - example.corner) / side;
                QVERIFY2(off <= example.tolerance, qPrintable(QString::number(off)));
            }
        }
    }

    /// Each number as the standard library reads it, in a key of its own and in a list.
    void longNumbersAreRead()
    {
        QRandomGenerator random(300);
        for (int i = 0; i < 300; ++i) {
            const Spelling &spelling = kSpellings[i % int(std::size(kSpellings))];
            const QByteArray fx = spelled((5000 + random.bounded(5000)) / 10.0, spelling),
                             fy = spelled(500 + 500 * random.generateDouble(), spelling),
                             k1 = spelled(-random.generateDouble(), spelling), x = spelled(1e-7 * (i + 1), spelling);
            const NamedText nerf{"transforms.json",
                                 ("{\"fl_x\": " + fx + ", \"fl_y\": " + fy + ", \"k1\": " + k1
                                  + ", \"w\": 640.0000000000000000, \"h\": 480, \"frames\": [{\"transform_matrix\": "
                                    "[[1,0,0,"
                                  + x + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]}")
                                     .toStdString()};
            const auto read = readCamera({{nerf}}, {});
            QVERIFY2(read && *read, nerf.text.c_str());
            const ForeignCamera &camera = **read;
            QVERIFY2(camera.intrinsics->fx == fx.toDouble() && camera.intrinsics->fy == fy.toDouble(),
                     nerf.text.c_str());
            QVERIFY(camera.size == (ImageSize{640, 480}));
            QCOMPARE((*camera.pose)[3][0], x.toDouble());
            QVERIFY(camera.distortion);
        }
        // A message has the number as the file has it.
        const NamedText part{"transforms.json", R"({"fl_x": 500, "w": 640.50000000000000, "h": 480, "transform_matrix":
        [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})"};
        QVERIFY2(reasonOf({part}, {}).startsWith("w is 640.50000000000000;"), qPrintable(reasonOf({part}, {})));
    }

    void otherTextsAreNotTaken_data()
    {
        addColumn<QString>("text");
        newRow("matrices of OpenGL") << "view: 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1\nprojection: 1 0 0 0 0 1 0 0 0 0 -1 "
                                        "-1 0 0 -2 0\nviewport 0 0 800 600";
        newRow("three.js") << "{\"matrixWorld\":{\"elements\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]},\"fov\":50}";
        newRow("calls") << "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\ngluPerspective(45, 1.33, 0.1, 100);";
        newRow("a glTF model without camera") << "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}]}";
        newRow("an angle in a text") << "The fov = 60 and the position (1, 2, 3) are given.";
        newRow("nothing") << "";
        newRow("points with names") << "pitch 3, yaw 4, roll 5\nx 1 y 2 z 3";
    }

    void otherTextsAreNotTaken()
    {
        QFETCH(QString, text);
        const NamedText given{"paste", text.toStdString()};
        QCOMPARE(reasonOf({given}, {}), QStringLiteral("not recognised"));
    }

    /// The reader looks at the character before each mark. Where the standard library checks indices, a
    /// wrong one ends the program.
    void anyCharacterMayBeFirst()
    {
        for (int code = 0; code < 256; ++code) {
            const std::string first(1, char(code));
            for (const std::string &text : {first, first + first, first + "\n", first + "fov = 60"})
                QCOMPARE(reasonOf({{"paste", text}}, {}), QStringLiteral("not recognised"));
        }
    }

    void faultsAreNamed_data()
    {
        addColumn<QString>("program");
        addColumn<QString>("from");
        addColumn<QString>("to");
        addColumn<QString>("reason");
        const auto row = [](const char *name, const char *program, const char *from, const char *to,
                            const char *reason) { newRow(name) << program << from << to << reason; };
        row("fisheye", "COLMAP", "2 PINHOLE 3072 2304 2559.81 2561.25 1536.5 1151.75",
            "2 OPENCV_FISHEYE 3072 2304 2559.81 2561.25 1536.5 1151.75 0 0 0 0",
            "the camera model OPENCV_FISHEYE is not");
        row("too few parameters", "COLMAP", "2559.81 2561.25 1536.5 1151.75", "2559.81 1536.5 1151.75",
            "PINHOLE has 3 parameters; it needs 4");
        row("no such camera", "COLMAP", "4.75 2 left", "4.75 5 left", "there is no camera 5 among COLMAP's cameras");
        row("a short matrix", "NeRF", "[0.0, 0.0, 0.0, 1.0]", "[0.0, 0.0, 1.0]",
            "transform_matrix needs 16 numbers; it has 15");
        row("no angle", "NeRF, made with Blender", "camera_angle_x", "angle",
            "there is neither fl_x nor camera_angle_x");
        row("a fisheye of Nerfstudio", "NeRF", "\"k1\"", "\"camera_model\": \"OPENCV_FISHEYE\", \"k1\"",
            "the camera model OPENCV_FISHEYE is not read");
        row("k4", "NeRF", "\"k1\": 0.0", "\"k4\": 0.1", "k4 is of a distortion that is not read");
        row("a short extrinsic", "Open3D, parameters", "\"extrinsic\": [", "\"extrinsic\": [0.5, ",
            "extrinsic needs 16 numbers; it has 17");
        row("an angle of 180", "MuJoCo, data", "45.5", "180", "the field of view is 180 degrees");
        row("16 numbers", "Unity, matrices", "worldToCameraMatrix", "cam.worldToCameraMatrix = 1\nrest",
            "cam.worldToCameraMatrix needs 16 numbers; it has 1");
        row("no position", "Unity, transform", "position: (1.50, 2.25, -6.00)", "position: (1.50, 2.25)",
            "the camera's position is missing");
        row("no lens", "Blender", "lens = 50.0", "", "the focal length is missing");
        row("a focal length below 0", "Blender", "lens = 50.0", "lens = -50.0",
            "lens is -50; it must be greater than 0");
        row("a panorama", "Blender", "lens = 50.0", "type = 'PANO'\nlens = 50.0",
            "a panoramic camera has no projection");
        row("cx alone", "NeRF", "\"cy\"", "\"y\"", "cx is given without cy; give both");
        row("another order", "Blender", "matrix_world",
            "rotation_euler = Euler((1, 2, 3), 'ZXY')\nlocation = 1, 2, 3\nm",
            "Euler angles in the order ZXY are not read");
        row("a node in itself", "glTF", "\"children\":[0,2]", "\"children\":[0,1]", "is its own parent");
        row("an end of an element", "Metashape", "</cameras>", "", "the XML is damaged: \"</cameras>\" is missing");
        row("a quote", "Metashape", "label=\"P1\"", "label=P1", "the XML is damaged: \"\"\" is missing");
        row("a comment's end", "Metashape", " -->", "", "the XML is damaged: \"-->\" is missing");
        const char *posed = "sensor_id=\"1\" component_id=\"0\" label=\"DJI";
        row("a sphere", "Metashape", posed, "sensor_id=\"0\" label=\"DJI", "the camera model spherical is not read");
        row("no sensor", "Metashape", posed, "sensor_id=\"5\" label=\"DJI", "11 50.jpg has no intrinsics in the file");
        row("no focal length", "Metashape", "<f>3268.3</f>", "", "f needs 1 numbers; it has 0");
        row("a fisheye", "Metashape", "<calibration type=\"frame\" class=\"adjusted\">",
            "<calibration type=\"fisheye\" class=\"adjusted\">", "the camera model fisheye is not read");
        row("k4", "Metashape", "<k1>", "<k4>0.1</k4><k1>", "the camera model frame (k4, p3, p4) is not read");
        row("no rotation", "Metashape", "<rotation locked", "<turn locked", "damaged");
        row("a lens of MeshLab", "MeshLab", "LensDistortion=\"0 0\" ViewportPx=\"1853",
            "LensDistortion=\"0.1 0\" ViewportPx=\"1853", "the distortion of MeshLab is not read");
        row("binary data", "MeshLab", "<VCGCamera CameraType=\"0\" TranslationVector=\"-",
            "<VCGCamera BinaryData=\"1\" TranslationVector=\"-", "BinaryData 1 is not read");
        row("no position", "RealityCapture", "<xcr:Position>", "<xcr:Position>1 ",
            "Position needs 3 numbers; it has 4");
        row("a lens", "RealityCapture", "Coeficients=\"0", "Coeficients=\"0.1",
            "the distortion of RealityCapture (brown3) is not read");
        row("skew", "RealityCapture", "Skew=\"0", "Skew=\"0.5", "Skew 0.5 is not read");
        row("another frame", "Gazebo", "<pose degrees", "<pose relative_to=\"arm\" degrees", "relative_to arm is not");
        row("a lens of Gazebo", "Gazebo", "<k1>0", "<k1>0.1", "the distortion of Gazebo is not read");
        row("a short pose", "Gazebo", "<pose>14.0 ", "<pose>", "pose needs 6 numbers; it has 5");
        row("a target", "MuJoCo, MJCF", "name=\"closeup\"", "name=\"closeup\" mode=\"targetbody\"",
            "mode targetbody is not read");
        row("a sensor", "MuJoCo, MJCF", "name=\"closeup\"", "name=\"closeup\" sensorsize=\"1 1\"",
            "sensorsize 1 1 is not read");
        row("another sensor", "Mitsuba", "type=\"perspective\"", "type=\"orthographic\"",
            "sensor orthographic is not read");
        row("no angle of Mitsuba", "Mitsuba", "name=\"fov\"", "name=\"f\"", "fov is missing");
        row("a crop", "Mitsuba", "<integer name=\"width\"",
            "<integer name=\"crop_width\" value=\"8\"/><integer name=\"w\"", "crop_width 8 is not read");
        row("no up", "Mitsuba", "up=", "u=", "up needs 3 numbers; it has 0");
        row("no yfov", "pyrender", "np.pi / 3.0", "fov", "yfov has no number");
        row("DSO's fisheye", "DSO, relative", " 0\n1280", " 0.9\n1280", "the distortion is FOV; only k1");
        row("a cut bundle", "Bundler", "2 1\n", "9 1\n", "the file ends in the middle of an entry");
        row("a fisheye of Anipose", "Anipose", "name = \"B\"", "name = \"B\"\nfisheye = true",
            "the distortion is fisheye; only k1");
        row("a model of pycolmap", "COLMAP, pycolmap", "model=PINHOLE", "model=FOV",
            "the camera model FOV is not read");
        row("up along the view", "VTK, PyVista", "(0.0, 0.0, 1.0)", "(0, 0, 0)", "forward and up are parallel");
        row("another order of USD", "USD, rotateXYZ", "rotateXYZ = ", "rotateZYX = ", "the camera's pose is missing");
        row("a flat camera of USD", "USD, orient", "float focalLength",
            "token projection = \"orthographic\"\n    float focalLength", "an orthographic camera of USD is not read");
        row("a frustum", "Godot", "fov = 65.0", "projection = 2", "a camera with frustum_offset is not read");
        row("a distorted sensor", "LGSVL", "\"Distorted\": false\n  },\n  \"transform\": {\n   \"x\": 0.5",
            "\"Distorted\": true\n  },\n  \"transform\": {\n   \"x\": 0.5", "the distortion is DistortionParameters");
        row("a short Tc", "Bouguet's toolbox", "Tc_2  = [ -1.551106e+02 ;", "Tc_2  = [",
            "Tc_2 needs 3 numbers; it has 2");
    }

    void faultsAreNamed()
    {
        QFETCH(QString, program);
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, reason);
        const QByteArray name = program.toUtf8();
        const auto texts = changed(name.constData(), from.toStdString(), to.toStdString());
        const QString found = reasonOf(texts, choicesOf(exampleOf(name.constData())));
        QVERIFY2(found.contains(reason), qPrintable(found));
    }

    void assumptionsAreSaid_data()
    {
        addColumn<QString>("program");
        addColumn<QString>("said");
        newRow("NeRF's centre") << "NeRF, made with Blender"
                                << "in the image's centre, because cx and cy";
        newRow("NeRF's halves") << "NeRF"
                                << "Pixel centres are read at halves";
        newRow("what Instant-NGP adds") << "NeRF"
                                        << "aabb_scale: not applied";
        newRow("another angle") << "NeRF"
                                << "fl_x is 1375.52, but camera_angle_x gives 1479.34";
        newRow("what is not used") << "NVISII"
                                   << "Not used: camera_view_matrix (16 numbers)";
        newRow("Unity's world") << "Unity, transform"
                                << "(x, y, -z) here";
        newRow("Unreal's world") << "Unreal"
                                 << "(x, -y, z) here, in centimetres";
        newRow("Unreal's angle") << "Unreal, BugItGo"
                                 << "assumed to be 90 degrees";
        newRow("a chunk's transform") << "Metashape"
                                      << "The chunk's transform is applied";
        newRow("a body of MJCF") << "MuJoCo, MJCF"
                                 << "its pose is that with all joints at 0";
        newRow("MuJoCo's angle") << "MuJoCo, MJCF with zaxis"
                                 << "fovy is 45 degrees";
        newRow("Replica's poses") << "Replica"
                                  << "with OpenCV's axes, as Replica writes them";
        newRow("the nearest time") << "TUM, the time of an image"
                                   << "The pose at the time 1305031102.2758 is taken";
        newRow("the lens of KITTI") << "KITTI, odometry"
                                    << "The lens is that of P0";
        newRow("the angle of VTK") << "VTK, PyVista"
                                   << "assumed to be 30 degrees";
        newRow("the model of pycolmap") << "COLMAP, pycolmap, inverse, no model"
                                        << "The camera model is taken as SIMPLE_RADIAL";
        newRow("square pixels of USD") << "USD"
                                       << "Pixels are square";
        newRow("LGSVL's world") << "LGSVL"
                                << "(x, y, -z) here";
        newRow("COLLADA's world") << "COLLADA"
                                  << "Z_UP with units of 0.0254 m";
        newRow("COLLADA's own world") << "COLLADA, two angles"
                                      << "Y_UP with units of 1 m";
        newRow("the origin of Pix4D") << "Pix4D"
                                      << "*_offset.xyz has its origin";
        newRow("pixels not square") << "trimesh"
                                    << "pixels are not square";
    }

    void assumptionsAreSaid()
    {
        QFETCH(QString, program);
        QFETCH(QString, said);
        const CameraExample &example = exampleOf(program.toUtf8().constData());
        const QString all = assumedOf(textsOf(example), choicesOf(example));
        QVERIFY2(all.contains(said), qPrintable(all));
    }

    void imagesAreChosen()
    {
        const auto texts = textsOf(exampleOf("COLMAP"));
        CameraChoices choices;
        const auto imageOf = [&](const char *image) {
            choices.image = image;
            const auto read = readCamera(texts, choices);
            return read && *read ? int((*read)->image) : -1;
        };
        QCOMPARE(imageOf(""), 0);
        QCOMPARE(imageOf("left/P1180141.JPG"), 1);
        QCOMPARE(imageOf("P1180141.JPG"), 1);
        QCOMPARE(imageOf("P1180141"), 1);
        QCOMPARE(imageOf("without points.jpg"), 2);
        QCOMPARE(imageOf("2"), 2);
        QCOMPARE(imageOf("3"), -1);
        QCOMPARE(imageOf("P118"), -1);
        QVERIFY(assumedOf(texts, {}).contains("The first of 3 images is read, first.jpg"));
        choices.image = "P118";
        QVERIFY(
            reasonOf(texts, choices).contains("there is no image \"P118\" among 3 (first.jpg, left/P1180141.JPG, "));
        // A file alone names the other.
        QVERIFY(reasonOf({texts[0]}, {}).contains("give images.txt"));
        QVERIFY(reasonOf({texts[1]}, {}).contains("give cameras.txt"));
        // The order of the files and their line ends do not count.
        std::vector<NamedText> turned{texts[1], texts[0]};
        for (NamedText &text : turned)
            text.text = QString::fromStdString(text.text).replace("\n", "\r\n").toStdString();
        choices.image = "without points.jpg";
        QCOMPARE(reasonOf(turned, choices), QStringLiteral("read"));
    }

    /// The last image has no line of points; the line below is a camera's.
    void imagesMayStandBeforeTheirCameras()
    {
        const NamedText both{"paste", "1 1 0 0 0 0 0 0 1 a.png\n1 PINHOLE 640 480 500 510 320 240\n"};
        QCOMPARE(reasonOf({both}, {}), QStringLiteral("read"));
    }

    /// An image with a damaged quaternion keeps its position.
    void everyImageCounts()
    {
        const auto with = [](const char *quaternion) {
            return std::vector<NamedText>{
                {"cameras.txt", "1 PINHOLE 640 480 500 510 320 240\n"},
                {"images.txt", std::string("1 1 0 0 0 0 0 0 1 a.png\n\n2 ") + quaternion
                                   + " 0 0 0 1 b.png\n10.5 20.5 -1 1 2 3 4 5 6 7 8 9\n3 1 0 0 0 0 0 0 1 c.png\n\n"}};
        };
        CameraChoices second;
        second.image = "1";
        const auto read = readCamera(with("0.7 0 0.7 0"), second);
        QVERIFY(read && *read);
        QCOMPARE((*read)->images.size(), std::size_t{3});
        QVERIFY(assumedOf(with("0.7 0 0.7 0"), second).contains("The quaternion of b.png has the length 0.9899"));
        QVERIFY(reasonOf(with("0 0 0 0"), second).contains("the image's quaternion is 0"));
        QVERIFY(reasonOf(with("nan 0 0 0"), second).contains("a number of the pose of b.png is not finite"));
        second.image = "c.png";
        QCOMPARE(reasonOf(with("nan 0 0 0"), second), QStringLiteral("read"));
    }

    /// The coefficients that pixelsAreTheProgramsOwn() leaves out.
    void distortionIsRead()
    {
        const auto distortionOf = [](const char *name) {
            const auto read = readCamera(textsOf(exampleOf(name)), choicesOf(exampleOf(name)));
            return read && *read && (*read)->distortion ? *(*read)->distortion : Distortion();
        };
        QVERIFY(distortionOf("Bundler") == (Distortion{0.01, -0.02}));
        QVERIFY(distortionOf("Bouguet's toolbox")
                == (Distortion{-0.25402543, 0.12143304, -0.00020865, 0.00001942, 0.0}));
        QVERIFY(distortionOf("Anipose") == (Distortion{0.05, -0.15, -0.01, -0.002, 0.03}));
        QVERIFY(distortionOf("Human3.6M") == (Distortion{-0.2, 0.24, -0.0014, -0.00097, -0.003}));
        QVERIFY(distortionOf("Multiface") == Distortion());
        const auto radTan =
            readCamera({{NamedText{"camera.txt", "RadTan 500 501 320 240 0.1 0.2 0.3 0.4\n640 480\nnone\n"}}}, {});
        QVERIFY(radTan && *radTan && (*radTan)->distortion == (Distortion{0.1, 0.2, 0.3, 0.4}));
    }

    /// A row of poses is chosen by its index, by its time, or by an image whose time is near.
    void posesAreChosen()
    {
        const auto texts = textsOf(exampleOf("TUM, the time of an image"));
        const auto imageOf = [&](const char *image) {
            CameraChoices choices;
            choices.image = image;
            const auto read = readCamera(texts, choices);
            return read && *read ? int((*read)->image) : -1;
        };
        QCOMPARE(imageOf(""), 0);
        QCOMPARE(imageOf("2"), 2);
        QCOMPARE(imageOf("1305031102.2758"), 1);
        QCOMPARE(imageOf("rgb/1305031102.360000.png"), 2);
        QCOMPARE(imageOf("1305031102.2"), -1);
        QCOMPARE(imageOf("1305031103.2758.png"), -1);
    }

    /// The names of these files tell nothing, so the numbers are not taken for a camera's.
    void numbersAloneAreNoCamera_data()
    {
        addColumn<QString>("text");
        newRow("a row of poses") << "1305031102.1758 1 2 3 0 0 0 1";
        newRow("K") << "585 0 320\n0 585 240\n0 0 1";
        newRow("a table of five") << "1 2 3 4 0\n5 6 7 8 0\n9 10 11 12 0";
        newRow("five, then two") << "1 2 3 4 0\n640 480\n7\n";
        newRow("eight") << "1 2 3 4 5 6 7 8\n640 480 1\n1 2 3";
        newRow("half a KRT") << "400067\n1 0 0\n0 1 0\n0 0 1\n0 0 0 0 0";
    }

    void numbersAloneAreNoCamera()
    {
        QFETCH(QString, text);
        QCOMPARE(reasonOf({{"numbers", text.toStdString()}}, {}), QStringLiteral("not recognised"));
    }

    void filesOfSeveralProgramsAreRefused()
    {
        std::vector<NamedText> texts = textsOf(exampleOf("COLMAP"));
        texts.push_back({"k.txt", "K = 800 0 320 0 800 240 0 0 1\n"});
        const QString reason = reasonOf(texts, {});
        QVERIFY2(reason.contains("the files are of several programs: ") && reason.contains("k.txt (OpenCV)"),
                 qPrintable(reason));
        const std::vector<NamedText> parts{{"k.txt", "K = 800 0 320 0 800 240 0 0 1\n"},
                                           {"pose.txt", "R = 1 0 0 0 1 0 0 0 1\nt = 0 0 5\n"}};
        QCOMPARE(reasonOf(parts, {}), QStringLiteral("read"));
    }

    void nerfsSizeIsNamed()
    {
        const auto reasonWith = [](const char *w) {
            return reasonOf(
                {{"transforms.json", std::string("{\"fl_x\": 500, \"cx\": 320, \"cy\": 240, \"h\": 480, \"w\": ") + w
                                         + ", \"frames\": [{\"transform_matrix\": [[1,0,0,0],[0,1,0,0],"
                                           "[0,0,1,0],[0,0,0,1]]}]}"}},
                {});
        };
        QCOMPARE(reasonWith("640"), QStringLiteral("read"));
        for (const char *w : {"1080.5", "0", "\"1080\"", "1e9"})
            QVERIFY2(reasonWith(w).contains("w is ") && reasonWith(w).contains("whole number from 1 to 1000000"),
                     qPrintable(reasonWith(w)));
        QVERIFY(reasonOf({{"transforms.json", "{\"fl_x\": 500, \"w\": 640}"}}, {}).contains("there are no poses"));
    }

    void colmapsModelsAreRead()
    {
        const auto read = [](const char *camera) {
            const std::vector<NamedText> texts{{"cameras.txt", std::string("1 ") + camera + "\n"},
                                               {"images.txt", "1 1 0 0 0 0 0 0 1 a.png\n\n"}};
            return readCamera(texts, {})->value();
        };
        const ForeignCamera radial = read("RADIAL 640 480 500 320 240 -0.1 0.02");
        QCOMPARE(radial.intrinsics->fx, 500.0);
        QCOMPARE(radial.intrinsics->fy, 500.0);
        QCOMPARE(radial.intrinsics->cy, 240.0);
        QVERIFY(radial.distortion == (Distortion{-0.1, 0.02, 0.0, 0.0, 0.0}));
        QVERIFY(read("SIMPLE_RADIAL 640 480 500 320 240 0.3").distortion == (Distortion{0.3, 0.0, 0.0, 0.0, 0.0}));
        const ForeignCamera opencv = read("OPENCV 640 480 500 510 320 240 0.1 0.2 0.3 0.4");
        QCOMPARE(opencv.intrinsics->fy, 510.0);
        QVERIFY(opencv.distortion == (Distortion{0.1, 0.2, 0.3, 0.4, 0.0}));
        QVERIFY(read("FULL_OPENCV 640 480 500 510 320 240 0.1 0.2 0.3 0.4 0.5 0 0 0").distortion
                == (Distortion{0.1, 0.2, 0.3, 0.4, 0.5}));
        QVERIFY(!read("PINHOLE 640 480 500 510 320 240").distortion);
    }

    /// The same cameras and images as text and in COLMAP's binary form.
    void colmapsBinaryFilesAreRead()
    {
        const auto bytesOf = [](auto... values) {
            std::string bytes;
            (bytes.append(reinterpret_cast<const char *>(&values), sizeof values), ...);
            return bytes;
        };
        using Count = std::uint64_t;
        using Id = std::int32_t;
        const std::string cameras =
            bytesOf(Count(2), Id(7), Id(5), Count(640), Count(480), 1., 1., 1., 1., 0., 0., 0., 0.)
            + bytesOf(Id(3), Id(4), Count(640), Count(480), 500., 510., 320., 240., .1, .2, .3, .4);
        const std::string images = bytesOf(Count(2), Id(1), 1., 0., 0., 0., 0., 0., 0., Id(7))
                                   + std::string("a.png\0", 6) + bytesOf(Count(1), 1., 2., std::int64_t(-1))
                                   + bytesOf(Id(2), .6, 0., .8, 0., 1., 2., 3., Id(3)) + std::string("b b.png\0", 8)
                                   + bytesOf(Count(0));
        std::vector<NamedText> binary{{"sparse/0/cameras.bin", cameras}, {"sparse/0/images.bin", images}};
        const std::vector<NamedText> text{{"cameras.txt", "3 OPENCV 640 480 500 510 320 240 .1 .2 .3 .4\n"},
                                          {"images.txt", "2 .6 0 .8 0 1 2 3 3 b b.png\n\n"}};
        CameraChoices second;
        second.image = "b b.png";
        const ForeignCamera read = readCamera(binary, second)->value(), wanted = readCamera(text, {})->value();
        QCOMPARE(*read.pose, *wanted.pose);
        QCOMPARE(read.intrinsics->fy, 510.0);
        QVERIFY(read.distortion == wanted.distortion);
        QCOMPARE(read.images.size(), std::size_t{2});
        QVERIFY(reasonOf(binary, {}).contains("the camera model OPENCV_FISHEYE is not read"));
        for (std::size_t length = 0; length < images.size(); ++length) {
            binary[1].text = images.substr(0, length);
            QVERIFY2(reasonOf(binary, second).contains("it is incomplete"), qPrintable(reasonOf(binary, second)));
        }
        binary[1].text = bytesOf(Count(1) << 60) + images.substr(8);
        QVERIFY(reasonOf(binary, second).contains("it is incomplete"));
    }

    /// JSON with a comma or a word too many: keys of a single program tell that its file is damaged; with
    /// other keys, the reader of texts takes it.
    void laxJsonIsRead()
    {
        const std::string k = "[500, 0, 320, 0, 510, 240, 0, 0, 1]";
        for (const std::string &json :
             {"{\"cam_K\": " + k + ",}", "{\"cam_K\": " + k + ", \"depth_scale\": NaN}",
              "{\"poses\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 5], \"w\": 640, \"h\": 480, \"K\": " + k + ",}"}) {
            const NamedText text{"paste", json};
            const auto read = readCamera({&text, 1}, {});
            QVERIFY2(read && *read, json.c_str());
            QCOMPARE((*read)->intrinsics->fy, 510.0);
        }
        for (const char *name : {"ARKit", "OpenSfM", "Polycam"}) {
            const auto read = readCamera(changed(name, "{", "{,"), {});
            QVERIFY(read && !*read && read->error().line > 0);
        }
    }

    void linesOfRecordsAreNamed_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("image");
        addColumn<int>("line");
        newRow("AliceVision") << R"({"views": [{"viewId": "1", "intrinsicId": "9", "path": "a.jpg"},
            {"viewId": "2", "intrinsicId": "9", "path": "b.jpg"}], "intrinsics": [{"intrinsicId": "9",
            "width": "640", "height": "480", "focalLength": "30", "type": "pinhole",
            "principalPoint": ["0"]}]})"
                              << "2" << 4;
        const char *lidar = R"([{"token": "l", "sensor_token": "1", "translation": [0, 0, 0], "camera_intrinsic": [],
            "rotation": [1, 0, 0, 0]},
            {"sensor_token": "2", "token": "c", "translation": [0, %2], "camera_intrinsic": [9, 0, 5, 0, 9, 5, 0, 0, 1],
            "rotation": [%1, 0, 0, 0]}])";
        newRow("nuScenes after a lidar") << QString(lidar).arg("1", "0") << "" << 3;
        newRow("a quaternion of nuScenes") << QString(lidar).arg("0", "0, 0") << "" << 4;
        newRow("three.js")
            << R"({"object": {"type": "Scene", "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
            "children": [{"type": "PerspectiveCamera", "fov": 50,
            "matrix": [1]}]}})"
            << "" << 3;
        newRow("three.js without a matrix") << R"({"object": {"type": "Scene", "matrix": [],
            "children": [{"type": "Mesh", "matrix": []},
            {"type": "PerspectiveCamera", "fov": 50}]}})"
                                            << "" << 3;
        newRow("Record3D") << R"({"w": 640, "h": 480, "K": [9, 0, 0, 0, 9, 0, 5, 5, 1], "poses": [
            [0, 0, 0, 1, 0, 0, 0],
            [0, 0, 0, 0, 0, 0, 0]]})"
                           << "1" << 3;
        newRow("a short pose of Record3D") << R"({"w": 640, "h": 480, "K": [9, 0, 0, 0, 9, 0, 5, 5, 1], "poses": [
            [0, 0, 0, 1, 0, 0, 0],
            [0, 0, 0, 1]]})"
                                           << "1" << 3;
        newRow("NeRF") << "{\"fl_x\": 9, \"frames\": [{\"file_path\": \"a\"},\n"
                          "{\"file_path\": \"b\\\"{\", \"transform_matrix\": [1]},\n"
                          "{\"file_path\": \"c\",\n\"transform_matrix\": [2]}]}"
                       << "2" << 4;
    }

    void linesOfRecordsAreNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, image);
        QFETCH(int, line);
        const NamedText given{"a.json", text.toStdString()};
        CameraChoices choices;
        choices.image = image.toStdString();
        const auto read = readCamera({&given, 1}, choices);
        QVERIFY(read && !*read);
        QVERIFY2(read->error().line == line, read->error().message().c_str());
    }

    /// The camera.json is the file at fault, not the scene_camera.json.
    void filesOfBopAreNamed()
    {
        std::vector<NamedText> bop = textsOf(exampleOf("BOP"));
        for (NamedText &text : bop) {
            if (const std::size_t at = text.text.find("\"width\": 640"); at != text.text.npos)
                text.text.replace(at, 12, "\"width\": true");
        }
        const auto read = readCamera(bop, {});
        QVERIFY(read && !*read);
        QCOMPARE(read->error().file, std::string("camera.json"));
    }

    /// A camera of a model that is not read stands before the chosen image's.
    void colmapsLaterModelsArePassedOver()
    {
        const auto bytesOf = [](auto... values) {
            std::string bytes;
            (bytes.append(reinterpret_cast<const char *>(&values), sizeof values), ...);
            return bytes;
        };
        using Count = std::uint64_t;
        using Id = std::int32_t;
        const std::string images =
            bytesOf(Count(1), Id(1), 1., 0., 0., 0., 0., 0., 0., Id(3)) + std::string("a.png\0", 6) + bytesOf(Count(0));
        const auto with = [&](Id model, std::size_t parameters) {
            std::string cameras = bytesOf(Count(2), Id(7), model, Count(640), Count(480));
            for (std::size_t i = 0; i < parameters; ++i)
                cameras += bytesOf(1.);
            cameras += bytesOf(Id(3), Id(1), Count(640), Count(480), 500., 510., 320., 240.);
            return std::vector<NamedText>{{"cameras.bin", cameras}, {"images.bin", images}};
        };
        const std::size_t counts[]{16, 4, 5, 3, 4, 6, 2};
        for (Id i = 0; i < Id(std::size(counts)); ++i)
            QCOMPARE(reasonOf(with(11 + i, counts[i]), {}), QStringLiteral("read"));
        QVERIFY(reasonOf(with(18, 4), {}).contains("camera 7 has the model number 18, which is not known"));
        QVERIFY(
            reasonOf({{"cameras.txt", "1 FISHEYE 640 480 500 500 320 240\n"}, {"images.txt", "1 1 0 0 0 0 0 0 1 a\n"}},
                     {})
                .contains("the camera model FISHEYE is not read"));
    }

    /// The centre is in millimetres, the objects are in metres.
    void unitsOfACentreAreSuspected()
    {
        ForeignCamera camera;
        camera.intrinsics = Intrinsics{500.0, 500.0, 320.0, 240.0};
        camera.pose = glm::dmat4(1.0);
        camera.isDirectionCertain = camera.areAxesCertain = true;
        camera.axes = EyeAxes::RightDownAhead;
        camera.center = glm::dvec3(5000.0, 0.0, -5000.0);
        const auto scene = sceneCamera(camera, {}, geometry::Box{{4.5, -0.5, -0.5}, {5.5, 0.5, 0.5}});
        QVERIFY(scene);
        QStringList said;
        for (const std::string &one : scene->assumed)
            said << QString::fromStdString(one);
        QVERIFY2(said.join('\n').contains("with a translation 0.001 times as long it would"),
                 qPrintable(said.join('\n')));
    }

    /// Values without the words location and rotation, as Unreal spells them.
    void unrealsSpellingIsKnown()
    {
        const NamedText text{"log",
                             "X=120.000 Y=-340.000 Z=180.000 P=-12.5 Y=63.0 R=7.0\nFOV=90.0\nviewport 640x480\n"};
        QCOMPARE(readCamera({&text, 1}, {})->value().program, std::string("Unreal"));
    }

    void distortionOfReconstructions_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("wanted");
        const auto openMvg = [](const QString &lens) {
            return QStringLiteral(R"({"sfm_data_version": "0.3", "views": [{"value": {"ptr_wrapper": {"data":
                {"filename": "a.jpg", "id_view": 0, "id_intrinsic": 0, "id_pose": 0}}}}], "intrinsics": [{"key": 0,
                "value": {"polymorphic_name": "a_model", "ptr_wrapper": {"data": {"width": 640, "height": 480,
                "focal_length": 500, "principal_point": [320, 240], %1}}}}]})")
                .arg(lens);
        };
        const auto aliceVision = [](const QString &lens) {
            return QStringLiteral(R"({"version": ["1", "2", "5"], "views": [{"viewId": "1", "intrinsicId": "9",
                "path": "a.jpg"}], "intrinsics": [{"intrinsicId": "9", "width": "640", "height": "480",
                "focalLength": "30", "principalPoint": ["0", "0"], %1}]})")
                .arg(lens);
        };
        const auto openSfm = [](const QString &lens) {
            return QStringLiteral(R"([{"cameras": {"c": {"width": 640, "height": 480, "focal": 0.8, %1}}, "shots":
                {"a.jpg": {"camera": "c", "rotation": [0, 0, 0], "translation": [0, 0, 0]}}}])")
                .arg(lens);
        };
        const char *brown = "k1 = 0.1, k2 = 0.2, p1 = 0.3, p2 = 0.4, k3 = 0.5";
        newRow("OpenMVG, k1") << openMvg(R"("disto_k1": [0.1])") << "k1 = 0.1";
        newRow("OpenMVG, t2") << openMvg(R"("disto_t2": [0.1, 0.2, 0.5, 0.3, 0.4])") << brown;
        newRow("OpenMVG, fisheye") << openMvg(R"("fisheye": [0, 0, 0, 0])") << "the camera model a_model is not read";
        newRow("AliceVision, brown") << aliceVision(
            R"("type": "brown", "distortionParams": ["0.1", "0.2", "0.5", "0.3", "0.4"])")
                                     << brown;
        newRow("AliceVision, later radial")
            << aliceVision(R"("type": "pinhole", "distortionType": "radialk1", "distortionParams": ["0.1"])")
            << "k1 = 0.1";
        newRow("AliceVision, fisheye") << aliceVision(R"("type": "fisheye4", "distortionParams": ["0", "0", "0", "0"])")
                                       << "the camera model fisheye4 is not read";
        newRow("AliceVision, 3DE") << aliceVision(R"("type": "3declassicld", "distortionParams": ["0.1", "0"])")
                                   << "the camera model 3declassicld is not read";
        newRow("AliceVision, 3DE of zeros")
            << aliceVision(R"("type": "3declassicld", "distortionParams": ["0", "0"])") << "";
        newRow("AliceVision, undistortion")
            << aliceVision(R"("type": "pinhole", "undistortionParams": ["0.1"])") << "the camera model pinhole is not";
        newRow("OpenSfM, brown") << openSfm(
            R"("projection_type": "brown", "focal_x": 0.8, "focal_y": 0.8, "k1": 0.1, "k2": 0.2, "p1": 0.3,
                          "p2": 0.4, "k3": 0.5)")
                                 << brown;
        newRow("OpenSfM, fisheye") << openSfm(R"("projection_type": "fisheye", "k1": 0.0)")
                                   << "the camera model fisheye is not read";
    }

    void distortionOfReconstructions()
    {
        QFETCH(QString, text);
        QFETCH(QString, wanted);
        const std::vector<NamedText> texts{{"a.json", text.toStdString()}};
        const auto read = readCamera(texts, {});
        QVERIFY(read);
        if (*read)
            QCOMPARE(QString::fromStdString(coefficientsText((*read)->distortion.value_or(Distortion()))), wanted);
        else
            QVERIFY2(reasonOf(texts, {}).contains(wanted) && !wanted.isEmpty(), qPrintable(reasonOf(texts, {})));
        CameraChoices choices;
        choices.isUndistorted = true;
        QCOMPARE(reasonOf(texts, choices), QStringLiteral("read"));
    }

    /// The first view without a pose is not the first that is read; ids choose as names do.
    void viewsOfReconstructionsAreChosen()
    {
        const auto read = readCamera(textsOf(exampleOf("AliceVision")), {});
        QVERIFY(read && *read);
        QCOMPARE((*read)->images, std::vector<std::string>{"/sequence/1120.exr"});
        CameraChoices choices;
        for (const char *image : {"6", "IMG_0006.JPG", "1"}) {
            choices.image = image;
            QCOMPARE(readCamera(textsOf(exampleOf("OpenMVG")), choices)->value().image, std::size_t(1));
        }
        choices.image = "7"; // a view without a pose
        QVERIFY(reasonOf(textsOf(exampleOf("OpenMVG")), choices).contains("there is no image \"7\" among 2"));
        choices.image = "725903f5b62f56118f4094b46a4470d8";
        QCOMPARE(readCamera(textsOf(exampleOf("nuScenes")), choices)->value().image, std::size_t(1));
        const auto ofRig = changed("AliceVision", R"("frameId": "1120")", R"("rigId": "3", "isPoseIndependant": "0")");
        QVERIFY2(reasonOf(ofRig, {}).contains("the pose of /sequence/1120.exr is that of its rig"),
                 qPrintable(reasonOf(ofRig, {})));
    }

    /// Metashape's p1 is OpenCV's p2. A label or an id chooses; a camera without a transform is left out.
    void camerasOfMetashapeAreChosen()
    {
        const std::vector<NamedText> texts = textsOf(exampleOf("Metashape"));
        CameraChoices choices;
        for (const char *image : {"7", "DJI 12-12-2019, 11 50.jpg", "1"}) {
            choices.image = image;
            const ForeignCamera camera = readCamera(texts, choices)->value();
            QCOMPARE(camera.image, std::size_t(1));
            QCOMPARE(coefficientsText(*camera.distortion),
                     std::string("k1 = -0.0446, k2 = 0.0207, p1 = 0.0023, p2 = -0.0012, k3 = -0.0912"));
        }
        choices.image = "IMG_0002";
        QVERIFY(reasonOf(texts, choices).contains("there is no image \"IMG_0002\" among 2 (IMG_0001, DJI"));
        const NamedText none{"cameras.xml",
                             "<document><chunk><sensors/><cameras><camera id='0'/></cameras></chunk>"
                             "<!DOCTYPE a [<!ENTITY b 'c'>]><![CDATA[</document>]]><sensor/></document>"};
        QVERIFY2(reasonOf({none}, {}).contains("no camera has a transform"), qPrintable(reasonOf({none}, {})));
    }

    /// Readers recurse, and look for each name among all of an element.
    void xmlIsLimited()
    {
        std::string deep = "<mujoco>", wide = "<mujoco><camera";
        for (int i = 0; i < 100'000; ++i) {
            deep += "<body>";
            wide += " a" + std::to_string(i) + "=''";
        }
        for (const std::string &text : {deep, wide + "/></mujoco>"})
            QVERIFY2(reasonOf({{"scene.xml", text}}, {}).contains("more than 256 levels"),
                     qPrintable(reasonOf({{"scene.xml", text}}, {})));
        const NamedText open{"scene.xml", "<mujoco>\n<worldbody>\n<camera pos='0 0 1'/>\n</mujoco>"};
        QCOMPARE(readCamera({&open, 1}, {})->error().line, 4);
        const NamedText shortPose{"scene.xml", "<mujoco>\n<camera pos='0 1'/>\n</mujoco>"};
        QCOMPARE(readCamera({&shortPose, 1}, {})->error().line, 2);
        const NamedText noList{"a.gltf",
                               R"({"asset":{},"cameras":[{"perspective":{"yfov":1}}],"nodes":{"a":{"camera":0}}})"};
        QVERIFY(!readCamera({&noList, 1}, {}));
        const NamedText blanks{"scene.xml", "<mujoco >\n<camera pos =\n '0 0 1'  fovy= '45' />\n</mujoco >"};
        CameraChoices choices;
        choices.size = ImageSize{640, 480};
        const auto camera = readCamera({&blanks, 1}, choices);
        QVERIFY(camera && *camera && (**camera).pose);
        QCOMPARE((*(**camera).pose)[3].z, 1.0);
    }

    void partsOfCapturesAreToldApart()
    {
        const std::vector<NamedText> bop = textsOf(exampleOf("BOP"));
        QVERIFY(readCamera(bop, {})->value().size == (ImageSize{320, 240})); // its own
        CameraChoices choices;
        choices.image = "000048.png";
        QVERIFY(readCamera(bop, choices)->value().size == (ImageSize{640, 480}));
        QCOMPARE(reasonOf({bop[1]}, {}), QStringLiteral("read"));
        QVERIFY(assumedOf(bop, {}).contains("Lengths are in millimetres"));
        const NamedText objects{"scene_gt.json", R"({"48": [{"cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1],
                                                            "cam_t_m2c": [0, 0, 500], "obj_id": 1}]})"};
        QVERIFY(reasonOf({objects}, {}).contains("scene_gt.json has the poses of objects and no camera"));
        QVERIFY(reasonOf({bop[0], objects}, {}).contains("nothing in it is read"));
        // Without a path, its key frames count.
        const NamedText frames{"camera_path.json",
                               R"({"camera_path": [], "render_width": 640, "render_height": 480, "keyframes": [
                                   {"matrix": [1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9, 0, 0, 0, 1], "fov": 60}]})"};
        QCOMPARE((*readCamera({&frames, 1}, {})->value().pose)[3], glm::dvec4(7.0, 8.0, 9.0, 1.0));
        choices.image.clear();
        choices.size = ImageSize{640, 480};
        QVERIFY(reasonOf(changed("three.js", R"("filmOffset": 0)", R"("filmOffset": 2)"), choices)
                    .contains("a camera with filmOffset or setViewOffset is not read"));
    }

    void posesInAParentAreSaid()
    {
        const NamedText unity{"Main.unity", "m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}\n"
                                            "m_LocalPosition: {x: 1, y: 2, z: 3}\nfield of view: 60\n"};
        const NamedText unreal{"paste", "RelativeLocation=(X=1.0,Y=2.0,Z=3.0)\n"
                                        "RelativeRotation=(Pitch=0.0,Yaw=90.0,Roll=0.0)\nFieldOfView=90.0\n"};
        CameraChoices choices;
        choices.size = ImageSize{640, 480};
        const QString inUnity = assumedOf({unity}, choices), inUnreal = assumedOf({unreal}, choices);
        QVERIFY2(inUnity.contains("m_LocalPosition and m_LocalRotation count as the camera's pose in the world"),
                 qPrintable(inUnity));
        QVERIFY2(inUnreal.contains("RelativeLocation and RelativeRotation count as the camera's pose in the world"),
                 qPrintable(inUnreal));
        const NamedText blender{"paste", "rotation_euler = Euler((1, 2, 3), 'XYZ')\nlocation = 1, 2, 3\nlens = 50\n"};
        const QString inBlender = assumedOf({blender}, choices);
        QVERIFY2(inBlender.contains("location and rotation_euler count as the camera's pose in the world"),
                 qPrintable(inBlender));
        QVERIFY(!assumedOf(textsOf(exampleOf("Unity, transform")), {}).contains("without parent"));
        QVERIFY(!assumedOf(textsOf(exampleOf("Unreal")), {}).contains("without parent"));
    }

    /// Blender divides whole numbers: 720 * 70 / 100 is 504.
    void blendersSizeIsAWholePercentage()
    {
        const auto texts = changed("Blender", "resolution_x = 800\nresolution_y = 600",
                                   "resolution_x = 1280\nresolution_y = 720\nresolution_percentage = 70");
        const auto read = readCamera(texts, {});
        QVERIFY(read && *read);
        QVERIFY((*read)->size == (ImageSize{896, 504}));
    }

    /// The object's type, CAMERA, may stand before that of its data.
    void blendersCameraTypeIsFound()
    {
        const auto texts = changed("Blender", "lens = 50.0",
                                   "camera.type = 'CAMERA'\ndata.type = 'ORTHO'\northo_scale = 7.0\nclip_start = 0.1\n"
                                   "clip_end = 100.0");
        const auto read = readCamera(texts, {});
        QVERIFY(read);
        QVERIFY2(*read, *read ? "" : (*read).error().message().c_str());
        QVERIFY((*read)->projection && (*read)->projection->clipFromEye[2][3] == 0.0);
    }

    void computedCentresStayInTheMiddle_data()
    {
        addColumn<QString>("program");
        for (const char *name : {"Unity, transform", "Unreal", "Unity, matrices", "NeRF, made with Blender", "Blender",
                                 "Gaussian splatting, cameras.json"})
            newRow(name) << name;
    }

    /// No pixel's coordinates are in the text, so the first pixel's centre does not count.
    void computedCentresStayInTheMiddle()
    {
        QFETCH(QString, program);
        const CameraExample &example = exampleOf(program.toUtf8().constData());
        CameraChoices choices = choicesOf(example);
        const auto read = readCamera(textsOf(example), choices);
        QVERIFY(read && *read);
        QVERIFY(!hasCentres(**read));
        const auto plainly = sceneCamera(**read, choices, std::nullopt);
        choices.centres = PixelCentres::AtIntegers;
        const auto scene = sceneCamera(**read, choices, std::nullopt);
        QVERIFY(plainly && scene);
        QCOMPARE(clipFromEyeOf(*scene), clipFromEyeOf(*plainly));
        const std::vector<std::string> &said = scene->assumed;
        QVERIFY(std::find(said.begin(), said.end(), "The file has no pixel coordinates, so --pixel-centers is ignored.")
                != said.end());
    }

    void namesAndValuesAreFound()
    {
        const NamedValues values("near clip plane: 0.3\n\"far\": 50,\nsize 800 x 600\nLocation X=1 Y=-2.5 Z=3\n"
                                 "rotation:\n  x: 0.1\n  w: 0.9\ncam.data.lens = 35.0 mm\nfit = 'AUTO'\n"
                                 "m = np.array([[1., 2.],\n [3e1, 4]], dtype=float32)\nyfov=np.pi / 3.0, n=2\n"
                                 "angle = math.radians(90)\n# fov = 12\npose\n[[1 2]\n [3 4]]\n");
        QCOMPARE(values.numbers("nearclipplane", 1).at(0), 0.3);
        QCOMPARE(values.numbers("clipplane", 1).at(0), 0.3);
        QCOMPARE(values.numbers("far", 1).at(0), 50.0);
        QCOMPARE(values.numbers({"size"}, 2), (std::vector<double>{800, 600}));
        QCOMPARE(values.numbers({"location"}, 3, {"x", "y", "z"}), (std::vector<double>{1, -2.5, 3}));
        QCOMPARE(values.numbers({"rotation"}, 2, {"x", "w"}), (std::vector<double>{0.1, 0.9}));
        QCOMPARE(values.numbers("lens", 1).at(0), 35.0);
        QCOMPARE(QByteArray::fromStdString(values.find({"fit"})->word), QByteArray("AUTO"));
        QCOMPARE(values.numbers({"m"}, 4), (std::vector<double>{1, 2, 30, 4}));
        QCOMPARE(values.numbers("yfov", 1).at(0), std::acos(-1.0) / 3.0);
        QCOMPARE(values.numbers("n", 1).at(0), 2.0);
        QCOMPARE(values.numbers("angle", 1).at(0), std::acos(-1.0) / 2.0);
        QVERIFY(!values.has({"fov"}));
        QCOMPARE(values.numbers({"pose"}, 4), (std::vector<double>{1, 2, 3, 4}));
        QCOMPARE(values.find({"lens"})->line, std::size_t(8));
    }

    void namesAreFoundInAnyText_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QVector<double>>("numbers");
        const QVector<double> k{800, 0, 320, 0, 801, 240, 0, 0, 1};
        newRow("R") << QByteArray(
            "K:\n     [,1] [,2] [,3]\n[1,]  800    0  320\n[2,]    0  801  240\n[3,]    0    0    1\n")
                    << k;
        newRow("XML") << QByteArray(
            "<?xml version=\"1.0\"?>\n<a><!-- <K>1</K> -->\n<K t=\"3\">800 0 320\n0 801 240 0 0 1</K></a>")
                      << k;
        newRow("C++") << QByteArray("cv::Matx33d K(800, 0, 320, 0, 801, 240, 0, 0, 1); // 3x3\n") << k;
        newRow("Mathematica") << QByteArray("K = {{8.*^2, 0, 320.}, {0, 801., 2.4*^2}, {0, 0, 1}}") << k;
        newRow("decimal commas, U+2212") << QByteArray("K: 0,5 \xe2\x88\x92"
                                                       "1,5 2,5 3,5 4,5 5,5")
                                         << QVector<double>{0.5, -1.5, 2.5, 3.5, 4.5, 5.5};
        newRow("MATLAB's factor") << QByteArray("K =\n\n   1.0e+03 *\n\n   0.5   0.25\n") << QVector<double>{500, 250};
        newRow("a comment") << QByteArray("# K: pixels from eye\n1 2 3 # 4\n") << QVector<double>{1, 2, 3};
        newRow("zeros") << QByteArray("K = cv::Mat::zeros(3, 1, CV_64F);") << QVector<double>{0, 0, 0};
        newRow("keys") << QByteArray("{\"K\": {\"0\": 5, \"1\": 6}}") << QVector<double>{5, 6};
    }

    void namesAreFoundInAnyText()
    {
        QFETCH(QByteArray, text);
        QFETCH(QVector<double>, numbers);
        const std::vector<double> found = NamedValues(text.toStdString()).numbers({"k"}, 1);
        QCOMPARE(QVector<double>(found.begin(), found.end()), numbers);
    }

    void wordsStayWhole()
    {
        const NamedValues values("distortion_model: radial-tangential\nmodel = Inverse Brown Conrady\n");
        QCOMPARE(QByteArray::fromStdString(values.find({"distortionmodel"})->word), QByteArray("radial-tangential"));
        QCOMPARE(QByteArray::fromStdString(values.all().back().word), QByteArray("Inverse Brown Conrady"));
    }

    /// Parts of the texts are cut out, doubled, or replaced. Any answer is right, if there is one.
    void damagedTextsAreAnswered()
    {
        std::uint32_t state = 1;
        const auto random = [&state](std::size_t below) {
            state = state * 1664525U + 1013904223U;
            return std::size_t(state >> 8U) % std::max<std::size_t>(below, 1);
        };
        int read = 0, refused = 0;
        for (int round = 0; round < 100; ++round) {
            for (const CameraExample &example : cameraExamples()) {
                std::vector<NamedText> texts = textsOf(example);
                std::string &text = texts[random(texts.size())].text;
                const std::size_t at = random(text.size()), length = random(20);
                constexpr std::string_view kParts[] = {"", "nan", "1e999", "[", "]]]", "\"", "-", "0 0 0", "\n", "{}"};
                if (round % 3 == 0)
                    text.insert(at, text.substr(at, length));
                else
                    text.replace(at, length, kParts[random(std::size(kParts))]);
                const auto camera = readCamera(texts, choicesOf(example));
                if (camera && *camera)
                    ++(sceneCamera(**camera, choicesOf(example), std::nullopt) ? read : refused);
                else
                    ++refused;
            }
        }
        QVERIFY(read > 100 && refused > 100);
    }
};

UNPROJECTOR_TEST(TestCameraReaders)
#include "test_camera_readers.moc"

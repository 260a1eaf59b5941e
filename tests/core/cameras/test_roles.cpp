// What the name of numbers tells: the part of a camera, and the direction of a pose. Nothing that looks like a part is
// dropped without a word.

#include "tests/support/test.h"

#include "core/cameras/foreign_camera.h"
#include "core/cameras/roles.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace unprojector;
using namespace unprojector::cameras;

namespace {

/// The camera looks from (1.5, -2, 3.25) along (0.28, 0, 0.96) of the world, with OpenCV's axes.
constexpr const char *kToWorld = "0.96 0 0.28 1.5  0 1 0 -2  -0.28 0 0.96 3.25  0 0 0 1";
constexpr const char *kToCamera = "0.96 0 -0.28 -0.53  0 1 0 2  0.28 0 0.96 -3.54  0 0 0 1";
const std::string kK = "K = 600 0 320  0 600 240  0 0 1\nsize: 640x480\n";

base::Expected<SceneCamera, base::Error> read(const std::vector<NamedText> &texts, CameraChoices choices = {})
{
    choices.axes = choices.axes.value_or(EyeAxes::RightDownAhead);
    const auto camera = readCamera(texts, choices);
    if (!camera)
        return base::Error{"not recognised"};
    if (!*camera)
        return camera->error();
    return sceneCamera(**camera, choices, std::nullopt);
}

base::Expected<SceneCamera, base::Error> read(const std::string &text, const CameraChoices &choices = {})
{
    return read(std::vector<NamedText>{{"a.txt", text}}, choices);
}

QString reasonOf(const base::Expected<SceneCamera, base::Error> &scene)
{
    return scene ? QString() : QString::fromStdString(scene.error().file + ": " + scene.error().text);
}

QString assumedIn(const SceneCamera &scene)
{
    QString text;
    for (const std::string &sentence : scene.assumed)
        text += QString::fromStdString(sentence) + '\n';
    return text;
}

/// The largest difference of the view from that of the camera above.
double missOf(const SceneCamera &scene)
{
    const glm::dmat4 wanted(0.96, 0, -0.28, 0, 0, -1, 0, 0, -0.28, 0, -0.96, 0, -0.53, -2, 3.54, 1);
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(scene.eyeFromWorld[i / 4][i % 4] - wanted[i / 4][i % 4]));
    return largest;
}

} // namespace

class TestRoles : public QObject {
    Q_OBJECT

private slots:
    void namesTellTheDirection_data()
    {
        addColumn<QString>("name");
        addColumn<bool>("isToWorld");
        for (const char *name : {"T_world_camera",
                                 "T_world_cam",
                                 "world_T_cam",
                                 "wTc",
                                 "T_cam2world",
                                 "T_c2w",
                                 "T_camera_to_world",
                                 "X_WC",
                                 "T_WC",
                                 "Twc",
                                 "world_from_camera",
                                 "worldFromCam",
                                 "matrix_world",
                                 "cam2world",
                                 "cameraToWorld",
                                 "camera_in_world",
                                 "extrinsics_c2w",
                                 "T_BS",
                                 "body_T_cam0",
                                 "map_T_camera_optical",
                                 "camera_pose",
                                 "camera_transform",
                                 "pose",
                                 "Camera to World Transform"})
            addRow("%s", name) << QString(name) << true;
        for (const char *name :
             {"T_cam_world", "T_camera_world", "cam_T_world", "cTw", "Tcw", "T_w2c", "mTcw", "T_world2cam",
              "world2camera", "cam_from_world", "T_CW", "worldToCamera", "w2c_matrix", "T_cam_imu", "extrinsic", "RT",
              "camera_extrinsics", "extrinsic_color", "World to Camera Transform"})
            addRow("%s", name) << QString(name) << false;
    }

    void namesTellTheDirection()
    {
        QFETCH(QString, name);
        QFETCH(bool, isToWorld);
        const std::string pose = isToWorld ? kToWorld : kToCamera;
        for (const std::string &text :
             {kK + name.toStdString() + ":\n" + pose + '\n', kK + '"' + name.toStdString() + "\": [" + pose + "]\n"}) {
            const auto scene = read(text);
            QVERIFY2(scene, qPrintable(reasonOf(scene)));
            QCOMPARE(scene->direction, isToWorld ? PoseDirection::CameraToWorld : PoseDirection::WorldToCamera);
            QVERIFY2(missOf(*scene) < 1e-12, qPrintable(assumedIn(*scene)));
        }
    }

    void partsTellTheDirection_data()
    {
        addColumn<QString>("parts");
        const QString toWorld = "0.96 0 0.28  0 1 0  -0.28 0 0.96", toCamera = "0.96 0 -0.28  0 1 0  0.28 0 0.96";
        newRow("R and t to the world") << "R_c2w = " + toWorld + "\nt_c2w = 1.5 -2 3.25";
        newRow("R and t to the camera") << "cam_R_w2c = " + toCamera + "\ncam_t_w2c = -0.53 2 -3.54";
        newRow("R and C") << "R = " + toCamera + "\nC = 1.5 -2 3.25";
        newRow("rotation and center") << "rotation = " + toCamera + "\ncenter = 1.5 -2 3.25";
        newRow("an object's position and rotation") << "camera_position = 1.5 -2 3.25\ncamera_rotation = " + toWorld;
        newRow("R to the world and C") << "R_c2w = " + toWorld + "\ncamera_center = 1.5 -2 3.25";
    }

    void partsTellTheDirection()
    {
        QFETCH(QString, parts);
        const auto scene = read(kK + parts.toStdString() + '\n');
        QVERIFY2(scene, qPrintable(reasonOf(scene)));
        QVERIFY2(missOf(*scene) < 1e-12, qPrintable(assumedIn(*scene)));
    }

    /// The camera above is turned about y by 2 asin 0.1414…: w = 0.98994949366, y = 0.14142135624.
    void quaternionsHaveTheOrderOfTheirName()
    {
        for (const char *pose : {"rotation_xyzw: [0, 0.14142135623730951, 0, 0.98994949366116658]",
                                 "q_wxyz: [0.98994949366116658, 0, 0.14142135623730951, 0]"}) {
            const auto scene = read(kK + "position: [1.5, -2, 3.25]\n" + pose + '\n');
            QVERIFY2(scene && missOf(*scene) < 1e-12, qPrintable(reasonOf(scene) + assumedIn(scene.value())));
        }
    }

    void lensesInTwoParts_data()
    {
        addColumn<QString>("text");
        addColumn<double>("cx");
        newRow("focal_length") << "focal_length: [600, 610]\nprincipal_point: [320, 240]" << 320.0;
        newRow("one by one")
            << "focal_length_x: 600\nfocal_length_y: 610\nprincipal_point_x: 320\nprincipal_point_y: 240" << 320.0;
        newRow("MATLAB's count from 1") << "FocalLength: [600 610]\nPrincipalPoint: [320 240]\nImageSize: [480 640]"
                                        << 319.0;
        newRow("MATLAB's matrix") << "IntrinsicMatrix =\n  600 0 0\n  0 610 0\n  320 240 1" << 319.0;
    }

    void lensesInTwoParts()
    {
        QFETCH(QString, text);
        QFETCH(double, cx);
        const auto scene = read(text.toStdString() + '\n');
        QVERIFY2(scene, qPrintable(reasonOf(scene)));
        QCOMPARE(scene->intrinsics->cx, cx);
        QCOMPARE(scene->intrinsics->fy, 610.0);
    }

    /// --pose says of R beside C which way R leads; C stays the camera's position.
    void theCenterStaysWhereItIs()
    {
        CameraChoices choices;
        choices.direction = PoseDirection::CameraToWorld;
        const auto scene = read(kK + "R = 0.96 0 0.28  0 1 0  -0.28 0 0.96\nC = 1.5 -2 3.25\n", choices);
        QVERIFY2(scene && missOf(*scene) < 1e-12, qPrintable(reasonOf(scene)));
    }

    void lensesHavePrefixesAndSuffixes_data()
    {
        addColumn<QString>("name");
        for (const char *name : {"cam_K", "K_02", "K_left", "intrinsic_color", "depth_intrinsics", "camera_intrinsic",
                                 "intrinsicMatrix", "color_camera_matrix"})
            addRow("%s", name) << QString(name);
    }

    void lensesHavePrefixesAndSuffixes()
    {
        QFETCH(QString, name);
        const auto scene = read(name.toStdString() + " = 600 0 320  0 600 240  0 0 1\n");
        QVERIFY2(scene && scene->intrinsics->fx == 600.0, qPrintable(reasonOf(scene)));
        const auto wide = read('"' + name.toStdString() + "\": [600, 0, 320, 0,  0, 600, 240, 0,  0, 0, 1, 0]\n");
        QVERIFY2(wide && wide->intrinsics->cy == 240.0, qPrintable(reasonOf(wide)));
    }

    void nothingTellsTheDirection_data()
    {
        addColumn<QString>("name");
        for (const char *name : {"T", "transform", "matrix", "m4"})
            addRow("%s", name) << QString(name);
    }

    void nothingTellsTheDirection()
    {
        QFETCH(QString, name);
        const std::string text = kK + name.toStdString() + " = [" + kToWorld + "]\n";
        QCOMPARE(reasonOf(read(text)).section(':', 1).trimmed(),
                 "nothing tells its direction. From the camera to the world, the eye is at (1.5, -2, 3.25) "
                 "and looks along (0.28, 0, 0.96); from the world to the camera, it is at (-0.53, 2, -3.54) and looks "
                 "along (-0.28, 0, 0.96). Choose with --pose camera-to-world or --pose world-to-camera");
        CameraChoices choices;
        choices.direction = PoseDirection::CameraToWorld;
        const auto chosen = read(text, choices);
        QVERIFY2(chosen && missOf(*chosen) < 1e-12, qPrintable(reasonOf(chosen)));
    }

    void whatIsNotUsedIsNamed_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("names");
        newRow("between two cameras") << QString("T_cam0_cam1: [%1]").arg(kToCamera) << "T_cam0_cam1 (16 numbers)";
        newRow("a sensor's to another") << QString("color_to_depth_extrinsics: [%1]").arg(kToCamera)
                                        << "color_to_depth_extrinsics (16 numbers)";
        newRow("a rectification") << QString("pose: [%1]\nR_rect: 1 0 0  0 1 0  0 0 1").arg(kToWorld)
                                  << "R_rect (9 numbers)";
        newRow("a position beside a pose")
            << QString("pose: [%1]\nposition: 1 2 3").arg(kToWorld) << "position (3 numbers)";
        newRow("an uncertainty") << QString("pose: [%1]\npose_std: 1 2 3 4 5 6").arg(kToWorld)
                                 << "pose_std (6 numbers)";
        newRow("a list that no name tells") << "lens_poly: [0.1, 0.2, 0.3, 0.4]"
                                            << "lens_poly (4 numbers)";
        newRow("another thing's pose") << QString("R = 1 0 0 0 1 0 0 0 1\nt = 0 0 0\nmarker_pose: [%1]").arg(kToCamera)
                                       << "marker_pose (16 numbers)";
        newRow("in another object") << "imu: {rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], translation: [1, 2, 3]}"
                                    << "rotation (9 numbers), translation (3 numbers)";
    }

    void whatIsNotUsedIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, names);
        const auto scene = read(kK + text.toStdString() + '\n');
        QVERIFY2(scene, qPrintable(reasonOf(scene)));
        QVERIFY2(assumedIn(*scene).contains("Not used: " + names + ".\n"), qPrintable(assumedIn(*scene)));
    }

    void namesOfOtherThingsAreNoPart_data()
    {
        addColumn<QString>("name");
        for (const char *name : {"rms", "pose_std", "T_cam0_cam1", "T_base_world", "robot", "xyz", "inverse K"})
            addRow("%s", name) << QString(name);
    }

    void namesOfOtherThingsAreNoPart()
    {
        QFETCH(QString, name);
        QVERIFY(!roleOf(name.toStdString(), 16));
    }

    /// Twice the principal point tells the order; where it does not, MATLAB's name does.
    void sizesMayBeHeightFirst()
    {
        const auto sizeOfText = [](const std::string &text) { return read(text).value().size; };
        const std::string k = "K = 600 0 320  0 600 240  0 0 1\n", square = "K = 600 0 300  0 600 300  0 0 1\n";
        QCOMPARE(sizeOfText(k + "ImageSize = [480 640]\n"), (ImageSize{640, 480}));
        QCOMPARE(sizeOfText(k + "image_size: [480, 640]\n"), (ImageSize{640, 480}));
        QCOMPARE(sizeOfText(k + "image_size: [640, 480]\n"), (ImageSize{640, 480}));
        QCOMPARE(sizeOfText(square + "ImageSize = [480 640]\n"), (ImageSize{640, 480}));
        QCOMPARE(sizeOfText(square + "image_size: [640, 480]\n"), (ImageSize{640, 480}));
        QVERIFY(assumedIn(read(k + "ImageSize = [480 640]\n").value())
                    .contains("ImageSize is read as height, width: the image is 640x480."));
    }

    void everyFileIsRead()
    {
        CameraChoices choices;
        const NamedText lens{"lens.json", "{\"fx\": 600, \"fy\": 600, \"cx\": 320, \"cy\": 240}"};
        QCOMPARE(reasonOf(read({lens, {"notes.txt", "a: 1\n"}})),
                 "notes.txt: nothing in it is read; leave it out, or give its numbers the names of a camera's parts");
        const std::string rows = std::string(kToCamera) + '\n' + kToWorld + '\n';
        QVERIFY(reasonOf(read({lens, {"rows.txt", rows}})).contains("nothing tells its direction"));
        choices.direction = PoseDirection::CameraToWorld;
        choices.image = "1";
        const auto second = read({lens, {"traj.txt", rows}}, choices);
        QVERIFY2(second && missOf(*second) < 1e-12, qPrintable(reasonOf(second)));
        const auto named = read({lens, {"pose.txt", kToWorld}});
        QVERIFY2(named && missOf(*named) < 1e-12, qPrintable(reasonOf(named)));
    }

    void camerasHaveTheNamesOfTheirSections_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("image");
        const QString pose = QString("[%1]").arg(kToCamera);
        newRow("YAML") << "cam0:\n  intrinsics: [500, 500, 320, 240]\n  T_cam_imu: [0.1]\ncam1:\n  intrinsics: [600, "
                          "600, 320, 240]\n  T_cam_imu: "
                              + pose
                       << "cam1";
        newRow("YAML's items")
            << "cameras:\n- name: left\n  K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n- name: right\n  K: "
               "[600, 0, 320, 0, 600, 240, 0, 0, 1]\n  T_cam_world: "
                   + pose
            << "right";
        newRow("JSON") << "{\"a\": {\"fx\": 500, \"fy\": 500, \"cx\": 320, \"cy\": 240}, \"b\": {\"fx\": 600, \"fy\": "
                          "600, \"cx\": 320, \"cy\": 240, \"extrinsic\": "
                              + pose + "}}"
                       << "b";
        newRow("JSON's items")
            << "[{\"id\": \"0a\", \"K\": [500, 0, 320, 0, 500, 240, 0, 0, 1]}, {\"id\": \"0b\", \"K\": "
               "[600, 0, 320, 0, 600, 240, 0, 0, 1], \"extrinsic\": "
                   + pose + "}]"
            << "0b";
        newRow("sections") << "[LEFT]\nfx=500\nfy=500\ncx=320\ncy=240\n[RIGHT]\nfx=600\nfy=600\ncx=320\ncy=240\nRT = "
                                  + pose
                           << "RIGHT";
        newRow("numbers behind the names") << "K_00: 500 0 320 0 500 240 0 0 1\nRT_00: 1 0 0 0 0 1 0 0 0 0 1 0\n"
                                              "K_02: 600 0 320 0 600 240 0 0 1\nRT_02: "
                                                  + QString(kToCamera)
                                           << "02";
        newRow("the name of K") << "K_left: 500 0 320 0 500 240 0 0 1\nK_right: 600 0 320 0 600 240 0 0 1\nRT_right: "
                                       + QString(kToCamera)
                                << "K_right";
    }

    void camerasHaveTheNamesOfTheirSections()
    {
        QFETCH(QString, text);
        QFETCH(QString, image);
        CameraChoices choices;
        choices.image = image.toStdString();
        const auto scene = read(text.toStdString() + '\n', choices);
        QVERIFY2(scene, qPrintable(reasonOf(scene)));
        QCOMPARE(scene->intrinsics->fx, 600.0);
        QVERIFY2(missOf(*scene) < 1e-12, qPrintable(assumedIn(*scene)));
        const auto first = read(text.toStdString() + '\n');
        QVERIFY2(!first || assumedIn(*first).contains("The first of 2 images is read, "),
                 qPrintable(assumedIn(*first)));
    }

    /// R and t beside two cameras may lead from one to the other.
    void stereoPairsAreRefused()
    {
        const auto scene = read("K_left: 500 0 320 0 500 240 0 0 1\nK_right: 600 0 320 0 600 240 0 0 1\n"
                                "R: 1 0 0 0 1 0 0 0 1\nT: 0.1 0 0\n");
        QVERIFY2(reasonOf(scene).contains("the text has 2 camera matrices, but 1 of this"),
                 qPrintable(reasonOf(scene)));
    }

    void transformsOfSensorsAreNoPose()
    {
        const auto scene =
            read("color: {fx: 600, fy: 600, cx: 320, cy: 240}\ndepth_to_color: {rotation: [1, 0, 0, 0, 1, 0, "
                 "0, 0, 1], translation: [0.1, 0, 0]}\n");
        QVERIFY2(scene, qPrintable(reasonOf(scene)));
        QVERIFY2(assumedIn(*scene).contains("Not used: rotation (9 numbers), translation (3 numbers).\n"),
                 qPrintable(assumedIn(*scene)));
    }

    void partsOfOtherCamerasAreNotMixed()
    {
        const auto unusedIn = [](const std::string &text) { return assumedIn(read(text).value()); };
        const std::string pose = std::string(": ") + kToCamera + '\n';
        QVERIFY(
            unusedIn("K_left: 600 0 320 0 600 240 0 0 1\nT_right_world" + pose).contains("T_right_world (16 numbers)"));
        CameraChoices second;
        second.image = "1";
        const auto scene = read("K_cam0: 500 0 320 0 500 240 0 0 1\nK_cam1: 600 0 320 0 600 240 0 0 1\nT_cam1_world"
                                    + pose + "T_cam0_world: 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n",
                                second);
        QVERIFY2(scene && scene->intrinsics->fx == 600.0 && missOf(*scene) < 1e-12, qPrintable(reasonOf(scene)));
        const auto display =
            read("{\"display\": {\"width\": 1920, \"height\": 1080}, \"camera\": {\"K\": [600, 0, 320, 0, "
                 "600, 240, 0, 0, 1]}}");
        QVERIFY(display);
        QCOMPARE(display->size, (ImageSize{640, 480}));
    }

    /// RadialDistortion and TangentialDistortion are k1, k2, k3 and p1, p2.
    void matlabsDistortionIsRead()
    {
        const auto camera = readCamera(std::vector<NamedText>{{"a.m", kK
                                                                          + "RadialDistortion: [0.1, 0.2]\n"
                                                                            "TangentialDistortion: [0.3, 0.4]\n"}},
                                       {});
        QVERIFY(camera && *camera);
        QCOMPARE((*camera)->distortion.value(), (Distortion{0.1, 0.2, 0.3, 0.4, 0.0}));
    }

    void rotationVectorsAreShort()
    {
        QVERIFY(reasonOf(read(kK + "rotation = 10 20 30\nt = 1 2 3\n"))
                    .contains("a rotation vector in radians has at most"));
        const auto scene = read(kK + "R = 0.1 0.2 0.3\nt = 1 2 3\n");
        QVERIFY(scene
                && assumedIn(*scene).contains("The three numbers of R are read as a rotation vector, in radians."));
    }

    /// P of a rectified image has K; the pose stands beside it.
    void aRectifiedPGivesK()
    {
        const auto scene = read("P2: 600 0 320 0  0 600 240 0  0 0 1 0\nT_world_cam: " + std::string(kToWorld) + '\n');
        QVERIFY2(scene && missOf(*scene) < 1e-12, qPrintable(reasonOf(scene)));
        QCOMPARE(scene->intrinsics->fx, 600.0);
    }
};

UNPROJECTOR_TEST(TestRoles)
#include "test_roles.moc"

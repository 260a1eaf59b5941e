#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Files that cv2.FileStorage of OpenCV 4.6 wrote and texts that NumPy 1.24 printed, all of one
// camera, with the results of cv2.projectPoints.

namespace opencv_camera {

inline constexpr const char *kYaml = R"text(%YAML:1.0
---
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 8.1234567890000005e+02, 0., 3.3125000000000000e+02, 0.,
       8.0512500000000000e+02, 2.3687500000000000e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0., 0., 0., 0., 0. ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 8.6283419301953745e-01, -1.8407590240229932e-01,
       -4.7077937243586065e-01, 2.7906773117310033e-02,
       9.4726433952814049e-01, -3.1923577974984990e-01,
       5.0471612553048328e-01, 2.6230961326854735e-01,
       8.2246902641765329e-01 ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ 2.0000000000000001e-01, -1.0000000000000001e-01,
       6.5000000000000000e+00 ]
)text";

inline constexpr const char *kXml = R"text(<?xml version="1.0"?>
<opencv_storage>
<image_width>640</image_width>
<image_height>480</image_height>
<camera_matrix type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    8.1234567890000005e+02 0. 3.3125000000000000e+02 0.
    8.0512500000000000e+02 2.3687500000000000e+02 0. 0. 1.</data></camera_matrix>
<distortion_coefficients type_id="opencv-matrix">
  <rows>1</rows>
  <cols>5</cols>
  <dt>d</dt>
  <data>
    0. 0. 0. 0. 0.</data></distortion_coefficients>
<R type_id="opencv-matrix">
  <rows>3</rows>
  <cols>3</cols>
  <dt>d</dt>
  <data>
    8.6283419301953745e-01 -1.8407590240229932e-01
    -4.7077937243586065e-01 2.7906773117310033e-02
    9.4726433952814049e-01 -3.1923577974984990e-01
    5.0471612553048328e-01 2.6230961326854735e-01 8.2246902641765329e-01</data></R>
<T type_id="opencv-matrix">
  <rows>3</rows>
  <cols>1</cols>
  <dt>d</dt>
  <data>
    2.0000000000000001e-01 -1.0000000000000001e-01
    6.5000000000000000e+00</data></T>
</opencv_storage>
)text";

inline constexpr const char *kJson = R"text({
    "image_width": 640,
    "image_height": 480,
    "camera_matrix": {
        "type_id": "opencv-matrix",
        "rows": 3,
        "cols": 3,
        "dt": "d",
        "data": [ 8.1234567890000005e+02, 0.0, 3.3125000000000000e+02,
            0.0, 8.0512500000000000e+02, 2.3687500000000000e+02, 0.0,
            0.0, 1.0 ]
    },
    "distortion_coefficients": {
        "type_id": "opencv-matrix",
        "rows": 1,
        "cols": 5,
        "dt": "d",
        "data": [ 0.0, 0.0, 0.0, 0.0, 0.0 ]
    },
    "R": {
        "type_id": "opencv-matrix",
        "rows": 3,
        "cols": 3,
        "dt": "d",
        "data": [ 8.6283419301953745e-01, -1.8407590240229932e-01,
            -4.7077937243586065e-01, 2.7906773117310033e-02,
            9.4726433952814049e-01, -3.1923577974984990e-01,
            5.0471612553048328e-01, 2.6230961326854735e-01,
            8.2246902641765329e-01 ]
    },
    "T": {
        "type_id": "opencv-matrix",
        "rows": 3,
        "cols": 1,
        "dt": "d",
        "data": [ 2.0000000000000001e-01, -1.0000000000000001e-01,
            6.5000000000000000e+00 ]
    }
}
)text";

/// The same camera with k1, k2, p1, p2, k3.
inline constexpr const char *kLensYaml = R"text(%YAML:1.0
---
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 8.1234567890000005e+02, 0., 3.3125000000000000e+02, 0.,
       8.0512500000000000e+02, 2.3687500000000000e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ -2.8000000000000003e-01, 1.1000000000000000e-01,
       1.1999999999999999e-03, -6.9999999999999999e-04,
       2.0000000000000000e-02 ]
R: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 8.6283419301953745e-01, -1.8407590240229932e-01,
       -4.7077937243586065e-01, 2.7906773117310033e-02,
       9.4726433952814049e-01, -3.1923577974984990e-01,
       5.0471612553048328e-01, 2.6230961326854735e-01,
       8.2246902641765329e-01 ]
T: !!opencv-matrix
   rows: 3
   cols: 1
   dt: d
   data: [ 2.0000000000000001e-01, -1.0000000000000001e-01,
       6.5000000000000000e+00 ]
)text";

inline constexpr const char *kNumPy = R"text(K = [[812.3456789   0.        331.25     ]
 [  0.        805.125     236.875    ]
 [  0.          0.          1.       ]]
R = [[ 0.8628341930195375  -0.18407590240229932 -0.47077937243586065]
 [ 0.02790677311731003  0.9472643395281405  -0.3192357797498499 ]
 [ 0.5047161255304833   0.26230961326854735  0.8224690264176533 ]]
t = [[ 0.2]
 [-0.1]
 [ 6.5]]
image size: 640 x 480
)text";

inline constexpr const char *kReprs = R"text(camera_matrix = np.array([[812.3456789,   0.       , 331.25     ],
       [  0.       , 805.125    , 236.875    ],
       [  0.       ,   0.       ,   1.       ]])
rvec = np.array([ 0.31 , -0.52 ,  0.113])
tvec = np.array([[ 0.2],
       [-0.1],
       [ 6.5]])
image_size = (640, 480)
)text";

inline constexpr const char *kCpp =
    R"text(cv::Mat K = (cv::Mat_<double>(3, 3) << 812.3456789, 0.0, 331.25, 0.0, 805.125, 236.875, 0.0, 0.0, 1.0);
Vec3d rvec(0.31, -0.52, 0.113);
cv::Vec3d tvec(0.2, -0.1, 6.5);
// size
int width = 640, height = 480;
)text";

inline constexpr const char *kMatrixP =
    R"text(P = [[ 8.6810684488856248e+02 -6.2643204510919688e+01 -1.0999272391267755e+02
   2.3155941357800002e+03]
 [ 1.4202307294110747e+02  8.2480079100558135e+02 -6.2202356538416296e+01
   1.4591750000000000e+03]
 [ 5.0471612553048328e-01  2.6230961326854735e-01  8.2246902641765329e-01
   6.5000000000000000e+00]]
width: 640
height: 480
)text";

inline constexpr const char *kCalibration = R"text(%YAML:1.0
---
calibration_time: "Fri 27 Nov 2026"
image_width: 640
image_height: 480
board_width: 9
flags: 0
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 812.3456789, 0.0, 331.25, 0.0, 805.125, 236.875, 0.0, 0.0, 1.0 ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ 0., 0., 0., 0., 0. ]
avg_reprojection_error: 2.3e-01
# a set of 6-tuples (rotation vector + translation vector) for each view
extrinsic_parameters: !!opencv-matrix
   rows: 2
   cols: 6
   dt: d
   data: [ 1., 2., 3., 4., 5., 6., 0.31, -0.52, 0.113, 0.2, -0.1, 6.5 ]
)text";

/// A world point, its pixel, and its pixel with the distortion of kLensYaml; centres of pixels at
/// whole numbers.
struct Projected {
    glm::dvec3 world;
    glm::dvec2 pixel, distorted;
};

inline constexpr Projected kProjected[]{
    {{0.1523937077237265, 0.6244434678543147, -0.627285783261167},
     {398.0484329703091, 326.89914941569594},
     {397.6901459679017, 326.4496615230223}},
    {{0.032482815592989045, 1.1788408630429643, 1.1888792668003143},
     {274.1329942408271, 302.7060418287568},
     {274.2946818679329, 302.5233001920736}},
    {{-1.1232440686084912, -0.8782713655854397, -1.3455983900975104},
     {335.84113789554493, 143.37479025714933},
     {335.81484914722216, 143.7666796470827}},
    {{-0.1775704690480906, -1.410371367364299, -0.12950032681586676},
     {381.542186435472, 46.97333550286933},
     {380.6579336897526, 50.242014872837274}},
    {{0.44743214284428223, -0.6645381520560741, 0.5287647059403939},
     {384.6730801320456, 134.79304587754154},
     {384.3375967727049, 135.43163788227974}},
    {{0.2725884522490525, -1.428054352868504, 0.17656226397264607},
     {409.204702530302, 48.22659856153868},
     {407.7502482670114, 51.720059236715144}},
    {{-0.7222426592776038, -0.25469640896979096, -0.6494247546860438},
     {320.89389353033334, 214.45751019768528},
     {320.8965857679177, 214.46539835783122}},
    {{0.5794137549389888, -0.17863884698778154, -1.0293967845751102},
     {498.90436894250865, 247.18951137681157},
     {496.86354482931233, 247.10676141109002}},
};

} // namespace opencv_camera

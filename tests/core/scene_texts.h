#pragma once

#include <QByteArray>

#include <cstring>

/// Scenes as files have them, and the least of them with one piece changed.
namespace scene_texts {

/// Every key, with numbers that no key has by default and that no other key has.
inline const char *const kFullScene = R"({
  "unprojector": 1,
  "window": {"width": 641, "height": 479, "devicePixelRatio": 1.25, "fixed": true},
  "viewport": {"x": 3, "y": 5.5, "width": 640, "height": 480},
  "depthRange": [0.9, 0.1],
  "projection": {"type": "frustum", "left": -1.1, "right": 1.2, "bottom": -0.75, "top": 0.8, "near": 0.1, "far": 1e5},
  "view": {"eye": [0.1, 0.2, 5.3], "center": [1, 2, 3], "up": [0, 1, 0.5]},
  "objects": [
    {"name": "face", "file": "models/face.obj",
     "transform": [{"translate": [0, 0, -3]}, {"rotate": [30, 0, 1, 0]}, {"scale": [1, 2, -1]}]},
    {"name": "Gr\u00fcn", "bundled": "Teapot", "transform": [], "hidden": true}
  ],
  "clipPlanes": [[0, 1, 0, 0], [1, 0, 0, -0.25]],
  "landmarks": {
    "name": "skull 7", "mesh": "face.obj", "unit": "mm", "axes": "RAS",
    "points": [
      {"name": "Nasion", "position": [0.1, 2.5, -3], "object": "face",
       "held": {"triangle": 4294967295, "barycentric": [0.2, 0.3, 0.5]}, "uncertainty": [0.01, 0.02, 0.03],
       "note": "w\u00e9ll", "color": [255, 128, 1], "hidden": true},
      {"name": "", "position": [1e-300, 2, 3], "held": {"vertex": 7}},
      {"name": "e", "position": [1, 2, 3], "held": {"edge": [5, 6], "share": 0.75}},
      {"name": "gone", "position": null}
    ],
    "curves": [
      {"name": "brow", "points": ["Nasion", "e"], "kind": "planeSection", "count": 12},
      {"name": "as read", "points": [], "kind": "geodesic", "count": 2, "semilandmarks": [[1, 2, 3], [4, 5, 0.1]]}
    ]
  },
  "ui": {
    "viewportRule": {"kind": "keepAspect", "aspect": 1.5, "fixed": {"x": 1, "y": 2, "width": 3, "height": 4}},
    "projectionFollowsViewport": true,
    "clipDistancesFitObjects": false,
    "home": {"eye": [9, 8, 7], "center": [0, 0, 0], "up": [0, 1, 0]},
    "clipPlanesOff": [{"place": 1, "plane": [0, 0, 1, 2]}]
  }
})";

inline const char *const kLeastScene = R"({
  "unprojector": 1,
  "window": {"width": 800, "height": 600},
  "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}
})";

/// The least scene with one piece of it replaced.
inline QByteArray changed(const char *from, const char *to)
{
    QByteArray text(kLeastScene);
    const qsizetype at = text.indexOf(from);
    if (at < 0)
        qFatal("the scene has no %s", from);
    return text.replace(at, qsizetype(strlen(from)), to);
}

inline QByteArray withProjection(const char *projection)
{
    return changed(R"({"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100})",
                   projection);
}

inline QByteArray withView(const char *view)
{
    return changed(R"({"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})", view);
}

/// A matrix that is no known projection: its near plane is tilted.
inline const char *const kMatrix =
    R"({"type": "matrix", "matrix": [1.5,0,0.1,0, 0,2,0.3,0, 0,0,-1.25,-1, 0,0,-2.25,0]})";

inline QByteArray withMember(const QByteArray &member)
{
    return changed("\"unprojector\": 1,", ("\"unprojector\": 1, " + member + ",").constData());
}

} // namespace scene_texts

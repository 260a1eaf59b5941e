#include "core/pipeline/matrix_entry_name.h"

namespace unprojector::pipeline {
using namespace geometry;

namespace {

/// The names row by row, as printed in books.
using Names = std::string_view[4][4];

constexpr Names kAxes = {
    {"X.x", "Y.x", "Z.x", "T.x"}, {"X.y", "Y.y", "Z.y", "T.y"}, {"X.z", "Y.z", "Z.z", "T.z"}, {"0", "0", "0", "1"}};

constexpr Names kEyeFromWorld = {{"s.x", "s.y", "s.z", "−s·eye"},
                                 {"u.x", "u.y", "u.z", "−u·eye"},
                                 {"−f.x", "−f.y", "−f.z", "f·eye"},
                                 {"0", "0", "0", "1"}};
constexpr Names kWorldFromEye = {{"s.x", "u.x", "−f.x", "eye.x"},
                                 {"s.y", "u.y", "−f.y", "eye.y"},
                                 {"s.z", "u.z", "−f.z", "eye.z"},
                                 {"0", "0", "0", "1"}};

constexpr Names kFrustum = {{"2n/(r−l)", "0", "(r+l)/(r−l)", "0"},
                            {"0", "2n/(t−b)", "(t+b)/(t−b)", "0"},
                            {"0", "0", "−(f+n)/(f−n)", "−2fn/(f−n)"},
                            {"0", "0", "−1", "0"}};
constexpr Names kFrustumInverse = {{"(r−l)/(2n)", "0", "0", "(r+l)/(2n)"},
                                   {"0", "(t−b)/(2n)", "0", "(t+b)/(2n)"},
                                   {"0", "0", "0", "−1"},
                                   {"0", "0", "−(f−n)/(2fn)", "(f+n)/(2fn)"}};

constexpr Names kSkewed = {{"2n/(r−l)", "2n·skew/(r−l)", "(r+l)/(r−l)", "0"},
                           {"0", "2n/(t−b)", "(t+b)/(t−b)", "0"},
                           {"0", "0", "−(f+n)/(f−n)", "−2fn/(f−n)"},
                           {"0", "0", "−1", "0"}};
constexpr Names kSkewedInverse = {{"(r−l)/(2n)", "−skew·(t−b)/(2n)", "0", "(r+l)/(2n) − skew·(t+b)/(2n)"},
                                  {"0", "(t−b)/(2n)", "0", "(t+b)/(2n)"},
                                  {"0", "0", "0", "−1"},
                                  {"0", "0", "−(f−n)/(2fn)", "(f+n)/(2fn)"}};

constexpr Names kPerspective = {{"cot(fovy/2)/aspect", "0", "0", "0"},
                                {"0", "cot(fovy/2)", "0", "0"},
                                {"0", "0", "−(f+n)/(f−n)", "−2fn/(f−n)"},
                                {"0", "0", "−1", "0"}};
constexpr Names kPerspectiveInverse = {{"aspect·tan(fovy/2)", "0", "0", "0"},
                                       {"0", "tan(fovy/2)", "0", "0"},
                                       {"0", "0", "0", "−1"},
                                       {"0", "0", "−(f−n)/(2fn)", "(f+n)/(2fn)"}};

constexpr Names kOrtho = {{"2/(r−l)", "0", "0", "−(r+l)/(r−l)"},
                          {"0", "2/(t−b)", "0", "−(t+b)/(t−b)"},
                          {"0", "0", "−2/(f−n)", "−(f+n)/(f−n)"},
                          {"0", "0", "0", "1"}};
constexpr Names kOrthoInverse = {{"(r−l)/2", "0", "0", "(r+l)/2"},
                                 {"0", "(t−b)/2", "0", "(t+b)/2"},
                                 {"0", "0", "−(f−n)/2", "−(f+n)/2"},
                                 {"0", "0", "0", "1"}};

constexpr Names kOblique = {{"2/(r−l)", "0", "2 cot θ/(r−l)", "−(r+l)/(r−l)"},
                            {"0", "2/(t−b)", "2 cot φ/(t−b)", "−(t+b)/(t−b)"},
                            {"0", "0", "−2/(f−n)", "−(f+n)/(f−n)"},
                            {"0", "0", "0", "1"}};
constexpr Names kObliqueInverse = {{"(r−l)/2", "0", "cot θ·(f−n)/2", "(r+l)/2 + cot θ·(f+n)/2"},
                                   {"0", "(t−b)/2", "cot φ·(f−n)/2", "(t+b)/2 + cot φ·(f+n)/2"},
                                   {"0", "0", "−(f−n)/2", "−(f+n)/2"},
                                   {"0", "0", "0", "1"}};

constexpr Names kWindowFromNdc = {{"w/2", "0", "0", "vx + w/2"},
                                  {"0", "h/2", "0", "vy + h/2"},
                                  {"0", "0", "(df−dn)/2", "(dn+df)/2"},
                                  {"0", "0", "0", "1"}};
constexpr Names kNdcFromWindow = {{"2/w", "0", "0", "−(2vx+w)/w"},
                                  {"0", "2/h", "0", "−(2vy+h)/h"},
                                  {"0", "0", "2/(df−dn)", "−(dn+df)/(df−dn)"},
                                  {"0", "0", "0", "1"}};

constexpr Names kNone = {};

const Names &projectionNames(ProjectionKind kind, bool isSkewed, bool forward)
{
    if (isSkewed)
        return forward ? kSkewed : kSkewedInverse;
    switch (kind) {
    case ProjectionKind::Frustum: return forward ? kFrustum : kFrustumInverse;
    case ProjectionKind::Perspective: return forward ? kPerspective : kPerspectiveInverse;
    case ProjectionKind::Ortho: return forward ? kOrtho : kOrthoInverse;
    case ProjectionKind::Oblique: return forward ? kOblique : kObliqueInverse;
    }
    return kNone;
}

const Names &namesOf(PipelineStage stage, bool forward, ProjectionKind kind, bool isSkewed)
{
    switch (stage) {
    case PipelineStage::ModelMatrix:
    case PipelineStage::ModelviewMatrix: return kAxes;
    case PipelineStage::ViewMatrix: return forward ? kEyeFromWorld : kWorldFromEye;
    case PipelineStage::ProjectionMatrix: return projectionNames(kind, isSkewed, forward);
    case PipelineStage::ViewportMatrix: return forward ? kWindowFromNdc : kNdcFromWindow;
    case PipelineStage::WholeMatrix: return kNone;
    }
    return kNone;
}

} // namespace

std::string_view matrixEntryName(PipelineStage stage, PipelineDirection direction, ProjectionKind kind, int row,
                                 int column, bool isSkewed)
{
    return namesOf(stage, direction == PipelineDirection::Forward, kind, isSkewed)[row][column];
}

} // namespace unprojector::pipeline

#include "gui/shell/features.h"

#include "gui/click/click_feature.h"
#include "gui/doctor/doctor_feature.h"
#include "gui/landmarks/landmarks_feature.h"
#include "gui/lessons/lessons_feature.h"
#include "gui/map/map_feature.h"
#include "gui/objects/objects_feature.h"
#include "gui/outside/outside_feature.h"
#include "gui/parameters/parameters_feature.h"
#include "gui/pipeline/pipeline_feature.h"
#include "gui/shading/shading_feature.h"

namespace unprojector::gui {

std::vector<Feature *> makeFeatures(Window &window)
{
    return {
        makePipelineFeature(window), makeClickFeature(window),     makeParametersFeature(window),
        makeObjectsFeature(window),  makeLandmarksFeature(window), makeDoctorFeature(window),
        makeOutsideFeature(window),  makeMapFeature(window),       makeShadingFeature(window),
        makeLessonsFeature(window), // last: it follows the links that no other feature follows
    };
}

} // namespace unprojector::gui

#pragma once

/// The whole library: setups, unproject and project, clouds of depth images, scenes and picks,
/// landmarks, and the diagnosis of other programs' coordinates.
#include "unprojector/cameras.h"
#include "unprojector/cloud.h"
#include "unprojector/diagnose.h"
#include "unprojector/export.h"
#include "unprojector/landmarks.h"
#include "unprojector/project.h"
#include "unprojector/result.h"
#include "unprojector/scene.h"
#include "unprojector/setup.h"
#include "unprojector/unproject.h"
#include "unprojector/version.h"

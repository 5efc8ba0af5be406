// There are no meshes and lights to manage: what code takes from it are the view and its family. Source: engine file
// SceneManagement.h.
#pragma once

#include "RHI.h"
#include "RenderResource.h"
#include "SceneInterface.h"
#include "SceneView.h"

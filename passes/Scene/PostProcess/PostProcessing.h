// The renderer's post-processing header as plugins include it: alone it gives the renderer's view, global shaders and
// the pass helpers. Source: engine file PostProcess/PostProcessing.h.
#pragma once

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessInputs.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

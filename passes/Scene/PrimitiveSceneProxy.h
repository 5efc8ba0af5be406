// A primitive's mirror on the render thread: there are no primitives here. Source: engine file PrimitiveSceneProxy.h.
#pragma once

#include "Components/PrimitiveComponent.h"
#include "RHI.h"
#include "RenderResource.h"
#include "SceneInterface.h"
#include "SceneView.h"

class DRYDOCK_API FPrimitiveSceneProxy
{
public:
	explicit FPrimitiveSceneProxy(const UPrimitiveComponent*) {}
	virtual ~FPrimitiveSceneProxy() = default;
};

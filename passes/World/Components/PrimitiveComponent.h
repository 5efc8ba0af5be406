// A component that would be drawn: there are no meshes here, so it has no proxy. Source: engine file
// Components/PrimitiveComponent.h.
#pragma once

#include "Components/SceneComponent.h"

class FPrimitiveSceneProxy;

class DRYDOCK_API UPrimitiveComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(UPrimitiveComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	bool bRenderCustomDepth = false;
	int32 CustomDepthStencilValue = 0; // 0..255

	virtual FPrimitiveSceneProxy* CreateSceneProxy() { return nullptr; }
	void SetRenderCustomDepth(bool bValue) { bRenderCustomDepth = bValue; }
	void SetCustomDepthStencilValue(int32 Value) { CustomDepthStencilValue = Value; }
};

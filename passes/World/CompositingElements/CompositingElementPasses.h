// Passes of the engine's compositing plugin, Composure, as plugins derive theirs: there is no compositing element here
// that would run them. Source: engine file CompositingElements/CompositingElementPasses.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/TextureRenderTarget2D.h"

class ACameraActor;
class UComposurePostProcessingPassProxy;

class DRYDOCK_API UCompositingElementPass : public UObject
{
public:
	DRYDOCK_CLASS(UCompositingElementPass, UObject)
	using UObject::UObject;

	bool bEnabled = true;
	FName PassName;

protected:
	/** Null: targets come from the element that runs the pass. */
	UTextureRenderTarget2D* RequestRenderTarget(FIntPoint, EPixelFormat) { return nullptr; }
};

class DRYDOCK_API UCompositingElementTransform : public UCompositingElementPass
{
public:
	DRYDOCK_CLASS(UCompositingElementTransform, UCompositingElementPass)
	using UCompositingElementPass::UCompositingElementPass;

	virtual UTexture* ApplyTransform_Implementation(UTexture* Input, UComposurePostProcessingPassProxy*, ACameraActor*)
	{
		return Input;
	}
};

class DRYDOCK_API UCompositingElementInput : public UCompositingElementPass
{
public:
	DRYDOCK_CLASS(UCompositingElementInput, UCompositingElementPass)
	using UCompositingElementPass::UCompositingElementPass;

	virtual UTexture* GenerateInput_Implementation() { return nullptr; }
};

class DRYDOCK_API UCompositingElementOutput : public UCompositingElementPass
{
public:
	DRYDOCK_CLASS(UCompositingElementOutput, UCompositingElementPass)
	using UCompositingElementPass::UCompositingElementPass;

	virtual void RelayOutput_Implementation(UTexture*, UComposurePostProcessingPassProxy*) {}
};

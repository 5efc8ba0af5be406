// Classes of the engine that code may name and point to, and whose work is absent here: calling it is a compile error
// that names the way round, or a warning. Source: engine files Components/SceneCaptureComponent2D.h, ImageUtils.h,
// Dom/JsonObject.h.
#pragma once

#include "Components/MeshComponent.h"
#include "Engine/TextureRenderTarget2D.h"
#include "SceneView.h"

enum class ESceneCapturePrimitiveRenderMode : uint8
{
	PRM_LegacySceneCapture,
	PRM_RenderScenePrimitives,
	PRM_UseShowOnlyList
};
enum ESceneCaptureCompositeMode : int
{
	SCCM_Overwrite,
	SCCM_Additive,
	SCCM_Composite
};
namespace ECameraProjectionMode
{
enum Type : int
{
	Perspective,
	Orthographic
};
} // namespace ECameraProjectionMode

class DRYDOCK_API USceneCaptureComponent2D : public USceneComponent
{
public:
	DRYDOCK_CLASS(USceneCaptureComponent2D, USceneComponent)
	using USceneComponent::USceneComponent;

	TObjectPtr<UTextureRenderTarget2D> TextureTarget;
	float FOVAngle = 90.0f; // degrees
	ESceneCaptureSource CaptureSource = SCS_SceneColorHDR;
	bool bCaptureEveryFrame = true;
	bool bCaptureOnMovement = true;
	bool bAlwaysPersistRenderingState = false;
	ESceneCapturePrimitiveRenderMode PrimitiveRenderMode = ESceneCapturePrimitiveRenderMode::PRM_LegacySceneCapture;
	ESceneCaptureCompositeMode CompositeMode = SCCM_Overwrite;
	ECameraProjectionMode::Type ProjectionType = ECameraProjectionMode::Perspective;
	float OrthoWidth = 512.0f; // cm
	TArray<AActor*> ShowOnlyActors;
	TArray<AActor*> HiddenActors;
	FPostProcessSettings PostProcessSettings;
	float PostProcessBlendWeight = 1.0f;
	FEngineShowFlags ShowFlags;

	void ShowOnlyActorComponents(AActor* Actor, bool = false) { ShowOnlyActors.Add(Actor); }
	void HideActorComponents(AActor* Actor, bool = false) { HiddenActors.Add(Actor); }
	/** Its texture keeps what it has, and a warning says once why. */
	void CaptureScene() { SayNothingIsCaptured(); }
	void CaptureSceneDeferred() { SayNothingIsCaptured(); }
	void OnRegister() override { SayNothingIsCaptured(); }

private:
	static void SayNothingIsCaptured()
	{
		Drydock::SayNeutral(TEXT("USceneCaptureComponent2D"),
			TEXT("no scene is rendered; give the captured picture as a texture of the scene (docs/scene-textures.md)"));
	}
};

class FImageUtils
{
public:
	DRYDOCK_ABSENT(ImportFileAsTexture2D, "give the picture to a UTexture2D property by the config's \"objects\"")
	static UTexture2D* ImportFileAsTexture2D(const FString& Filename);
	DRYDOCK_ABSENT(ExportRenderTarget2DAsPNG, "extract the texture, and let the run write it (docs/outputs.md)")
	static bool ExportRenderTarget2DAsPNG(UTextureRenderTarget2D* Texture, class FArchive& Archive);
	DRYDOCK_ABSENT(CompressImageArray, "extract the texture, and let the run write it (docs/outputs.md)")
	static void CompressImageArray(int32 Width, int32 Height, const TArray<FColor>& Source, TArray<uint8>& OutData);
};

class FJsonObject
{
public:
	DRYDOCK_ABSENT(TryGetNumberField, "give values by the config's \"objects\", or read the text by FFileHelper")
	bool TryGetNumberField(const FString& FieldName, double& OutNumber) const;
	DRYDOCK_ABSENT(TryGetStringField, "give values by the config's \"objects\", or read the text by FFileHelper")
	bool TryGetStringField(const FString& FieldName, FString& OutString) const;
	DRYDOCK_ABSENT(GetNumberField, "give values by the config's \"objects\", or read the text by FFileHelper")
	double GetNumberField(const FString& FieldName) const;
	DRYDOCK_ABSENT(GetStringField, "give values by the config's \"objects\", or read the text by FFileHelper")
	FString GetStringField(const FString& FieldName) const;
};

// Classes of the engine that code may name and point to, and whose work is absent here: calling it is a compile error
// that names the way round. Source: engine files Components/SceneCaptureComponent2D.h,
// Components/StaticMeshComponent.h, Engine/StaticMesh.h, ImageUtils.h, Dom/JsonObject.h.
#pragma once

#include "Components/PrimitiveComponent.h"
#include "Engine/TextureRenderTarget2D.h"
#include "SceneView.h"

#define DRYDOCK_NO_MESH(Name) DRYDOCK_ABSENT(Name, "no mesh is drawn; frames come rendered")
#define DRYDOCK_NO_CAPTURE(Name) \
	DRYDOCK_ABSENT( \
		Name, "no scene is rendered; give the captured picture as a texture of the scene (docs/scene-textures.md)")

class DRYDOCK_API UStaticMesh : public UObject
{
public:
	DRYDOCK_CLASS(UStaticMesh, UObject)
	using UObject::UObject;

	DRYDOCK_NO_MESH(GetRenderData) class FStaticMeshRenderData* GetRenderData() const;
	DRYDOCK_NO_MESH(GetNumVertices) int32 GetNumVertices(int32 LODIndex) const;
	DRYDOCK_NO_MESH(GetNumTriangles) int32 GetNumTriangles(int32 LODIndex) const;
};

class DRYDOCK_API UStaticMeshComponent : public UPrimitiveComponent
{
public:
	DRYDOCK_CLASS(UStaticMeshComponent, UPrimitiveComponent)
	using UPrimitiveComponent::UPrimitiveComponent;

	DRYDOCK_NO_MESH(SetStaticMesh) bool SetStaticMesh(UStaticMesh* NewMesh);
	UStaticMesh* GetStaticMesh() const { return nullptr; }
};

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
	DRYDOCK_NO_CAPTURE(CaptureScene) void CaptureScene();
	DRYDOCK_NO_CAPTURE(CaptureSceneDeferred) void CaptureSceneDeferred();
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

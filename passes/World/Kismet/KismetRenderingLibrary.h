// Declares the functions that blueprints call on render targets, for calls from code. Source: engine file
// Kismet/KismetRenderingLibrary.h.
#pragma once

#include "Engine/TextureRenderTarget2D.h"
#include "Kismet/BlueprintFunctionLibrary.h"

class UMaterialInterface;

class DRYDOCK_API UKismetRenderingLibrary : public UBlueprintFunctionLibrary
{
public:
	/** A new one, which the caller owns. Sizes in texels. */
	static UTextureRenderTarget2D* CreateRenderTarget2D(UObject* WorldContextObject, int32 Width = 256,
		int32 Height = 256, ETextureRenderTargetFormat Format = RTF_RGBA16f,
		FLinearColor ClearColor = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f), bool bAutoGenerateMipMaps = false,
		bool bSupportUAVs = false);
	static void ReleaseRenderTarget2D(UTextureRenderTarget2D* TextureRenderTarget);
	/** Every texel to that colour; nothing for null or a target without pixels. */
	static void ClearRenderTarget2D(UObject* WorldContextObject, UTextureRenderTarget2D* TextureRenderTarget,
		FLinearColor ClearColor = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f));
	/** Draws nothing, and reports this: no material is compiled here. */
	static void DrawMaterialToRenderTarget(
		UObject* WorldContextObject, UTextureRenderTarget2D* TextureRenderTarget, UMaterialInterface* Material);
};

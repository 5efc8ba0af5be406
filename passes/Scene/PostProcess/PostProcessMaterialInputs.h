// Declares the inputs of a post-processing callback. Source: engine file PostProcess/PostProcessMaterialInputs.h.
#pragma once

#include "CoreMinimal.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

/** Slots of FPostProcessMaterialInputs. */
enum class EPostProcessMaterialInput : uint32
{
	/** The picture so far; always there. */
	SceneColor = 0,
	/** Translucency that is composed after depth of field: premultiplied, alpha = transmittance. Black where the scene
	 * has none. */
	SeparateTranslucency = 1,
	/** Bloom, where the tonemapper is replaced. */
	CombinedBloom = 2,
	/** The tonemapper's input; for callbacks after it. */
	PreTonemapHDRColor = 2,
	/** The tonemapper's output; for callbacks after it. */
	PostTonemapHDRColor = 3,
	Velocity = 4
};

constexpr uint32 kPostProcessMaterialInputCountMax = 5;

/** Inputs of one callback, and where it has to draw if anybody cares. */
struct FPostProcessMaterialInputs
{
	/** Valid for the last callback of the last pass: it must draw into it, over its whole ViewRect, and return it. */
	FScreenPassRenderTarget OverrideOutput;

	/** The textures, by EPostProcessMaterialInput; as code up to engine 5.3 reads them. */
	TStaticArray<FScreenPassTexture, kPostProcessMaterialInputCountMax> Textures;

	/** Format of a new output; PF_Unknown: the input's. */
	EPixelFormat OutputFormat = PF_Unknown;

	/** The picture may be drawn to in place. */
	bool bAllowSceneColorInputAsOutput = true;
	bool bManualStencilTest = false;
	FRDGTextureRef CustomDepthTexture = nullptr;

	FSceneTextureShaderParameters SceneTextures;

	Drydock::FScreenPassInput GetInput(EPostProcessMaterialInput Input) const
	{
		const uint32 Slot = static_cast<uint32>(Input);
		const bool bSame = Views[Slot] != nullptr && Views[Slot]->Desc.Texture == Textures[Slot].Texture;
		return Drydock::FScreenPassInput(Textures[Slot], bSame ? Views[Slot] : nullptr);
	}
	void SetInput(FRDGBuilder& GraphBuilder, EPostProcessMaterialInput Input, const FScreenPassTexture& Texture)
	{
		Textures[static_cast<uint32>(Input)] = Texture;
		Views[static_cast<uint32>(Input)] = Texture.Texture ? GraphBuilder.CreateSRV(Texture.Texture) : nullptr;
	}
	void SetInput(EPostProcessMaterialInput Input, const FScreenPassTextureSlice& Slice)
	{
		Textures[static_cast<uint32>(Input)] =
			FScreenPassTexture(Slice.TextureSRV ? Slice.TextureSRV->Desc.Texture : nullptr, Slice.ViewRect);
		Views[static_cast<uint32>(Input)] = Slice.TextureSRV;
	}
	void SetInput(EPostProcessMaterialInput Input, const FScreenPassTexture& Texture)
	{
		Textures[static_cast<uint32>(Input)] = Texture;
	}

	/** The picture as it came, without a copy; where OverrideOutput is valid, that one, with nothing drawn to it. */
	FScreenPassTexture ReturnUntouchedSceneColorForPostProcessing(FRDGBuilder& GraphBuilder) const
	{
		return OverrideOutput.IsValid()
				   ? FScreenPassTexture(OverrideOutput)
				   : Drydock::CopyFromSlice(GraphBuilder, GetInput(EPostProcessMaterialInput::SceneColor));
	}

	void Validate() const
	{
		check(GetInput(EPostProcessMaterialInput::SceneColor).IsValid());
		check(!OverrideOutput.IsValid() || OutputFormat == PF_Unknown);
	}

private:
	/** Views of the textures, as code from engine 5.4 on reads them; null where a texture was set without a graph
	 * builder. */
	TStaticArray<FRDGTextureSRVRef, kPostProcessMaterialInputCountMax> Views = {};
};

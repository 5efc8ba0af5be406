// What the calls of FuzzGraphChecks.h are made with: resources and views, made or taken out as bytes say, and picked
// again later, when their graph may be gone.
#pragma once

#include "fuzz/FuzzGraphBytes.h"

#include "RHIGPUReadback.h"
#include "ScreenPass.h"

#include <cstring>
#include <optional>
#include <vector>

BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FFuzzUniforms, )
	SHADER_PARAMETER(float, Scale)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneColor)
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D, SceneDepth)
END_GLOBAL_SHADER_PARAMETER_STRUCT()
IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FFuzzUniforms, "FuzzUniforms");

BEGIN_SHADER_PARAMETER_STRUCT(FFuzzParameters, )
	SHADER_PARAMETER_RDG_TEXTURE_ARRAY(Texture2D, Textures, [2])
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D, SRV)
	SHADER_PARAMETER_RDG_TEXTURE_UAV_ARRAY(RWTexture2D<float4>, UAVs, [2])
	SHADER_PARAMETER_RDG_BUFFER_SRV(Buffer<float4>, BufferSRV)
	SHADER_PARAMETER_RDG_BUFFER_UAV(RWBuffer<float4>, BufferUAV)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FFuzzUniforms, Uniforms)
	RDG_TEXTURE_ACCESS_ARRAY(Accesses)
	RDG_BUFFER_ACCESS_DYNAMIC(Buffer)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FFuzzRasterParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FFuzzParameters, Common)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

namespace Drydock
{

/** Textures, buffers, views and what was taken out; the newest are picked most easily. */
class FGraphResources : protected FCallBytes
{
protected:
	using FCallBytes::FCallBytes;

	template<typename T>
	static T* MakeGarbage()
	{
		alignas(16) static uint8 Garbage[512];
		std::memset(Garbage, 0x5a, sizeof(Garbage));
		return reinterpret_cast<T*>(Garbage);
	}

	/** One of the list, which may be of a graph that is gone; or null, or garbage. */
	template<typename T>
	T* Pick(const std::vector<T*>& List)
	{
		const uint8 Choice = Byte();
		if (Choice == 255)
		{
			return MakeGarbage<T>();
		}
		return Choice >= 250 || List.empty() ? nullptr : List[List.size() - 1 - Choice % List.size()];
	}

	void Fill(FFuzzParameters& Parameters)
	{
		const uint8 Which = Byte();
		Parameters.Textures[0] = (Which & 1) != 0 ? Pick(Textures) : nullptr;
		Parameters.Textures[1] = (Which & 1) != 0 ? Pick(Textures) : nullptr;
		Parameters.SRV = (Which & 2) != 0 ? Pick(SRVs) : nullptr;
		Parameters.UAVs[0] = (Which & 4) != 0 ? Pick(UAVs) : nullptr;
		Parameters.UAVs[1] = (Which & 8) != 0 ? Pick(UAVs) : nullptr;
		Parameters.BufferSRV = (Which & 16) != 0 ? Pick(BufferSRVs) : nullptr;
		Parameters.BufferUAV = (Which & 32) != 0 ? Pick(BufferUAVs) : nullptr;
		Parameters.Uniforms = (Which & 64) != 0 ? Pick(Uniforms) : nullptr;
		if ((Which & 128) != 0)
		{
			Parameters.Accesses.Add(FRDGTextureAccess(Pick(Textures), MakeAccess()));
			Parameters.Buffer = FRDGBufferAccess(Pick(Buffers), MakeAccess());
		}
	}

	TRefCountPtr<IPooledRenderTarget> MakePooled()
	{
		FTextureRHIRef Texture =
			new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(4, 4), PF_R32_FLOAT, FClearValueBinding::Black,
								TexCreate_ShaderResource | TexCreate_RenderTargetable | TexCreate_UAV),
				TEXT("Pooled"));
		return CreateRenderTarget(Texture, TEXT("Pooled"));
	}

	void MakeView(uint8 Kind)
	{
		if ((Kind & 3) == 0)
		{
			FRDGTextureSRVDesc Desc(Pick(Textures));
			Desc.MipLevel = uint8(Number());
			Desc.NumMipLevels = uint8(Number());
			Desc.FirstArraySlice = uint16(Number());
			Desc.NumArraySlices = uint16(Number());
			Desc.Format = (Kind & 4) != 0 ? EPixelFormat(Byte()) : PF_Unknown;
			SRVs.push_back((Kind & 8) != 0 ? Builder->CreateSRV(Desc.Texture) : Builder->CreateSRV(Desc));
		}
		else if ((Kind & 3) == 1)
		{
			FRDGTextureUAVDesc Desc(Pick(Textures));
			Desc.MipLevel = uint8(Number());
			Desc.FirstArraySlice = uint16(Number());
			Desc.NumArraySlices = uint16(Number());
			Desc.Format = (Kind & 4) != 0 ? EPixelFormat(Byte()) : PF_Unknown;
			UAVs.push_back((Kind & 8) != 0 ? Builder->CreateUAV(Desc.Texture, ERDGUnorderedAccessViewFlags::SkipBarrier)
										   : Builder->CreateUAV(Desc));
		}
		else if ((Kind & 3) == 2)
		{
			FRDGBufferSRVDesc Desc(Pick(Buffers));
			Desc.Format = (Kind & 4) != 0 ? EPixelFormat(Byte()) : PF_R32_UINT;
			Desc.StartOffsetBytes = uint32(Number());
			Desc.NumElements = uint32(Number());
			BufferSRVs.push_back((Kind & 8) != 0 ? Builder->CreateSRV(Desc.Buffer) : Builder->CreateSRV(Desc));
		}
		else
		{
			const EPixelFormat Format = (Kind & 4) != 0 ? EPixelFormat(Byte()) : PF_Unknown;
			BufferUAVs.push_back(Builder->CreateUAV(Pick(Buffers), Format));
		}
	}

	void MakeBuffer()
	{
		const uint8 Kind = Byte();
		const uint32 NumElements = (Kind & 64) != 0 ? uint32(Number()) & 0xffff : Kind & 15u;
		const uint32 Bytes = 1u << (Kind >> 4 & 3);
		FRDGBufferDesc Desc = (Kind & 128) != 0 ? FRDGBufferDesc::CreateBufferDesc(Bytes, NumElements)
												: FRDGBufferDesc::CreateStructuredDesc(Bytes * 4, NumElements);
		if ((Kind & 32) != 0)
		{
			Buffers.push_back(Builder->CreateBuffer(Desc, TEXT("Later"), [NumElements] { return NumElements * 2; }));
		}
		else
		{
			Buffers.push_back(Builder->CreateBuffer(Desc, NumElements == 7 ? nullptr : TEXT("Buffer")));
		}
	}

	void TakeOut(uint8 Kind)
	{
		switch (Kind & 7)
		{
		case 0:
			Builder->QueueTextureExtraction(Pick(Textures), (Kind & 8) != 0 ? nullptr : &ExtractedTexture);
			break;
		case 1:
			Builder->QueueTextureExtraction(Pick(Textures), &ExtractedTexture, MakeAccess());
			break;
		case 2:
			Builder->QueueBufferExtraction(Pick(Buffers), (Kind & 8) != 0 ? nullptr : &ExtractedBuffer);
			break;
		case 3:
			ExtractedTexture = Builder->ConvertToExternalTexture(Pick(Textures));
			break;
		case 4:
			ExtractedBuffer = Builder->ConvertToExternalBuffer(Pick(Buffers));
			break;
		case 5:
			Builder->ConvertToExternalUniformBuffer(Pick(Uniforms));
			break;
		case 6:
			Builder->GetPooledTexture(Pick(Textures));
			break;
		default:
			AddEnqueueCopyPass(*Builder, (Kind & 8) != 0 ? nullptr : &Readback, Pick(Textures),
				(Kind & 16) != 0 ? FResolveRect{Number(), Number(), Number(), Number()} : FResolveRect{});
			break;
		}
	}

	void Register(uint8 Kind)
	{
		if ((Kind & 1) != 0)
		{
			const TRefCountPtr<FRDGPooledBuffer> Given = (Kind & 2) != 0 ? nullptr : ExtractedBuffer;
			Buffers.push_back(Builder->RegisterExternalBuffer(Given));
			return;
		}
		const TRefCountPtr<IPooledRenderTarget> Given = (Kind & 2) != 0   ? nullptr
														: (Kind & 4) != 0 ? ExtractedTexture
																		  : MakePooled();
		Textures.push_back(Builder->RegisterExternalTexture(
			Given, (Kind & 8) != 0 ? ERDGTextureFlags::SkipTracking : ERDGTextureFlags::None));
	}

	std::vector<FRDGTexture*> Textures;
	size_t AliveFrom = 0; // those before are of graphs that are gone
	std::vector<FRDGBuffer*> Buffers;
	std::vector<FRDGTextureSRV*> SRVs;
	std::vector<FRDGTextureUAV*> UAVs;
	std::vector<FRDGBufferSRV*> BufferSRVs;
	std::vector<FRDGBufferUAV*> BufferUAVs;
	std::vector<TRDGUniformBuffer<FFuzzUniforms>*> Uniforms;
	std::vector<FRDGPass*> Passes;
	TRefCountPtr<IPooledRenderTarget> ExtractedTexture;
	TRefCountPtr<FRDGPooledBuffer> ExtractedBuffer;
	FRHIGPUTextureReadback Readback{TEXT("Readback")};
	std::optional<FRDGBuilder> Builder;
};

} // namespace Drydock

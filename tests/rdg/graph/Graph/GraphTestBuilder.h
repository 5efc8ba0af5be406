// Graphs for tests in three lines: passes and textures by name, lambdas that log the order they ran in and write
// pixels.
//
//     FGraphTest Graph;
//     Graph.Pass("A").Writes("X");
//     Graph.Pass("B").Reads("X").Writes("Y");
//     Graph.Extract("Y");
//     EXPECT_EQ("A B", Graph.Run());
//
// Textures come into being where they are first named: 4x4, one 32-bit float, fit for every use. A pass writes, to
// every texel of what it writes, its value (Value(), default 1) plus the first texel of everything it reads.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "HAL/ConsoleVariableTools.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphCompiled.h"
#include "RenderGraphErrors.h"

using Drydock::FScopedConsoleVariable;

BEGIN_SHADER_PARAMETER_STRUCT(FGraphTestParameters, )
	SHADER_PARAMETER_RDG_TEXTURE_ARRAY(Texture2D, Textures, [8])
	SHADER_PARAMETER_RDG_TEXTURE_SRV_ARRAY(Texture2D, SRVs, [8])
	SHADER_PARAMETER_RDG_TEXTURE_UAV_ARRAY(RWTexture2D<float>, UAVs, [8])
	RDG_TEXTURE_ACCESS_ARRAY(Accesses)
	RDG_BUFFER_ACCESS_ARRAY(BufferAccesses)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FGraphTestRasterParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FGraphTestParameters, Common)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FGraphTest;

/** A pass being declared; it is added at the end of the statement. */
class FGraphTestPass
{
public:
	FGraphTestPass(FGraphTest& InGraph, const std::string& InName);
	~FGraphTestPass() noexcept(false);
	FGraphTestPass(const FGraphTestPass&) = delete;

	FGraphTestPass& Reads(const std::string& Texture);
	FGraphTestPass& ReadsMip(const std::string& Texture, int32 Mip);
	FGraphTestPass& Writes(const std::string& Texture, int32 Mip = 0);
	FGraphTestPass& WritesBySkipBarrierView(const std::string& Texture);
	FGraphTestPass& Accesses(const std::string& Texture, ERHIAccess Access);
	FGraphTestPass& AccessesBuffer(FRDGBufferRef Buffer, ERHIAccess Access);
	/** Makes the pass Raster. */
	FGraphTestPass& Renders(
		const std::string& Texture, ERenderTargetLoadAction Load = ERenderTargetLoadAction::ENoAction, int32 Slot = 0);
	FGraphTestPass& RendersDepth(const std::string& Texture, FExclusiveDepthStencil Access);
	/** In place of Compute (or Raster where there are targets). */
	FGraphTestPass& Flags(ERDGPassFlags InFlags);
	FGraphTestPass& AddFlags(ERDGPassFlags InFlags);
	FGraphTestPass& Value(float InValue);
	/** In place of writing. */
	FGraphTestPass& Does(std::function<void(FRHICommandListImmediate&)> InWork);
	/** Where AddPass returned it. */
	FGraphTestPass& Into(FRDGPassRef& Out);

private:
	FGraphTest& Graph;
	std::string Name;
	FGraphTestRasterParameters* Parameters;
	int32 NumTextures = 0;
	int32 NumSRVs = 0;
	int32 NumUAVs = 0;
	bool bRaster = false;
	bool bFlagsGiven = false;
	ERDGPassFlags PassFlags = ERDGPassFlags::None;
	float PassValue = 1.0f;
	std::function<void(FRHICommandListImmediate&)> OwnWork;
	FRDGPassRef* OutPass = nullptr;
};

class FGraphTest
{
public:
	explicit FGraphTest(const char* Name = "Test")
		: Builder(std::make_unique<FRDGBuilder>(
			  FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("%s", Name)))
	{
	}

	/** A graph that a test leaves undone is dropped. */
	~FGraphTest()
	{
		if (Builder)
		{
			Builder->Discard();
		}
	}

	FGraphTestPass Pass(const std::string& Name) { return FGraphTestPass(*this, Name); }

	static FRDGTextureDesc MakeDesc(int32 NumMips = 1, int32 Size = 4)
	{
		return FRDGTextureDesc::Create2D(FIntPoint(Size, Size), PF_R32_FLOAT,
			FClearValueBinding(FLinearColor(0.25f, 0, 0, 0)),
			TexCreate_ShaderResource | TexCreate_UAV | TexCreate_RenderTargetable, uint8(NumMips));
	}

	/** The texture of that name; created when there is none. */
	FRDGTextureRef Texture(const std::string& Name, int32 NumMips = 1) { return Texture(Name, MakeDesc(NumMips)); }

	FRDGTextureRef Texture(const std::string& Name, const FRDGTextureDesc& Desc)
	{
		FRDGTextureRef& Found = Textures[Name];
		if (!Found)
		{
			Found = Builder->CreateTexture(Desc, KeepName(Name));
		}
		return Found;
	}

	/** A texture from outside, filled with Value. */
	FRDGTextureRef External(
		const std::string& Name, float Value = 0.0f, ERDGTextureFlags Flags = ERDGTextureFlags::None)
	{
		const TRefCountPtr<FRHITexture> RHITexture(new FRHITexture(MakeDesc(), KeepName(Name)));
		RHITexture->Fill(FLinearColor(Value, 0, 0, 0));
		Pooled[Name] = CreateRenderTarget(RHITexture, KeepName(Name));
		return Textures[Name] = Builder->RegisterExternalTexture(Pooled[Name], KeepName(Name), Flags);
	}

	void Extract(const std::string& Name) { Builder->QueueTextureExtraction(Texture(Name), &Pooled[Name]); }

	/** Executes; the names of the passes that ran, in order. */
	std::string Run()
	{
		Builder->Execute();
		return Log;
	}

	/** The codes that Execute throws, in order: "2021 2040"; empty when it does not. */
	std::string RunForErrors()
	{
		try
		{
			Builder->Execute();
		}
		catch (const Drydock::FError& Error)
		{
			return GetCodes(Error);
		}
		return "";
	}

	static std::string GetCodes(const Drydock::FError& Error)
	{
		std::string Codes;
		for (const Drydock::FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			Codes += (Codes.empty() ? "" : " ") + std::to_string(Diagnostic.Code);
		}
		return Codes;
	}

	/** A texel's red of an extracted or external texture, after Run. */
	float Pixel(const std::string& Name, int32 X = 0, int32 Y = 0, int32 Mip = 0) const
	{
		return Pooled.at(Name)->GetRHI()->ReadTexel(X, Y, Mip).R;
	}

	/** Destroys the builder (it must be executed or discarded). */
	void End() { Builder.reset(); }

	const TCHAR* KeepName(const std::string& Name) { return Names.insert({Name, Name}).first->second.c_str(); }

	std::map<std::string, std::string> Names; // before the builder: it keeps pointers to them
	std::map<std::string, TRefCountPtr<IPooledRenderTarget>> Pooled;
	std::map<std::string, FRDGTextureRef> Textures;
	std::map<std::string, FRDGTextureUAVRef> SkipBarrierViews;
	std::string Log;
	std::unique_ptr<FRDGBuilder> Builder;
};

inline FGraphTestPass::FGraphTestPass(FGraphTest& InGraph, const std::string& InName)
	: Graph(InGraph)
	, Name(InName)
	, Parameters(InGraph.Builder->AllocParameters<FGraphTestRasterParameters>())
{
}

inline FGraphTestPass& FGraphTestPass::Reads(const std::string& Texture)
{
	Parameters->Common.Textures[NumTextures++] = Graph.Texture(Texture);
	return *this;
}

inline FGraphTestPass& FGraphTestPass::ReadsMip(const std::string& Texture, int32 Mip)
{
	Parameters->Common.SRVs[NumSRVs++] =
		Graph.Builder->CreateSRV(FRDGTextureSRVDesc::CreateForMipLevel(Graph.Texture(Texture), Mip));
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Writes(const std::string& Texture, int32 Mip)
{
	Parameters->Common.UAVs[NumUAVs++] =
		Graph.Builder->CreateUAV(FRDGTextureUAVDesc(Graph.Texture(Texture), uint8(Mip)));
	return *this;
}

inline FGraphTestPass& FGraphTestPass::WritesBySkipBarrierView(const std::string& Texture)
{
	FRDGTextureUAVRef& View = Graph.SkipBarrierViews[Texture];
	View = View ? View : Graph.Builder->CreateUAV(Graph.Texture(Texture), ERDGUnorderedAccessViewFlags::SkipBarrier);
	Parameters->Common.UAVs[NumUAVs++] = View;
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Accesses(const std::string& Texture, ERHIAccess Access)
{
	Parameters->Common.Accesses.Add(FRDGTextureAccess(Graph.Texture(Texture), Access));
	return *this;
}

inline FGraphTestPass& FGraphTestPass::AccessesBuffer(FRDGBufferRef Buffer, ERHIAccess Access)
{
	Parameters->Common.BufferAccesses.Add(FRDGBufferAccess(Buffer, Access));
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Renders(const std::string& Texture, ERenderTargetLoadAction Load, int32 Slot)
{
	bRaster = true;
	Parameters->RenderTargets[uint32(Slot)] = FRenderTargetBinding(Graph.Texture(Texture), Load);
	return *this;
}

inline FGraphTestPass& FGraphTestPass::RendersDepth(const std::string& Texture, FExclusiveDepthStencil Access)
{
	bRaster = true;
	Parameters->RenderTargets.DepthStencil = FDepthStencilBinding(
		Graph.Texture(Texture), ERenderTargetLoadAction::EClear, ERenderTargetLoadAction::EClear, Access);
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Flags(ERDGPassFlags InFlags)
{
	bFlagsGiven = true;
	PassFlags = InFlags;
	return *this;
}

inline FGraphTestPass& FGraphTestPass::AddFlags(ERDGPassFlags InFlags)
{
	PassFlags |= InFlags;
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Value(float InValue)
{
	PassValue = InValue;
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Does(std::function<void(FRHICommandListImmediate&)> InWork)
{
	OwnWork = std::move(InWork);
	return *this;
}

inline FGraphTestPass& FGraphTestPass::Into(FRDGPassRef& Out)
{
	OutPass = &Out;
	return *this;
}

inline FGraphTestPass::~FGraphTestPass() noexcept(false)
{
	PassFlags |= bFlagsGiven ? ERDGPassFlags::None : bRaster ? ERDGPassFlags::Raster : ERDGPassFlags::Compute;
	FGraphTest& TestGraph = Graph;
	const std::string PassName = Name;
	FGraphTestRasterParameters* const PassParameters = Parameters;
	const float OwnValue = PassValue;
	const auto Lambda = [&TestGraph, PassName, PassParameters, OwnValue, Own = OwnWork](
							FRHICommandListImmediate& RHICmdList)
	{
		TestGraph.Log += (TestGraph.Log.empty() ? "" : " ") + PassName;
		if (Own)
		{
			Own(RHICmdList);
			return;
		}
		FLinearColor Result(OwnValue, 0, 0, 0);
		for (FRDGTexture* Texture : PassParameters->Common.Textures)
		{
			Result.R += Texture ? Texture->GetRHI()->ReadTexel(0, 0).R : 0.0f;
		}
		for (FRDGTextureSRV* View : PassParameters->Common.SRVs)
		{
			Result.R += View ? View->GetRHI()->GetTexture()->ReadTexel(0, 0, View->Desc.MipLevel).R : 0.0f;
		}
		const auto Fill = [&Result](FRHITexture* Texture, int32 Mip)
		{
			const FIntVector Size = Texture->GetMipDimensions(uint8(Mip));
			for (int32 Y = 0; Y < Size.Y; ++Y)
			{
				for (int32 X = 0; X < Size.X; ++X)
				{
					Texture->WriteTexel(X, Y, Result, Mip);
				}
			}
		};
		for (FRDGTextureUAV* View : PassParameters->Common.UAVs)
		{
			if (View)
			{
				Fill(View->GetRHI()->GetTexture(), View->Desc.MipLevel);
			}
		}
		PassParameters->RenderTargets.Enumerate(
			[&](const FRenderTargetBinding& Binding) { Fill(Binding.GetTexture()->GetRHI(), Binding.GetMipIndex()); });
		for (const FRDGTextureAccess& Access : PassParameters->Common.Accesses)
		{
			if (IsWritableAccess(Access.GetAccess()))
			{
				Fill(Access->GetRHI(), 0);
			}
		}
	};
	FRDGPassRef Pass =
		bRaster ? Graph.Builder->AddPass(RDG_EVENT_NAME("%s", Name.c_str()), Parameters, PassFlags, Lambda)
				: Graph.Builder->AddPass(RDG_EVENT_NAME("%s", Name.c_str()), &Parameters->Common, PassFlags, Lambda);
	if (OutPass)
	{
		*OutPass = Pass;
	}
}

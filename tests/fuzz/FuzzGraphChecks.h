// Plugin-like calls on the render graph, decoded from bytes: whatever is called in whatever order, with null, garbage
// and left-over pointers, it ends in a run or in messages. Used by the fuzzer, and by a test that runs its corpus.
#pragma once

#include "fuzz/FuzzGraphResources.h"

#include "CodeScope.h"
#include "HAL/ConsoleVariableTools.h"

#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

/** Decodes calls and makes them: first a byte of modes, then for each call its number and what it is called with. */
class FGraphCalls : private FGraphResources
{
public:
	using FGraphResources::FGraphResources;

	~FGraphCalls()
	{
		if (Builder)
		{
			Builder->Discard();
		}
	}

	/** What does not hold, or nothing. */
	std::string Run()
	{
		const uint8 Modes = Byte();
		Switch("r.RDG.ImmediateMode", 0, Modes & 1);
		Switch("r.RDG.ClobberResources", 0, (Modes >> 1) & 3);
		Switch("r.RDG.CullPasses", 1, (Modes & 8) != 0 ? 0 : 1);
		Switch("r.RDG.TransientAllocator", 1, (Modes & 16) != 0 ? 0 : 1);
		Switch("r.RDG.AsyncCompute", 1, (Modes & 32) != 0 ? 0 : 1);
		Begin();
		// As in a frame: what a hook lets out ends the hook and the run, unless the hook has caught it.
		for (int NumCalls = 0; Problem.empty() && !IsAtEnd() && NumCalls < MaxCalls; ++NumCalls)
		{
			const uint8 Call = Byte();
			Try([&] { CallCode(Hook, [&] { Make(Call); }); });
		}
		Try([&] { Builder->Execute(); });
		Builder->Discard();
		Builder.reset();
		return Problem;
	}

private:
	static constexpr int MaxCalls = 24;

	/** For this run; the default costs nothing. */
	void Switch(const char* Name, int32 Default, int32 Value)
	{
		if (Value != Default)
		{
			Switches.push_back(std::make_unique<FScopedConsoleVariable>(Name, Value));
		}
	}

	template<typename TFunction>
	void Try(TFunction Function)
	{
		try
		{
			Function();
		}
		catch (const FError& Error)
		{
			for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
			{
				if (Diagnostic.Code < 2001 || Diagnostic.Code > 2999 || Diagnostic.Message.empty())
				{
					Problem = "a message without number or sentence: " + Diagnostic.ToString();
				}
			}
		}
		catch (const std::exception& Exception)
		{
			Problem = std::string("an exception: ") + Exception.what();
		}
	}

	void Begin()
	{
		Builder.reset();
		Builder.emplace(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Fuzz"));
	}

	/** What a pass does when it runs: some of it is not declared, or not what its kind of pass may do. */
	void Work(FRHICommandListImmediate& RHICmdList, const FFuzzParameters* Parameters, uint8 What, FRDGTextureRef Other)
	{
		if ((What & 1) != 0 && Parameters->UAVs[0])
		{
			RHICmdList.ClearUAVFloat(Parameters->UAVs[0]->GetRHI(), FVector4f(1.0f, 2.0f, 3.0f, 4.0f));
		}
		if ((What & 2) != 0 && Parameters->BufferUAV)
		{
			RHICmdList.ClearUAVUint(Parameters->BufferUAV->GetRHI(), FUintVector4(1, 2, 3, 4));
		}
		if ((What & 4) != 0 && Parameters->SRV)
		{
			Parameters->SRV->GetRHI();
		}
		if ((What & 8) != 0 && Other)
		{
			Other->GetRHI();
		}
		if ((What & 16) != 0 && Parameters->Textures[0] && Parameters->Textures[1])
		{
			RHICmdList.CopyTexture(Parameters->Textures[0]->GetRHI(), Parameters->Textures[1]->GetRHI(), {});
		}
		if ((What & 32) != 0)
		{
			RHICmdList.DrawPrimitive(0, 1, 1);
		}
		if ((What & 64) != 0)
		{
			throw What;
		}
		if ((What & 128) != 0 && Parameters->BufferSRV)
		{
			Parameters->BufferSRV->GetRHI()->GetKernelBuffer();
		}
	}

	void AddComputePass()
	{
		FFuzzParameters* const Parameters = Builder->AllocParameters<FFuzzParameters>();
		Fill(*Parameters);
		const ERDGPassFlags Flags = MakePassFlags(ERDGPassFlags::Compute);
		const uint8 What = Byte();
		const FRDGTextureRef Other = Textures.empty() ? nullptr : FindAlive(Textures.back());
		Passes.push_back(Builder->AddPass(RDG_EVENT_NAME("Compute"), What == 251 ? nullptr : Parameters, Flags,
			[this, Parameters, What, Other](FRHICommandListImmediate& RHICmdList)
			{ Work(RHICmdList, Parameters, What, Other); }));
	}

	void AddRasterPass()
	{
		FFuzzRasterParameters* const Parameters = Builder->AllocParameters<FFuzzRasterParameters>();
		Fill(Parameters->Common);
		const uint8 Targets = Byte();
		for (int32 Slot = 0; Slot < 2; ++Slot)
		{
			if ((Targets & (1 << Slot)) != 0)
			{
				FRDGTexture* const Resolve = (Targets & 4) != 0 ? Pick(Textures) : nullptr;
				const auto Load = ERenderTargetLoadAction(Byte() % 3);
				Parameters->RenderTargets[Slot] =
					FRenderTargetBinding(Pick(Textures), Resolve, Load, uint8(Number()), int16(Number()));
			}
		}
		if ((Targets & 8) != 0)
		{
			const uint8 Actions = Byte();
			Parameters->RenderTargets.DepthStencil =
				FDepthStencilBinding(Pick(Textures), ERenderTargetLoadAction(Actions % 3),
					ERenderTargetLoadAction((Actions >> 2) % 3), FExclusiveDepthStencil::Type((Actions >> 4) & 0x3));
		}
		if ((Targets & 16) != 0)
		{
			Parameters->RenderTargets.ShadingRateTexture = Pick(Textures);
		}
		const ERDGPassFlags Flags = MakePassFlags(ERDGPassFlags::Raster);
		const uint8 What = Byte();
		Passes.push_back(Builder->AddPass(RDG_EVENT_NAME("Raster"), Parameters, Flags,
			[this, Parameters, What](FRHICommandListImmediate& RHICmdList)
			{ Work(RHICmdList, &Parameters->Common, What, nullptr); }));
	}

	/** The lambda may look into it only while its graph is there. */
	FRDGTextureRef FindAlive(FRDGTextureRef Texture) const { return AliveFrom < Textures.size() ? Texture : nullptr; }

	void SetAccess(uint8 Kind)
	{
		switch (Kind & 7)
		{
		case 0:
			Builder->SetTextureAccessFinal(Pick(Textures), MakeAccess());
			break;
		case 1:
			Builder->SetBufferAccessFinal(Pick(Buffers), MakeAccess());
			break;
		case 2:
			Builder->UseExternalAccessMode(Pick(Textures), MakeAccess());
			break;
		case 3:
			Builder->UseInternalAccessMode(Pick(Textures));
			break;
		case 4:
			Builder->UseExternalAccessMode(Pick(Buffers), MakeAccess());
			break;
		case 5:
			Builder->RemoveUnusedTextureWarning(Pick(Textures));
			break;
		case 6:
			Builder->AddPassDependency(Pick(Passes), Pick(Passes));
			break;
		default:
			Builder->SetPassWorkload(Pick(Passes), 3);
			break;
		}
	}

	void Clear(uint8 Kind)
	{
		switch (Kind & 7)
		{
		case 0:
			AddClearRenderTargetPass(*Builder, Pick(Textures));
			break;
		case 1:
			AddClearRenderTargetPass(*Builder, Pick(Textures), FLinearColor::Red);
			break;
		case 2:
			AddClearRenderTargetPass(
				*Builder, Pick(Textures), FLinearColor::Red, FIntRect(Number(), Number(), Number(), Number()));
			break;
		case 3:
			AddClearDepthStencilPass(*Builder, Pick(Textures), (Kind & 8) != 0, 0.5f, (Kind & 16) != 0, 7);
			break;
		case 4:
			AddClearUAVPass(*Builder, Pick(UAVs), FVector4f(1.0f, 2.0f, 3.0f, 4.0f));
			break;
		case 5:
			AddClearUAVPass(*Builder, Pick(UAVs), FUintVector4(1, 2, 3, 4));
			break;
		case 6:
			AddClearUAVPass(*Builder, Pick(BufferUAVs), 7u);
			break;
		default:
			AddClearUAVFloatPass(*Builder, Pick(BufferUAVs), 7.0f);
			break;
		}
	}

	void Copy(uint8 Kind)
	{
		if ((Kind & 1) != 0)
		{
			AddCopyTexturePass(*Builder, Pick(Textures), Pick(Textures), MakeCopyInfo());
		}
		else if ((Kind & 2) != 0)
		{
			const FIntPoint From(Number(), Number());
			const FIntPoint To(Number(), Number());
			AddCopyTexturePass(*Builder, Pick(Textures), Pick(Textures), From, To, FIntPoint(Number(), Number()));
		}
		else if ((Kind & 4) != 0)
		{
			AddCopyBufferPass(
				*Builder, Pick(Buffers), uint64(Number()), Pick(Buffers), uint64(Number()), uint64(Number()));
		}
		else
		{
			AddCopyBufferPass(*Builder, Pick(Buffers), Pick(Buffers));
		}
	}

	/** What a plugin keeps beyond the end of a graph points nowhere in the next one. */
	void BeginAnother(uint8 Kind)
	{
		Try(
			[&]
			{
				if ((Kind & 2) != 0)
				{
					Builder->Compile();
				}
				if ((Kind & 1) == 0)
				{
					Builder->Execute();
				}
			});
		// Now and then calls go on after the end.
		if ((Kind & 28) != 4)
		{
			Builder->Discard();
			Begin();
			AliveFrom = Textures.size();
		}
	}

	void Make(uint8 Call)
	{
		switch (Call % 20)
		{
		case 0:
		case 1:
		{
			const bool bSkipTracking = Byte() == 250;
			Textures.push_back(Builder->CreateTexture(MakeTextureDesc(), TEXT("Texture"),
				bSkipTracking ? ERDGTextureFlags::SkipTracking : ERDGTextureFlags::None));
			break;
		}
		case 2:
			MakeBuffer();
			break;
		case 3:
		case 4:
		case 5:
			MakeView(Byte());
			break;
		case 6:
		case 7:
		case 8:
			AddComputePass();
			break;
		case 9:
		case 10:
			AddRasterPass();
			break;
		case 11:
			Passes.push_back(Builder->AddPass(
				RDG_EVENT_NAME("Bare"), MakePassFlags(ERDGPassFlags::None), [](FRHICommandListImmediate&) {}));
			break;
		case 12:
			Copy(Byte());
			break;
		case 13:
			Clear(Byte());
			break;
		case 14:
		{
			static const uint8 Bytes[64] = {};
			const uint8 Given = Byte();
			Builder->QueueBufferUpload(Pick(Buffers), Given == 255 ? nullptr : Bytes, Given % 65);
			break;
		}
		case 15:
			TakeOut(Byte());
			break;
		case 16:
			Register(Byte());
			break;
		case 17:
			SetAccess(Byte());
			break;
		case 18:
		{
			const uint8 Kind = Byte();
			if ((Kind & 3) == 0)
			{
				Builder->BeginEventScope(RDG_EVENT_NAME("Scope"));
			}
			else if ((Kind & 3) == 1)
			{
				Builder->EndEventScope();
			}
			else if ((Kind & 3) == 2)
			{
				auto* const Contents = Builder->AllocParameters<FFuzzUniforms>();
				Contents->SceneColor = Pick(Textures);
				Contents->SceneDepth = Pick(SRVs);
				Uniforms.push_back(Builder->CreateUniformBuffer((Kind & 4) != 0 ? nullptr : Contents));
			}
			else
			{
				FScreenPassTexture Input;
				Input.Texture = Pick(Textures);
				FScreenPassRenderTarget::CreateFromInput(
					*Builder, Input, ERenderTargetLoadAction::ENoAction, TEXT("Output"));
			}
			break;
		}
		default:
			BeginAnother(Byte());
			break;
		}
	}

	std::string Problem;
	const FCodeOwner Hook{.Plugin = "libFuzz.so", .Callback = "hook"};
	std::vector<std::unique_ptr<FScopedConsoleVariable>> Switches;
};

/** What does not hold for the calls that the bytes mean, or nothing. */
inline std::string CheckGraphCalls(const uint8_t* Data, size_t Size)
{
	const FEnsureHandler Before = SetEnsureHandler([](const std::string&) {});
	std::string Problem = FGraphCalls(Data, Size).Run();
	SetEnsureHandler(Before);
	return Problem;
}

} // namespace Drydock
